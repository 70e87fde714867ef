// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/tornado.hpp"

#include "report/drawing/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spricka::report {
namespace {

constexpr double label_letter = 7.2;
constexpr double half_width = 110.0;
constexpr double number_width = 62.0;
constexpr double row_height = 22.0;
constexpr double bar_height = 13.0;
constexpr double top = 26.0;
constexpr double foot = 40.0;

double largest(const TornadoChart& tornado) {
  double most = 0.0;
  for (const TornadoChart::TornadoBar& bar : tornado.bars) {
    most = std::max({most, std::abs(bar.more), std::abs(bar.less)});
  }
  return most > 0.0 ? most : 1.0;
}

double names_width(const TornadoChart& tornado) {
  std::size_t letters = 12;
  for (const TornadoChart::TornadoBar& bar : tornado.bars) {
    letters = std::max(letters, bar.name.size());
  }
  return label_letter * static_cast<double>(letters) + 10.0;
}

} // namespace

std::string draw_svg(const TornadoChart& tornado) {
  const double names = names_width(tornado);
  const double middle = names + number_width + half_width;
  const double height = row_height * static_cast<double>(tornado.bars.size());
  const double most = largest(tornado);
  const auto at = [&](double value) { return middle + half_width * value / most; };
  SvgDrawing svg(middle + half_width + number_width, top + height + foot,
                 "Change of the stress intensity factor, " + tornado.title);
  svg.title({middle, 16.0}, tornado.title);
  for (const AxisTick& tick : round_axis_ticks(-most, most, 5)) {
    const double x = at(tick.value);
    svg.line({x, top}, {x, top + height}, {"#ddd", 0.7, "none", ""});
    svg.text({x, top + height + 15.0}, tick.text, {TextAnchor::middle, 11.0});
  }
  for (std::size_t i = 0; i < tornado.bars.size(); ++i) {
    const TornadoChart::TornadoBar& bar = tornado.bars[i];
    const double y = top + row_height * (static_cast<double>(i) + 0.5);
    const std::string ink(palette_colour(bar.colour));
    const auto block = [&](double value, const ShapeStyle& style) {
      const double left = std::min(at(0.0), at(value));
      svg.rectangle({left, y - 0.5 * bar_height}, std::abs(at(value) - at(0.0)), bar_height, style);
    };
    block(bar.less, {ink, 0.9, "#fff", ""});
    block(bar.more, {ink, 0.9, ink, ""});
    svg.text({names - 6.0, y + 4.0}, bar.name, {TextAnchor::end, 12.0});
    const bool right = bar.more >= 0.0;
    const double end = right ? std::max(at(bar.more), at(bar.less)) + 5.0
                             : std::min(at(bar.more), at(bar.less)) - 5.0;
    svg.text({end, y + 4.0}, fmt::format("{:+.3g} %", bar.more),
             {right ? TextAnchor::start : TextAnchor::end, 11.0});
  }
  svg.line({middle, top}, {middle, top + height}, {"#000", 0.9, "none", ""});
  svg.text({middle, top + height + 33.0}, "change of K₁  [%]", {TextAnchor::middle, 12.0});
  return svg.svg_text();
}

} // namespace spricka::report
