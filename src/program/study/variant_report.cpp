// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/variant_report.hpp"

#include "model/model.hpp"

#include <cmath>

#include <fmt/format.h>

namespace spricka::program {

std::string percent(double part) {
  return percent_number(part) + (std::isfinite(part) ? " %" : "");
}

std::string percent_number(double part) {
  return std::isfinite(part) ? fmt::format("{:.2g}", 100.0 * part) : "-";
}

std::string mebibytes(std::size_t bytes) {
  return fmt::format("{:.0f}", static_cast<double>(bytes) / 1048576.0);
}

report::Plot empty_logarithmic_plot(const std::string& label, const std::string& x_name,
                                    const std::string& y_name) {
  report::Plot plot;
  plot.label = label;
  plot.x_name = x_name;
  plot.y_name = y_name;
  plot.log_x = true;
  plot.log_y = true;
  return plot;
}

report::PlotSeries horizontal_line_series(const std::string& name, double low, double high,
                                          double level) {
  report::PlotSeries line;
  line.name = name;
  line.colour = "#888";
  line.dash = "5 4";
  line.points = {{low, level}, {high, level}};
  return line;
}

std::string begin_titled_page(report::HtmlPage& page, const model::Model& model,
                              const char* command, const std::string& about) {
  std::string title = model.title.empty() ? fmt::format("spricka {}", command) : model.title;
  page.add_html(fmt::format("<h1>{}</h1>\n", report::escape_xml(title)));
  page.add_paragraph(fmt::format("{}. Computed by spricka {}.", about, SPRICKA_VERSION), "about");
  return title;
}

} // namespace spricka::program
