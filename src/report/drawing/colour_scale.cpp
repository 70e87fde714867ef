// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/colour_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::report {
namespace {

constexpr std::array<std::array<double, 3>, 5> ramp{
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};

} // namespace

std::size_t ColourScale::band_index(double value) const {
  const double t = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0.0;
  return std::min(static_cast<std::size_t>(t * static_cast<double>(colour_bands)),
                  colour_bands - 1);
}

ColourScale make_colour_scale(double low, double high) {
  // A uniform field has one colour, not round-off in twelve.
  return high - low > 1e-6 * std::abs(high) ? ColourScale{low, high} : ColourScale{0.0, high};
}

double value_above_share(std::vector<std::pair<double, double>> values_with_shares, double part) {
  std::ranges::sort(values_with_shares);
  double total = 0.0;
  for (const auto& [value, share] : values_with_shares) {
    total += share;
  }
  double sum = 0.0;
  for (const auto& [value, share] : values_with_shares) {
    sum += share;
    if (sum >= part * total) {
      return value;
    }
  }
  return values_with_shares.empty() ? 0.0 : values_with_shares.back().first;
}

std::string band_colour(std::size_t band) {
  const double at = static_cast<double>(band) / static_cast<double>(colour_bands - 1) *
                    static_cast<double>(ramp.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), ramp.size() - 2);
  const double part = at - static_cast<double>(below);
  std::array<int, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c) {
    rgb[c] =
        static_cast<int>(std::lround((1.0 - part) * ramp[below][c] + part * ramp[below + 1][c]));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

void draw_colour_legend(SvgDrawing& svg, const ColourScale& scale, DrawingPoint corner,
                        double width, const MeasureTitle& title) {
  if (!(scale.high > scale.low)) {
    return;
  }
  const double part = width / static_cast<double>(colour_bands);
  for (std::size_t b = 0; b < colour_bands; ++b) {
    const std::string fill = band_colour(b);
    svg.rectangle({corner.x + part * static_cast<double>(b), corner.y}, part, 11.0,
                  {fill, 0.3, fill, ""});
  }
  const double low = title.unit.from_deck(scale.low);
  const double high = title.unit.from_deck(scale.high);
  for (const AxisTick& tick : round_axis_ticks(low, high, 5)) {
    const double x = corner.x + width * (tick.value - low) / (high - low);
    svg.line({x, corner.y + 11.0}, {x, corner.y + 15.0}, {"#000", 0.8, "none", ""});
    svg.text({x, corner.y + 27.0}, tick.text, {TextAnchor::middle, 11.0});
  }
  svg.text({corner.x + width, corner.y - 5.0}, title.text, {TextAnchor::end, 11.0});
}

} // namespace spricka::report
