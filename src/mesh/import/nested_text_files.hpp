// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace spricka::mesh {

/// A line of an input file or of one that it includes.
struct InpLocation {
  std::uint32_t file = 0;
  std::uint32_t line = 0; ///< from 1
};

/// The lines of a file and of those that it includes, in the order in which they count.
class NestedTextFiles {
public:
  using Complain = std::function<void(InpLocation, std::string)>;

  /// `statement` is the word that includes a file. Complaints: files that cannot be read, that
  /// include themselves, are nested too deep or are too many.
  NestedTextFiles(const std::filesystem::path& file, std::string statement, Complain complain);

  /// Moves to the next line; false at the end of all files.
  bool next_line();
  /// The line without its end; it holds until the next one is asked for.
  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] InpLocation location() const { return place_; }
  /// Goes on with the lines of another file, whose path counts from that of `from`.
  void include(const std::string& path, InpLocation from);
  /// All of the first file, before its lines are read.
  [[nodiscard]] std::string_view first_text() const {
    return files_.empty() ? std::string_view() : std::string_view(files_.front().text);
  }
  /// What is left of all files is not read.
  void close() { open_.clear(); }
  /// Paths of the files met so far, as places count them.
  [[nodiscard]] std::vector<std::string> file_paths() const;

private:
  struct TextFile {
    std::filesystem::path path;
    std::string text;
    std::size_t at = 0;
    std::uint32_t line = 0;
  };

  void open(const std::filesystem::path& path, InpLocation from);

  std::string statement_;
  Complain complain_;
  std::deque<TextFile> files_;
  std::vector<std::uint32_t> open_;
  std::size_t bytes_ = 0; ///< of all files so far
  std::string_view line_;
  InpLocation place_;
};

} // namespace spricka::mesh
