// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/crack_check.hpp"

#include "geometry/polyline.hpp"
#include "mesh/plane.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace spricka::mesh {
namespace {

using base::Vec2;
using base::Vec3;

/// Lines nearer than this part of the shorter one's length touch.
constexpr double touching = 1e-6;
/// The sharpest turn of a crack: what is left between its two parts must hold elements.
constexpr double sharpest_turn = 165.0 * std::numbers::pi / 180.0;

Vec2 flat(const Vec3& x) {
  return {x.x(), x.y()};
}

std::vector<Vec2> flat(const std::vector<Vec3>& line) {
  std::vector<Vec2> points;
  std::ranges::transform(line, std::back_inserter(points), [](const Vec3& x) { return flat(x); });
  return points;
}

double length_of(const CrackLine& line) {
  return geometry::polyline_length(line.points);
}

std::string place(const Vec2& p) {
  return fmt::format("({:.6g}, {:.6g})", p.x(), p.y());
}

/// What is wrong with a line by itself.
std::string own_trouble(const CrackLine& line) {
  const std::vector<Vec2> x = flat(line.points);
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    const Vec2 before = x[i] - x[i - 1];
    const Vec2 after = x[i + 1] - x[i];
    const double turn = std::abs(std::atan2(cross(before, after), before.dot(after)));
    if (turn > sharpest_turn) {
      return fmt::format("{} turns back at {}, by {:.4g} degrees; at most {:.4g} leave room for "
                         "elements",
                         line.display_name(), place(x[i]), turn * 180.0 / std::numbers::pi,
                         sharpest_turn * 180.0 / std::numbers::pi);
    }
  }
  const double close = touching * length_of(line);
  for (std::size_t i = 1; i < x.size(); ++i) {
    // Segments next to each other share a point; their turn is checked above.
    for (std::size_t k = i + 2; k < x.size(); ++k) {
      const ClosestApproach m = closest_approach(x[i - 1], x[i], x[k - 1], x[k]);
      if (m.distance < close) {
        return fmt::format("{} crosses or touches itself at {}", line.display_name(), place(m.at));
      }
    }
  }
  return {};
}

ClosestApproach meeting(const CrackLine& one, const CrackLine& other) {
  const std::vector<Vec2> x = flat(one.points);
  const std::vector<Vec2> y = flat(other.points);
  ClosestApproach best;
  for (std::size_t i = 1; i < x.size(); ++i) {
    for (std::size_t k = 1; k < y.size(); ++k) {
      const ClosestApproach m = closest_approach(x[i - 1], x[i], y[k - 1], y[k]);
      best = m.distance < best.distance ? m : best;
    }
  }
  return best;
}

} // namespace

bool check_crack_lines(std::span<const CrackLine> lines, std::span<const base::SourceSpan> spans,
                       base::Diagnostics& diagnostics) {
  bool good = true;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (const std::string why = own_trouble(lines[i]); !why.empty()) {
      diagnostics.error(spans[i], "E430", why, "end it before, or draw it with fewer bends");
      good = false;
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (lines[i].net != lines[k].net) {
        continue; // nets may lie on each other
      }
      const ClosestApproach m = meeting(lines[i], lines[k]);
      if (m.distance < touching * std::min(length_of(lines[i]), length_of(lines[k]))) {
        diagnostics.error(spans[i], "E430",
                          fmt::format("{} meets {} at {}", lines[i].display_name(),
                                      lines[k].display_name(), place(m.at)),
                          "cracks with branches are not available: leave some ligament between "
                          "them, or join them to one line");
        good = false;
      }
    }
  }
  return good;
}

namespace {

/// Room for the tip at the last of the points beside other cracks and the crack's own earlier parts
/// [deck length].
double room_at_end(const CrackLine& line, const std::vector<Vec3>& points,
                   std::span<const CrackLine> all) {
  const Vec2 tip = flat(points.back());
  double room = std::numeric_limits<double>::max();
  for (const CrackLine& other : all) {
    if (other.crack != line.crack && other.net == line.net) {
      room = std::min(room, geometry::nearest_point(tip, flat(other.points)).distance);
    }
  }
  double along = 0.0; // from the tip
  for (std::size_t i = points.size() - 1; i > 0; --i) {
    const double d = geometry::distance_to_segment(tip, flat(points[i - 1]), flat(points[i]));
    // Parts that come back to the tip: nearer to it than 0.9 of the way along the crack (crack.16).
    room = d < 0.9 * along ? std::min(room, d) : room;
    along += (points[i] - points[i - 1]).norm();
  }
  return room;
}

} // namespace

double tip_clearance_to_cracks(const CrackLine& line, std::span<const CrackLine> all) {
  const double room = room_at_end(line, line.points, all);
  return line.embedded
             ? std::min(room, room_at_end(line, {line.points.rbegin(), line.points.rend()}, all))
             : room;
}

} // namespace spricka::mesh
