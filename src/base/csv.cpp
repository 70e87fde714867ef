// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/csv.hpp"

#include <algorithm>
#include <charconv>

namespace spricka::base {

namespace {

std::vector<std::string> split_line(std::string_view line) {
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

std::string quote_csv_field(std::string_view text) {
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

CsvTable::CsvTable(std::string_view columns, const std::string& remark)
    : columns_(split_line(columns)),
      text_(fmt::format("{}{}{}\n", remark, remark.empty() ? "" : "\n", columns)) {}

void CsvTable::add_row(const CsvRow& row, const CsvRow& more) {
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    text_ += c == 0 ? "" : ",";
    for (const CsvRow* fields : {&row, &more}) {
      for (const auto& [name, field] : *fields) {
        text_ += name == columns_[c] ? field.text : "";
      }
    }
  }
  text_ += '\n';
}

std::vector<std::vector<std::string>> parse_csv_rows(std::string_view text) {
  std::vector<std::vector<std::string>> rows;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.front() != '#') {
      rows.push_back(split_line(line));
    }
  }
  return rows;
}

std::string CsvRecord::text(const std::string& column) const {
  const auto found = fields.find(column);
  return found == fields.end() ? std::string() : found->second;
}

double CsvRecord::number(const std::string& column, double none) const {
  const std::string field = text(column);
  std::from_chars(field.data(), field.data() + field.size(), none);
  return none;
}

std::vector<CsvRecord> parse_csv_records(std::string_view text) {
  const std::vector<std::vector<std::string>> rows = parse_csv_rows(text);
  std::vector<CsvRecord> records;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    CsvRecord& record = records.emplace_back();
    for (std::size_t c = 0; c < std::min(rows[0].size(), rows[r].size()); ++c) {
      record.fields.emplace(rows[0][c], rows[r][c]);
    }
  }
  return records;
}

} // namespace spricka::base
