// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "grammar/catalogue.hpp"

#include <string>
#include <string_view>
#include <vector>

/// The canonical form of single lines, for format.cpp.
namespace spricka::grammar {

/// A header, line by line where it is continued: what is open at the end of one line goes on in the
/// next.
class HeaderFormatter {
public:
  explicit HeaderFormatter(const CardSpec* spec) : spec_(spec) {}

  /// `code` without its & and comment.
  std::string format_header_line(std::string_view code);

private:
  std::string token(std::string_view text);
  std::string word(std::string_view text);

  const CardSpec* spec_; ///< null for a card that is not known
  const KeySpec* key_ = nullptr;
  bool value_ = false; ///< behind = or a comma
  int depth_ = 0;      ///< open brackets
};

/// A data line that is no table's: spacing stays, words of the language become capitals.
class DataLineCapitaliser {
public:
  explicit DataLineCapitaliser(const CardSpec& spec);

  /// `code` without its & and comment.
  std::string format_data_line(std::string_view code);

private:
  [[nodiscard]] bool is_word(const std::string& upper, bool called) const;

  std::vector<std::string> words_;
  bool check_ = false;      ///< lines of $CHECK: results are written as calls
  bool everywhere_ = false; ///< the words may stand in any field, else in the first
  bool first_ = true;
  int depth_ = 0;
};

} // namespace spricka::grammar
