// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/plot.hpp"

#include "report/drawing/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace spricka::report {
namespace {

constexpr double least_left = 66.0;  // of the box
constexpr double title_room = 32.0;  // left of an axis' numbers
constexpr double letter_width = 6.8; // of a number
constexpr double box_top = 12.0;
constexpr double box_width = 400.0;
constexpr double box_height = 290.0;
constexpr double legend_gap = 18.0;
constexpr double line_height = 15.0;
constexpr double legend_width = 285.0;
constexpr std::size_t letters_beside = 28;
constexpr std::size_t letters_below = 48;

/// What an axis shows; of a logarithmic one the powers of ten.
struct AxisRange {
  double low = 0.0;
  double high = 0.0;
  bool log = false;
  double left = least_left; ///< of the horizontal one: where the box begins [px]
  [[nodiscard]] double on(double value) const { return log ? std::log10(value) : value; }
};

/// Both axes show 0: crack lengths and stress intensities are compared with it.
AxisRange range_of(const Plot& plot, double DrawingPoint::*member) {
  const bool upright = member == &DrawingPoint::y;
  AxisRange range;
  range.log = upright ? plot.log_y : plot.log_x;
  if (range.log) {
    range.low = std::numeric_limits<double>::max();
    range.high = std::numeric_limits<double>::lowest();
  }
  for (const PlotSeries& series : plot.series) {
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      const double at = series.points[i].*member;
      const bool barred = upright && i < series.bars.size() && std::isfinite(series.bars[i]);
      const double bar = barred ? series.bars[i] : 0.0;
      if (std::isfinite(range.on(at))) {
        range.low = std::min(range.low, range.log ? range.on(at) : at - bar);
        range.high = std::max(range.high, range.log ? range.on(at) : at + bar);
      }
    }
  }
  if (!(range.high > range.low)) {
    range.low = range.log && std::abs(range.low) < 300.0 ? range.low - 0.5 : 0.0;
    range.high = range.low + 1.0;
  }
  const double margin = 0.05 * (range.high - range.low);
  range.high += margin;
  range.low -= range.low < 0.0 || range.log ? margin : 0.0;
  return range;
}

DrawingPoint place(DrawingPoint p, const AxisRange& x, const AxisRange& y) {
  return {x.left + box_width * (x.on(p.x) - x.low) / (x.high - x.low),
          box_top + box_height * (y.high - y.on(p.y)) / (y.high - y.low)};
}

/// lead times ten to the power d: 0.02, 1000, 2·10⁷.
std::string decade_text(int lead, int d) {
  constexpr std::array<const char*, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (d > -4 && d < 5) {
    return fmt::format("{:.{}f}", lead * std::pow(10.0, d), std::max(0, -d));
  }
  std::string text = lead == 1 ? "10" : fmt::format("{}·10", lead);
  text += d < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(d))) {
    text += raised[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

/// Powers of ten, with 2 and 5 between them where there are few, or all digits within one.
std::vector<AxisTick> decade_ticks(const AxisRange& range) {
  std::vector<AxisTick> ticks;
  const auto first = static_cast<int>(std::floor(range.low));
  const auto last = static_cast<int>(std::ceil(range.high));
  const int skip = std::max(1, (last - first) / 8);
  for (int d = first; d <= last; d += skip) {
    for (const int lead : {1, 2, 3, 4, 5, 6, 7, 8, 9}) {
      const double value = lead * std::pow(10.0, d);
      const double decades = range.high - range.low;
      const bool wanted = lead == 1 || decades < 0.9 || (decades < 2.5 && (lead == 2 || lead == 5));
      if (wanted && std::log10(value) >= range.low && std::log10(value) <= range.high) {
        ticks.push_back({value, decade_text(lead, d)});
      }
    }
  }
  return ticks;
}

std::vector<AxisTick> ticks_of(const AxisRange& range, int wanted) {
  return range.log ? decade_ticks(range) : round_axis_ticks(range.low, range.high, wanted);
}

/// Of the longest number.
double width_of(const std::vector<AxisTick>& ticks) {
  std::ptrdiff_t letters = 0;
  for (const AxisTick& tick : ticks) {
    letters = std::max(letters, std::ranges::count_if(tick.text, [](char c) {
                         return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; // UTF-8
                       }));
  }
  return letter_width * static_cast<double>(letters);
}

/// Wide enough for the numbers of the upright axis and its title beside them.
double box_left(const AxisRange& y) {
  return std::max(least_left, title_room + width_of(ticks_of(y, 6)));
}

/// As many as stand side by side with a letter between them.
std::vector<AxisTick> ticks_side_by_side(const AxisRange& range) {
  std::vector<AxisTick> ticks;
  for (int wanted = 7; wanted > 1; --wanted) {
    ticks = ticks_of(range, wanted);
    const double room = box_width / static_cast<double>(std::max<std::size_t>(ticks.size(), 1));
    if (range.log || width_of(ticks) + letter_width <= room) {
      break;
    }
  }
  return ticks;
}

void draw_axes(SvgDrawing& svg, const Plot& plot, const AxisRange& x, const AxisRange& y) {
  const ShapeStyle grid{"#ddd", 0.7, "none", ""};
  const ShapeStyle axis{"#000", 0.9, "none", ""};
  const double bottom = box_top + box_height;
  for (const AxisTick& tick : ticks_side_by_side(x)) {
    const double at = place({tick.value, 1.0}, x, y).x;
    svg.line({at, box_top}, {at, bottom}, grid);
    svg.line({at, bottom}, {at, bottom - 5.0}, axis);
    svg.text({at, bottom + 16.0}, tick.text, {TextAnchor::middle});
  }
  for (const AxisTick& tick : ticks_of(y, 6)) {
    const double at = place({1.0, tick.value}, x, y).y;
    svg.line({x.left, at}, {x.left + box_width, at}, grid);
    svg.line({x.left, at}, {x.left + 5.0, at}, axis);
    svg.text({x.left - 7.0, at + 4.0}, tick.text, {TextAnchor::end});
  }
  svg.rectangle({x.left, box_top}, box_width, box_height, axis);
  svg.text({x.left + 0.5 * box_width, bottom + 36.0}, plot.x_name.text, {TextAnchor::middle, 13.0});
  svg.text({18.0, box_top + 0.5 * box_height}, plot.y_name.text,
           {TextAnchor::middle, 13.0, "#000", 90.0});
}

ShapeStyle line_style(const PlotSeries& series) {
  return {series.colour, 1.6, "none", series.dash};
}

void draw_marker(SvgDrawing& svg, const PlotSeries& series, DrawingPoint at) {
  const bool open = *series.marker == MarkerShape::plus || *series.marker == MarkerShape::cross;
  svg.marker(*series.marker, at, {series.colour, open ? 1.6 : 1.3, open ? "none" : "#fff", ""});
}

/// A vertical line with a foot at either end; shorter than a pixel it would not be seen.
void draw_bars(SvgDrawing& svg, const PlotSeries& series, const AxisRange& x, const AxisRange& y) {
  constexpr double foot = 3.0;
  const ShapeStyle style{series.colour, 1.1, "none", ""};
  for (std::size_t i = 0; i < series.bars.size(); ++i) {
    const DrawingPoint& p = series.points[i];
    if (!std::isfinite(series.bars[i]) || !std::isfinite(p.x) || !std::isfinite(p.y)) {
      continue;
    }
    const DrawingPoint top = place({p.x, p.y + series.bars[i]}, x, y);
    const DrawingPoint bottom = place({p.x, p.y - series.bars[i]}, x, y);
    if (bottom.y - top.y < 1.0) {
      continue;
    }
    svg.line(top, bottom, style);
    for (const DrawingPoint& end : {top, bottom}) {
      svg.line({end.x - foot, end.y}, {end.x + foot, end.y}, style);
    }
  }
}

void draw_series(SvgDrawing& svg, const PlotSeries& series, const AxisRange& x,
                 const AxisRange& y) {
  std::vector<DrawingPoint> points;
  for (const DrawingPoint& p : series.points) {
    const DrawingPoint at = place(p, x, y);
    if (std::isfinite(at.x) && std::isfinite(at.y)) {
      points.push_back(at);
    }
  }
  if (series.joined) {
    svg.polyline(points, line_style(series));
  }
  draw_bars(svg, series, x, y);
  if (series.marker) {
    for (const DrawingPoint& p : points) {
      draw_marker(svg, series, p);
    }
  }
}

/// What the pointer on a curve asks for: its name and the numbers of its points.
std::string curve_attributes(const PlotSeries& series) {
  std::string points;
  for (const DrawingPoint& p : series.points) {
    if (std::isfinite(p.x) && std::isfinite(p.y)) {
      points += fmt::format("{}{:.6g},{:.6g}", points.empty() ? "" : " ", p.x, p.y);
    }
  }
  return fmt::format(R"(class="curve" data-name="{}" data-points="{}")", escape_xml(series.name),
                     points);
}

/// The box of the axes and what they run from and to, of a logarithmic one in powers of ten.
std::string plot_attributes(const Plot& plot, const AxisRange& x, const AxisRange& y) {
  return fmt::format(
      R"(class="plot" data-box="{} {} {} {}" data-x="{} {} {:d}" data-y="{} {} {:d}" )"
      R"(data-x-name="{}" data-y-name="{}")",
      x.left, box_top, box_width, box_height, x.low, x.high, x.log, y.low, y.high, y.log,
      escape_xml(plot.x_name.text), escape_xml(plot.y_name.text));
}

/// Words in lines of at most `letters` bytes; a longer word stands alone.
std::vector<std::string> wrap(std::string_view words, std::size_t letters) {
  std::vector<std::string> lines{""};
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    const std::string_view word = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > letters) {
      lines.emplace_back();
    }
    (lines.back() += lines.back().empty() ? "" : " ") += word;
  }
  return lines;
}

/// Legend lines of all series: what stands there and how many lines each entry takes.
struct LegendEntry {
  const PlotSeries* series = nullptr;
  std::vector<std::string> lines;
};

std::vector<LegendEntry> legend_entries(const Plot& plot) {
  std::vector<LegendEntry> entries;
  for (const PlotSeries& series : plot.series) {
    if (!series.name.empty()) {
      entries.push_back(
          {&series, wrap(series.name, plot.legend_below ? letters_below : letters_beside)});
    }
  }
  return entries;
}

double legend_height(const std::vector<LegendEntry>& entries) {
  double height = 0.0;
  for (const LegendEntry& entry : entries) {
    height += line_height * static_cast<double>(entry.lines.size()) + 4.0;
  }
  return height;
}

void draw_legend(SvgDrawing& svg, const std::vector<LegendEntry>& entries, DrawingPoint corner) {
  double y = corner.y + 10.0;
  for (const LegendEntry& entry : entries) {
    const PlotSeries& series = *entry.series;
    if (series.joined) {
      svg.line({corner.x, y - 4.0}, {corner.x + 30.0, y - 4.0}, line_style(series));
    }
    if (series.marker) {
      draw_marker(svg, series, {corner.x + 15.0, y - 4.0});
    }
    for (const std::string& line : entry.lines) {
      svg.text({corner.x + 38.0, y}, line, {});
      y += line_height;
    }
    y += 4.0;
  }
}

Plot plot_in_output_units(Plot plot) {
  for (PlotSeries& series : plot.series) {
    for (DrawingPoint& point : series.points) {
      point = {plot.x_name.unit.from_deck(point.x), plot.y_name.unit.from_deck(point.y)};
    }
    for (double& bar : series.bars) {
      bar = plot.y_name.unit.from_deck(bar);
    }
  }
  return plot;
}

} // namespace

PlotSeries styled_curve(std::string name, std::size_t colour, std::size_t dash) {
  PlotSeries series;
  series.name = std::move(name);
  series.colour = palette_colour(colour);
  series.dash = dash_pattern(dash);
  return series;
}

PlotSeries marker_series(std::string name, MarkerShape shape) {
  PlotSeries series;
  series.name = std::move(name);
  series.joined = false;
  series.marker = shape;
  return series;
}

namespace {

// With numbers in the units that are written.
std::string draw_written_plot(const Plot& plot) {
  AxisRange x = range_of(plot, &DrawingPoint::x);
  const AxisRange y = range_of(plot, &DrawingPoint::y);
  x.left = box_left(y);
  const double legend_left = x.left + box_width + legend_gap;
  const std::vector<LegendEntry> entries = legend_entries(plot);
  const double foot = box_top + box_height + 46.0;
  const double beside = legend_left + legend_width;
  SvgDrawing svg(plot.legend_below ? legend_left : beside,
                 plot.legend_below ? foot + 6.0 + legend_height(entries)
                                   : std::max(foot, box_top + legend_height(entries)),
                 plot.label);
  svg.begin_group(plot_attributes(plot, x, y));
  draw_axes(svg, plot, x, y);
  for (const PlotSeries& series : plot.series) {
    svg.begin_group(curve_attributes(series));
    draw_series(svg, series, x, y);
    svg.end_group();
  }
  svg.end_group();
  draw_legend(svg, entries,
              plot.legend_below ? DrawingPoint{x.left, foot + 6.0}
                                : DrawingPoint{legend_left, box_top});
  return svg.svg_text();
}

} // namespace

std::string draw_svg(const Plot& plot) {
  return draw_written_plot(plot_in_output_units(plot));
}

std::string error_bar_note(const std::vector<PlotSeries>& all) {
  double widest = 0.0;
  std::size_t barred = 0;
  std::size_t count = 0;
  for (const PlotSeries& series : all) {
    for (std::size_t i = 0; i < series.bars.size(); ++i) {
      const double K = std::abs(series.points[i].y);
      const bool found = std::isfinite(series.bars[i]);
      ++count;
      barred += found ? 1 : 0;
      widest = found && K > 0.0 ? std::max(widest, series.bars[i] / K) : widest;
    }
  }
  if (!(widest > 0.0)) {
    return {};
  }
  constexpr const char* unseen = "bars shorter than a pixel are not drawn.";
  return barred == count
             ? fmt::format(" Error bars: the estimated error of K₁ from the mesh, at most {:.2g} % "
                           "of it; {}",
                           100.0 * widest, unseen)
             : fmt::format(" Error bars: the estimated error of K₁ from the mesh, computed for {} "
                           "of {} points only, and there at most {:.2g} % of it; {}",
                           barred, count, 100.0 * widest, unseen);
}

} // namespace spricka::report
