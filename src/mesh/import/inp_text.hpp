// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/nested_text_files.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// A keyword line: blanks left out, upper case; values keep their case.
struct InpKeyword {
  std::string name;  ///< "SOLIDSECTION"
  std::string shown; ///< "SOLID SECTION"
  std::vector<std::pair<std::string, std::string>> parameters;
  InpLocation place;

  /// The value of a parameter, its name in upper case; null: the line does not give it.
  [[nodiscard]] const std::string* find(std::string_view key) const;
};

/// The lines of an Abaqus or CalculiX input file, includes followed: comments (**) and empty lines
/// left out, keyword lines joined with those they continue on.
class InpLineReader {
public:
  using Complain = std::function<void(InpLocation, std::string)>;

  /// Complaints: files that cannot be read or include themselves.
  InpLineReader(const std::filesystem::path& file, Complain complain);

  /// Moves to the next line; false at the end.
  bool next_line();
  [[nodiscard]] bool is_at_keyword() const { return line_[0] == '*'; }
  /// The keyword at this line. *INCLUDE is followed and never seen.
  [[nodiscard]] const InpKeyword& keyword() const { return keyword_; }
  /// A data line without the blanks at its ends.
  [[nodiscard]] std::string_view data_line() const { return line_; }
  [[nodiscard]] InpLocation location() const { return place_; }
  /// Paths of the files met so far, as places count them.
  [[nodiscard]] std::vector<std::string> file_paths() const { return files_.file_paths(); }

private:
  bool raw_line();
  void read_keyword();
  void include();

  Complain complain_;
  NestedTextFiles files_;
  std::string_view line_;
  InpLocation place_;
  InpKeyword keyword_;
};

/// Takes the comma-separated fields of a line one by one.
class InpFieldReader {
public:
  explicit InpFieldReader(std::string_view line) : rest_(line), more_(!line.empty()) {}

  [[nodiscard]] bool has_more() const { return more_; }
  /// The next field without blanks at its ends.
  std::string_view next_text();
  /// The next field as a number; empty if it is none. An empty field is 0.
  std::optional<double> next_real();
  std::optional<std::int64_t> next_integer();

private:
  std::string_view rest_;
  bool more_;
};

/// A whole number, if the text is one.
std::optional<std::int64_t> parse_inp_integer(std::string_view text);

} // namespace spricka::mesh
