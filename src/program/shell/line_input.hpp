// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace spricka::program {

/// Lines from a terminal, with editing, history and completion by GNU readline. While it lives
/// Ctrl-C clears the line being typed, or asks a computation to stop. One at a time.
class LineEditor {
public:
  LineEditor();
  ~LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;

  /// Candidates for the word that begins at `begin` of a line; none: names of files.
  using Complete =
      std::function<std::vector<std::string>(std::string_view line, std::size_t begin)>;
  /// Sets what finds the candidates of a word; the editor at hand uses it from the next line on.
  void set_completion_function(Complete complete);

  /// False at the end (Ctrl-D). Forgets Ctrl-C.
  bool read(const std::string& prompt, std::string& line);

  /// Whether Ctrl-C was pressed since the last line was read.
  static bool was_ctrl_c_pressed();

private:
  std::filesystem::path history_; ///< where lines are kept; empty: nowhere
  struct sigaction old_int_ {};
};

} // namespace spricka::program
