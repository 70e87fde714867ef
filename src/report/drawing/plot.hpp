// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/measure_title.hpp"
#include "report/drawing/svg.hpp"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spricka::report {

/// Where a point has no error bar: K was computed there, its error was not.
inline constexpr double no_bar = std::numeric_limits<double>::quiet_NaN();

/// Points of one curve, or of marks without a line.
struct PlotSeries {
  std::string name; ///< in the legend; empty: not shown there
  std::vector<DrawingPoint> points;
  std::vector<double> bars; ///< half heights of error bars [point], or no_bar; empty: none
  std::string colour = "#000";
  std::string dash;
  bool joined = true;
  std::optional<MarkerShape> marker;
};

/// A line in the colour and with the dashes of these numbers.
PlotSeries styled_curve(std::string name, std::size_t colour, std::size_t dash);

/// Marks without a line, black.
PlotSeries marker_series(std::string name, MarkerShape shape);

/// Curves over one axis, their points in units of the deck or, where the title has none, as they
/// are. The y axis starts at 0 unless a
/// value lies below, or counts in powers of ten.
struct Plot {
  std::string label; ///< what it shows, in words
  MeasureTitle x_name;
  MeasureTitle y_name;
  std::vector<PlotSeries> series;
  bool legend_below = false; ///< else at the right
  bool log_x = false;        ///< logarithmic; values that are not positive are left out
  bool log_y = false;
};

/// The plot with its legend.
std::string draw_svg(const Plot& plot);

/// What a reader has to know of the error bars of K1 in these: most are too small to be seen, and
/// not every point of the curves that could have one has it. Empty without bars.
std::string error_bar_note(const std::vector<PlotSeries>& all);

/// Pressure round a bore. A curve runs in pieces: it is cut at crack mouths.
struct PolarCurve {
  std::string name;
  std::string colour = "#000";
  std::string dash;
  std::vector<std::vector<DrawingPoint>> pieces; ///< x: theta [rad], y: pressure
  bool tinted = false;                           ///< the area between curve and bore is tinted
};

struct PolarPlot {
  std::string title;
  base::OutputUnit unit; ///< of pressures, which are given in units of the deck
  std::vector<PolarCurve> curves;
  std::vector<double> mouths; ///< [rad]
  double low = 0.0;           ///< smallest and largest pressure that the scale shows
  double high = 1.0;
};

/// Pressure outward from a circle that stands for the bore; negative values point inward.
std::string draw_svg(const PolarPlot& plot);

/// The legend of several polar plots, in one row.
std::string draw_legend(const std::vector<PolarCurve>& curves);

} // namespace spricka::report
