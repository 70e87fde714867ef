// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Text in columns, for the help on a terminal.
namespace spricka::grammar {

/// Breaks a text into lines of at most `width` bytes: at blanks, or behind | in lists of words.
std::vector<std::string> wrap_text(std::string_view text, std::size_t width);

/// A paragraph, wrapped and indented; ends with a line feed.
std::string wrap_paragraph(std::string_view text, std::size_t indent, std::size_t width);

/// Rows of cells under each other, two blanks apart and indented by two. A column is as wide as its
/// widest cell but at most `most` (the last one takes what is left of `width`); longer cells wrap.
struct TextColumns {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::size_t> most; ///< [column]

  /// The rows as text, cells wrapped to their columns; each line ends with a line feed.
  [[nodiscard]] std::string format_columns(std::size_t width) const;
};

} // namespace spricka::grammar
