// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace spricka::report {
namespace {

constexpr std::string_view gap = "  ";

std::vector<std::size_t> widths(const ReportTable& table) {
  std::vector<std::size_t> width;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::size_t w = std::max(table.columns[c].name.size(), table.columns[c].unit.size());
    for (const std::vector<std::string>& row : table.rows) {
      assert(row.size() == table.columns.size());
      w = std::max(w, row[c].size());
    }
    width.push_back(w);
  }
  return width;
}

void append_cell(std::string& line, std::string_view text, std::size_t width, bool words) {
  line += gap;
  line += words ? fmt::format("{:<{}}", text, width) : fmt::format("{:>{}}", text, width);
}

void append_line(std::string& out, std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  (out += line) += '\n';
}

} // namespace

std::string table_to_text(const ReportTable& table) {
  const std::vector<std::size_t> width = widths(table);
  std::string names;
  std::string units;
  for (std::size_t c = 0; c < width.size(); ++c) {
    append_cell(names, table.columns[c].name, width[c], table.columns[c].words);
    append_cell(units, table.columns[c].unit, width[c], table.columns[c].words);
  }
  std::string out = table.title.empty() ? std::string() : table.title + "\n";
  append_line(out, names);
  if (units.find_first_not_of(' ') != std::string::npos) {
    append_line(out, units);
  }
  for (const std::vector<std::string>& row : table.rows) {
    std::string line;
    for (std::size_t c = 0; c < width.size(); ++c) {
      append_cell(line, row[c], width[c], table.columns[c].words);
    }
    append_line(out, line);
  }
  return out;
}

std::string to_text_after_blank_line(const ReportTable& table) {
  return table.rows.empty() ? std::string() : "\n" + table_to_text(table);
}

ReportTable without_title(ReportTable table) {
  table.title.clear();
  return table;
}

std::string format_six_digits(double value) {
  return fmt::format("{:.6g}", value);
}

std::string six_digits_or_zero(double value, double scale) {
  return std::abs(value) < 1e-9 * scale ? "0" : format_six_digits(value);
}

std::string escape_xml(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    default:
      out += c;
    }
  }
  return out;
}

std::string typeset_unit(std::string_view unit) {
  std::string out;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const std::string_view rest = unit.substr(i);
    if (unit[i] == '*') {
      // The root belongs in front of the name it is taken of.
      const std::size_t end = rest.find("^0.5");
      if (end != std::string_view::npos && rest.find('*', 1) >= end) {
        out += " √";
        out += rest.substr(1, end - 1);
        i += end + 3;
      } else {
        out += " ";
      }
    } else if (rest.starts_with("^2")) {
      out += "²";
      ++i;
    } else {
      out += unit[i];
    }
  }
  return out;
}

std::string table_to_html(const ReportTable& table) {
  std::string out = "<table>\n";
  if (!table.title.empty()) {
    out += fmt::format("<caption>{}</caption>\n", escape_xml(table.title));
  }
  out += "<thead><tr>";
  for (const ReportTable::ReportColumn& column : table.columns) {
    out += fmt::format("<th{}>{}", column.words ? " class=\"w\"" : "", escape_xml(column.name));
    if (!column.unit.empty()) {
      out += fmt::format("<br><span>{}</span>", escape_xml(typeset_unit(column.unit)));
    }
    out += "</th>";
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    out += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      out += fmt::format("<td{}>{}</td>", table.columns[c].words ? " class=\"w\"" : "",
                         escape_xml(row[c]));
    }
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n";
}

} // namespace spricka::report
