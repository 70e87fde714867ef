// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page.hpp"

#include "report/view/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace spricka::report {
namespace {

constexpr const char* style_sheet = R"(
body { font: 15px/1.45 Helvetica, Arial, 'Liberation Sans', sans-serif; color: #000;
  background: #fff; max-width: 1200px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.6em; margin: 0 0 .2em; }
h2 { font-size: 1.2em; margin: 2em 0 .6em; border-bottom: 1px solid #000; break-after: avoid; }
p.about { color: #333; margin: .2em 0; }
p.failed { font-weight: bold; color: #b00000; }
p.note { color: #222; font-size: .9em; max-width: 60em; margin: .3em 0 .6em; break-before: avoid; }
div.warnings { border-left: 4px solid #b00000; padding: .1em 0 .1em .8em; margin: .8em 0; }
div.warnings p { margin: .1em 0; }
div.warnings ul { margin: .2em 0; padding-left: 1.2em; max-width: 60em; }
section.answer { display: flex; flex-wrap: wrap; gap: 4px 24px; align-items: flex-start;
  margin: .5em 0 1em; break-inside: avoid; }
section.answer .joint { flex: 0 1 460px; min-width: 0; }
section.answer .joint svg { max-width: 100%; height: auto; }
section.answer .words { flex: 1 1 360px; min-width: 0; }
section.answer dl { display: grid; grid-template-columns: max-content 1fr; gap: .35em 1em;
  margin: .5em 0; }
section.answer dt { font-weight: bold; max-width: 9em; overflow-wrap: anywhere; }
section.answer dd { margin: 0; overflow-wrap: anywhere; }
section.answer dd.failed { font-weight: bold; color: #b00000; }
details { margin: .6em 0; }
summary { cursor: pointer; font-size: .9em; }
details table { font-size: .7em; }
details th, details td { padding-right: .7em; }
table { border-collapse: collapse; margin: 1em 0; font-size: .87em;
  font-variant-numeric: tabular-nums; border-bottom: 1.5px solid #000; }
caption { text-align: left; font-weight: bold; padding: .2em 0; break-after: avoid; }
thead { display: table-header-group; break-inside: avoid; break-after: avoid; border-top: 1.5px solid #000; border-bottom: 1px solid #000; }
tr { break-inside: avoid; }
tbody tr:nth-child(-n+2) { break-after: avoid; }
th { font-weight: bold; text-align: right; vertical-align: top; padding: .15em 1em .15em 0; }
th span { font-weight: normal; color: #333; }
td { text-align: right; padding: .1em 1em .1em 0; white-space: nowrap; }
th.w, td.w { text-align: left; }
td.w { white-space: normal; }
figure { margin: 1.2em 0 1.8em; break-inside: avoid; }
figure div { display: flex; flex-wrap: wrap; gap: 8px 14px; align-items: flex-start; }
figure svg { max-width: 100%; height: auto; }
figure > svg, figcaption { break-before: avoid; }
figcaption { font-size: .9em; color: #222; max-width: 60em; margin-top: .4em; }
pre { font-size: .8em; line-height: 1.3; overflow-x: auto; }
@media screen {
  table { display: block; width: fit-content; max-width: 100%; overflow-x: auto; }
}
@media screen and (max-width: 800px) {
  section > table, body > table { font-size: .8em; }
  th, td { padding-right: .6em; }
  figure { overflow-x: auto; }
  figure div { flex-wrap: nowrap; flex-direction: column; }
  figure svg { max-width: none; flex: none; }
  figcaption { position: sticky; left: 0; }
}
@media print {
  body { max-width: none; margin: 0; padding: 0; font-size: 11px; }
  .screen { display: none; }
  h2 { margin-top: 1.2em; }
  figure { margin: .8em 0 1em; }
  figure div { display: block; }
  figure div > svg { max-height: 9.5cm; }
  figure div.two > svg { width: 49%; }
  figure div.many > svg { width: 32.5%; }
}
)";

/// Of an element with one, else of any width.
double width_of(const std::string& drawing) {
  constexpr std::string_view mark = " width=\"";
  const std::size_t at = drawing.find(mark);
  double width = 0.0;
  if (drawing.starts_with("<svg") && at != std::string::npos) {
    std::from_chars(drawing.data() + at + mark.size(), drawing.data() + drawing.size(), width);
  }
  return width;
}

/// On paper drawings stand side by side where their text can be read so.
std::string class_of(const std::vector<std::string>& drawings) {
  double widest = 0.0;
  for (const std::string& drawing : drawings) {
    widest = std::max(widest, width_of(drawing));
  }
  if (drawings.size() > 2 && widest < 400.0) {
    return " class=\"many\"";
  }
  return drawings.size() > 1 && widest < 600.0 ? " class=\"two\"" : "";
}

} // namespace

void HtmlPage::add_heading(std::string_view words, std::string_view id) {
  const std::string mark = id.empty() ? std::string() : fmt::format(" id=\"{}\"", id);
  body_ += fmt::format("<h2{}>{}</h2>\n", mark, escape_xml(words));
}

void HtmlPage::add_paragraph(std::string_view words, std::string_view kind) {
  const std::string mark = kind.empty() ? std::string() : fmt::format(" class=\"{}\"", kind);
  body_ += fmt::format("<p{}>{}</p>\n", mark, escape_xml(words));
}

void HtmlPage::add_table(const ReportTable& table) {
  if (!table.rows.empty()) {
    body_ += table_to_html(table);
  }
}

void HtmlPage::add_folded_table(const ReportTable& table) {
  if (!table.rows.empty()) {
    body_ += fmt::format("<details><summary>{}</summary>\n", escape_xml(table.title));
    body_ += table_to_html(without_title(table)) + "</details>\n";
  }
}

void HtmlPage::add_figure(const Figure& figure) {
  body_ += fmt::format("<figure><div{}>\n", class_of(figure.drawings));
  for (const std::string& drawing : figure.drawings) {
    body_ += drawing;
  }
  body_ += "</div>" + figure.legend;
  body_ += fmt::format("<figcaption><b>Figure {}.</b> {}</figcaption></figure>\n", ++figures_,
                       escape_xml(figure.caption));
}

std::string HtmlPage::finish_page(const std::string& title) const {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}{}</body>\n</html>\n",
      escape_xml(title), style_sheet, body_, curve_script(body_));
}

} // namespace spricka::report
