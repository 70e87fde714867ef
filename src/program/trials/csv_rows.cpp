// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/trials/csv_rows.hpp"

#include <algorithm>

namespace spricka::program {

namespace {

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += c;
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  return fields;
}

} // namespace

std::string csv_field(std::string_view text) {
  std::string line(text);
  std::ranges::replace(line, '\n', ' ');
  // Spreadsheets would compute a field that begins so; an apostrophe makes it a text.
  if (line.find_first_of("=+-@\t\r") == 0) {
    line.insert(line.begin(), '\'');
  }
  if (line.find_first_of(",\"") == std::string::npos) {
    return line;
  }
  std::string out = "\"";
  for (const char c : line) {
    out += c == '"' ? "\"\"" : std::string(1, c);
  }
  return out + "\"";
}

std::vector<std::vector<std::string>> csv_rows(std::string_view text) {
  std::vector<std::vector<std::string>> rows;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.front() != '#') {
      rows.push_back(fields_of(line));
    }
  }
  return rows;
}

} // namespace spricka::program
