// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/rigid_picture.hpp"

#include "model/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace spricka::report {
namespace {

constexpr double hatch_distance = 7.0; // between hatches [px]
constexpr double hatch = 7.0;          // their length [px]

using base::Vec2;

/// A point of the outline and the unit direction into the rigid body.
struct RigidOutlinePoint {
  Vec2 x;
  Vec2 inward;
};

/// The part of first + t (second - first), 0 <= t <= 1, that the window shows.
std::optional<std::pair<double, double>> shown(const Vec2& first, const Vec2& chord,
                                               const DrawingWindow& window) {
  double from = 0.0;
  double to = 1.0;
  const auto cut = [&](double x, double step, double low, double high) {
    if (step == 0.0) {
      to = x < low || x > high ? from - 1.0 : to;
      return;
    }
    const auto [enter, leave] = std::minmax({(low - x) / step, (high - x) / step});
    from = std::max(from, enter);
    to = std::min(to, leave);
  };
  cut(first.x(), chord.x(), window.low.x, window.high.x);
  cut(first.y(), chord.y(), window.low.y, window.high.y);
  return from < to ? std::optional(std::pair(from, to)) : std::nullopt;
}

std::vector<RigidOutlinePoint> along_line(const model::RigidTarget& line,
                                          const DrawingWindow& window) {
  const Vec2 first = line.first.head<2>();
  const Vec2 chord = line.second.head<2>() - first;
  const auto part = shown(first, chord, window);
  std::vector<RigidOutlinePoint> spots;
  if (!part) {
    return spots;
  }
  const Vec2 inward = Vec2(chord.y(), -chord.x()).normalized(); // the body is on the left
  const double length = (part->second - part->first) * chord.norm() * window.scale;
  const auto count = static_cast<int>(std::ceil(length / hatch_distance));
  for (int i = 0; i <= count; ++i) {
    const double t = part->first + (part->second - part->first) * i / count;
    spots.push_back({first + t * chord, inward});
  }
  return spots;
}

/// Angles of a circle that the window may show: all, or from its corners as seen from far off.
std::pair<double, double> angles(const Vec2& centre, const DrawingWindow& window) {
  const Vec2 low(window.low.x, window.low.y);
  const Vec2 high(window.high.x, window.high.y);
  const Vec2 middle = 0.5 * (low + high) - centre;
  if (middle.norm() < 0.5 * (high - low).norm()) {
    return {0.0, 2.0 * std::numbers::pi};
  }
  const double theta = std::atan2(middle.y(), middle.x());
  double from = 0.0;
  double to = 0.0;
  for (const Vec2& corner : {low, high, Vec2(low.x(), high.y()), Vec2(high.x(), low.y())}) {
    const Vec2 d = corner - centre;
    const double turn = std::remainder(std::atan2(d.y(), d.x()) - theta, 2.0 * std::numbers::pi);
    from = std::min(from, turn);
    to = std::max(to, turn);
  }
  return {theta + from, theta + to};
}

std::vector<RigidOutlinePoint> along_arc(const model::RigidTarget& arc,
                                         const DrawingWindow& window) {
  const Vec2 centre = arc.first.head<2>();
  const double radius = std::abs(arc.radius);
  const auto [from, to] = angles(centre, window);
  const auto count = static_cast<int>(
      std::clamp(std::ceil((to - from) * radius * window.scale / hatch_distance), 24.0, 4000.0));
  std::vector<RigidOutlinePoint> spots;
  for (int i = 0; i <= count; ++i) {
    const double theta = from + (to - from) * i / count;
    const Vec2 outward(std::cos(theta), std::sin(theta));
    spots.push_back({centre + radius * outward, arc.radius > 0.0 ? Vec2(-outward) : outward});
  }
  return spots;
}

} // namespace

void draw_rigid_target(SvgDrawing& svg, const model::RigidTarget& rigid,
                       const DrawingWindow& window) {
  const std::vector<RigidOutlinePoint> spots = rigid.shape == model::RigidTargetShape::line
                                                   ? along_line(rigid, window)
                                                   : along_arc(rigid, window);
  SvgPathData outline;
  SvgPathData hatches;
  for (const RigidOutlinePoint& spot : spots) {
    const DrawingPoint p = window.project({spot.x.x(), spot.x.y()});
    outline.empty() ? outline.move(p) : outline.line(p);
    // turned by 45 degrees from the outline; y runs down on the drawing
    const Vec2 d = hatch / std::numbers::sqrt2 *
                   Vec2(spot.inward.x() - spot.inward.y(), -spot.inward.y() - spot.inward.x());
    hatches.move(p).line({p.x + d.x(), p.y + d.y()});
  }
  if (!outline.empty()) {
    svg.path(hatches, {"#555", 0.8, "none", ""});
    svg.path(outline, {"#333", 2.0, "none", ""});
  }
}

} // namespace spricka::report
