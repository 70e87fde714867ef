// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/table.hpp"
#include "report/topics/figures.hpp"

#include <string>
#include <string_view>

namespace spricka::report {

/// Collects an HTML page in the report's style and numbers its figures.
class HtmlPage {
public:
  /// Adds HTML as it is, without escapes.
  void add_html(std::string_view html) { body_ += html; }
  /// `id`: where links of the page may lead; may be empty.
  void add_heading(std::string_view words, std::string_view id = "");
  /// Adds a paragraph of plain text, with escapes. `kind` is its class in the style sheet: "note",
  /// "about" or "failed"; may be empty.
  void add_paragraph(std::string_view words, std::string_view kind = "note");
  /// Tables without rows are left out.
  void add_table(const ReportTable& table);
  /// The same behind its title, which opens it.
  void add_folded_table(const ReportTable& table);
  /// Adds drawings with legend and caption under the next figure number.
  void add_figure(const Figure& figure);
  /// The whole HTML document with style sheet and title, and the script for its plots.
  [[nodiscard]] std::string finish_page(const std::string& title) const;

private:
  std::string body_;
  int figures_ = 0;
};

} // namespace spricka::report
