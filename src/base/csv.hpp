// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <concepts>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

/// Tables of comma-separated values (RFC 4180), written and read.
namespace spricka::base {

/// A text as a field: with commas or quotes it stands in quotes, line ends become blanks, and one
/// that a spreadsheet would take for a formula begins with an apostrophe.
std::string quote_csv_field(std::string_view text);

/// A field from whatever it holds: words as quote_csv_field(), numbers as the shortest that reads
/// back to the same bits; empty where a number is not finite or not there.
struct CsvField {
  std::string text;

  CsvField(const std::string& words) : text(quote_csv_field(words)) {}
  CsvField(const char* words) : text(quote_csv_field(words)) {}
  CsvField(double value) : text(std::isfinite(value) ? fmt::format("{}", value) : "") {}
  template <std::integral Whole> CsvField(Whole value) : text(fmt::format("{:d}", value)) {}
  template <class T>
  CsvField(const std::optional<T>& value) : text(value ? CsvField(*value).text : "") {}
};

/// Fields by the names of their columns.
using CsvRow = std::vector<std::pair<std::string_view, CsvField>>;

/// A table that is filled row by row.
class CsvTable {
public:
  /// `columns`: their names, divided by commas; `remark`: the line in front of them, or empty.
  explicit CsvTable(std::string_view columns, const std::string& remark = {});

  /// Adds a row of the fields of both; columns that neither has stay empty.
  void add_row(const CsvRow& row, const CsvRow& more = {});

  /// The table with its header, a line for each row.
  [[nodiscard]] const std::string& text() const { return text_; }

private:
  std::vector<std::string> columns_;
  std::string text_;
};

/// A row that was read, by the names of its columns.
struct CsvRecord {
  std::map<std::string, std::string> fields;

  /// The field; empty where there is no such column.
  [[nodiscard]] std::string text(const std::string& column) const;
  /// The number that it begins with, else `none`.
  [[nodiscard]] double number(const std::string& column, double none) const;
};

/// The rows below the first, which names the columns; lines that begin with # are left out.
std::vector<CsvRecord> parse_csv_records(std::string_view text);

/// The rows of such a text, the names of its columns first; lines that begin with # are left out.
std::vector<std::vector<std::string>> parse_csv_rows(std::string_view text);

} // namespace spricka::base
