// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/plot.hpp"
#include "report/page.hpp"

#include <cstddef>
#include <string>

/// What the pages and tables of studies and ladders have in common.
namespace spricka::program {

/// A part as per cent with two digits, "0.023 %"; "-" where it is not finite.
std::string percent(double part);
/// The same as a bare number, for columns of per cent.
std::string percent_number(double part);

/// Memory as tables have it [MiB], of bytes.
std::string mebibytes(std::size_t bytes);

/// A plot against CPU time or freedoms with both axes logarithmic.
report::Plot cost_plot(const std::string& label, const std::string& x_name,
                       const std::string& y_name);

/// A dashed line across a plot at the height `level`.
report::PlotSeries horizontal_line_series(const std::string& name, double low, double high,
                                          double level);

/// Begins a page with the deck's title, or without one the name of the command, and what it is
/// about, a sentence without its point. The title.
std::string begin_titled_page(report::HtmlPage& page, const model::Model& model,
                              const char* command, const std::string& about);

} // namespace spricka::program
