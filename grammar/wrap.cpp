// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/wrap.hpp"

#include <algorithm>

namespace spricka::grammar {

namespace {

constexpr std::size_t k_indent = 2;
constexpr std::size_t k_gap = 2;
constexpr std::size_t k_narrowest = 20;

// Length of the first line of `text`: as many whole words as fit, or one that does not.
std::size_t first_line(std::string_view text, std::size_t width) {
  if (text.size() <= width) {
    return text.size();
  }
  std::size_t fits = 0;
  for (std::size_t i = 0; i < text.size() && (i <= width || fits == 0); ++i) {
    if (text[i] == ' ') {
      fits = i;
    } else if (text[i] == '|' && i + 1 <= width) {
      fits = i + 1;
    }
  }
  return fits == 0 ? text.size() : fits;
}

std::string without_trailing_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

} // namespace

std::vector<std::string> wrap_text(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t length = first_line(text, width);
    lines.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  }
  return lines;
}

std::string wrap_paragraph(std::string_view text, std::size_t indent, std::size_t width) {
  std::string out;
  for (const std::string& line : wrap_text(text, std::max(width, indent + k_narrowest) - indent)) {
    out += std::string(indent, ' ') + line + '\n';
  }
  return out;
}

std::string TextColumns::format_columns(std::size_t width) const {
  std::vector<std::size_t> wide(most.size(), 0);
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      wide[c] = std::min(std::max(wide[c], row[c].size()), most[c]);
    }
  }
  std::size_t used = k_indent;
  for (std::size_t c = 0; c + 1 < wide.size(); ++c) {
    used += wide[c] + k_gap;
  }
  wide.back() = std::max(width, used + k_narrowest) - used;
  std::string out;
  for (const auto& row : rows) {
    std::vector<std::vector<std::string>> cells;
    std::size_t height = 1;
    for (std::size_t c = 0; c < row.size(); ++c) {
      cells.push_back(wrap_text(row[c], wide[c]));
      height = std::max(height, cells.back().size());
    }
    for (std::size_t l = 0; l < height; ++l) {
      std::string line(k_indent, ' ');
      for (std::size_t c = 0; c < cells.size(); ++c) {
        std::string cell = l < cells[c].size() ? cells[c][l] : std::string();
        cell.resize(std::max(cell.size(), wide[c]), ' ');
        line += cell + std::string(k_gap, ' ');
      }
      out += without_trailing_blanks(std::move(line)) + '\n';
    }
  }
  return out;
}

} // namespace spricka::grammar
