// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace spricka::report {

/// A table of words and numbers already formatted; the listing and the HTML page show the same
/// ones. Columns of words stand to the left, of numbers to the right.
struct ReportTable {
  struct ReportColumn {
    std::string name;
    std::string unit; ///< as base::UnitSystem writes it; empty: none
    bool words = false;
  };
  std::string title;
  std::vector<ReportColumn> columns;
  std::vector<std::vector<std::string>> rows; ///< each as long as `columns`
};

/// The table with blanks between its columns, names and units above them, ended by a newline.
std::string table_to_text(const ReportTable& table);
/// The same behind an empty line; empty where the table has no rows.
std::string to_text_after_blank_line(const ReportTable& table);

/// The table as an HTML element, with units in print style.
std::string table_to_html(const ReportTable& table);

/// The table without its title, where a heading says enough.
ReportTable without_title(ReportTable table);

/// A unit in print: "MPa*mm^0.5" becomes "MPa √mm", "N/mm^2" "N/mm²".
std::string typeset_unit(std::string_view unit);

/// A number as tables have it.
std::string format_six_digits(double value);
/// The same, but 0 where nothing but round-off is left beside `scale`.
std::string six_digits_or_zero(double value, double scale);

/// Text with the characters that XML reserves replaced by entities.
std::string escape_xml(std::string_view text);

} // namespace spricka::report
