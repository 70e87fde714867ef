// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/label_placer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spricka::report {
namespace {

constexpr double beside = 7.0;          // between a point and its words [px]
constexpr double farther = 15.0;        // to the next ring of places that are tried
constexpr int rings = 8;                // of places
constexpr int directions_of_ring = 12;  // tried on each
constexpr double room_of_a_label = 2.0; // kept round words

} // namespace

double text_width(std::string_view words, const TextStyle& style) {
  const auto letters = std::ranges::count_if(
      words, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }); // UTF-8
  return (style.bold ? 0.64 : 0.58) * style.size * static_cast<double>(letters);
}

void LabelPlacer::keep_free(DrawingPoint corner, double width, double height) {
  taken_.push_back({corner, {corner.x + width, corner.y + height}});
}

bool LabelPlacer::is_free(const Taken& place) const {
  const bool inside = place.low.x >= first_.x && place.high.x <= last_.x &&
                      place.low.y >= first_.y && place.high.y <= last_.y;
  return inside && std::ranges::none_of(taken_, [&](const Taken& t) {
           return place.low.x < t.high.x && t.low.x < place.high.x && place.low.y < t.high.y &&
                  t.low.y < place.high.y;
         });
}

void LabelPlacer::write(SvgDrawing& svg, DrawingPoint at, std::string_view words, TextStyle style) {
  const double width = text_width(words, style);
  const double up = 0.8 * style.size; // above the line that words stand on
  const double down = 0.25 * style.size;
  style.anchor = TextAnchor::start;
  for (int ring = 0; ring < rings; ++ring) {
    const double away = beside + farther * ring;
    for (int i = 0; i < directions_of_ring; ++i) {
      // to the right and above first, then by turns to both sides
      const double turn =
          std::numbers::pi / 6.0 *
          (i % 2 == 0 ? static_cast<double>(i) / 2.0 : -static_cast<double>(i + 1) / 2.0);
      const double angle = std::numbers::pi / 6.0 + turn;
      const DrawingPoint near{at.x + away * std::cos(angle), at.y - away * std::sin(angle)};
      const double left = std::cos(angle) < -0.1  ? near.x - width
                          : std::cos(angle) < 0.1 ? near.x - 0.5 * width
                                                  : near.x;
      const double line = near.y + (std::sin(angle) < -0.1 ? up : 0.0);
      const Taken place{{left - room_of_a_label, line - up - room_of_a_label},
                        {left + width + room_of_a_label, line + down + room_of_a_label}};
      if (is_free(place)) {
        if (ring > 0) {
          svg.line(at, near, {style.fill, 0.7, "none", ""});
        }
        svg.text({left, line}, words, style);
        taken_.push_back(place);
        return;
      }
    }
  }
}

} // namespace spricka::report
