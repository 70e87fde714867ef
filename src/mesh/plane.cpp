// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/plane.hpp"

#include "geometry/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

double distance(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double ca = cross(d - c, a - c);
  const double cb = cross(d - c, b - c);
  const double ac = cross(b - a, c - a);
  const double ad = cross(b - a, d - a);
  if (ca * cb < 0.0 && ac * ad < 0.0) {
    return 0.0;
  }
  return std::min(
      std::min(geometry::distance_to_segment(a, c, d), geometry::distance_to_segment(b, c, d)),
      std::min(geometry::distance_to_segment(c, a, b), geometry::distance_to_segment(d, a, b)));
}

ClosestApproach closest_approach(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  ClosestApproach best;
  const auto look = [&](const Vec2& p, double t) {
    const double away = geometry::distance_to_segment(p, c, d);
    if (t >= 0.0 && t <= 1.0 && away < best.distance) {
      best = {p, away};
    }
  };
  const Vec2 along = b - a;
  const double turn = cross(along, d - c);
  look(a, 0.0);
  look(b, 1.0);
  if (turn != 0.0) {
    const double t = cross(c - a, d - c) / turn;
    look(a + t * along, t);
  }
  for (const Vec2& end : {c, d}) {
    const double t = (end - a).dot(along) / along.squaredNorm();
    look(a + t * along, t);
  }
  return best;
}

bool is_inside_polygon(const Vec2& p, const std::vector<Vec2>& polygon) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) {
      in = !in;
    }
  }
  return in;
}

double twice_area(const std::vector<Vec2>& points, const std::vector<int>& loop) {
  double sum = 0.0;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    sum +=
        cross(points[static_cast<std::size_t>(loop[j])], points[static_cast<std::size_t>(loop[i])]);
  }
  return sum;
}

double distance(const std::vector<Vec2>& polygon, const std::vector<Vec2>& polyline) {
  double least = std::numeric_limits<double>::max();
  for (const Vec2& p : polyline) {
    if (is_inside_polygon(p, polygon)) {
      return 0.0;
    }
  }
  for (std::size_t k = 0; k + 1 < polyline.size(); ++k) {
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      least = std::min(least, distance(polygon[j], polygon[i], polyline[k], polyline[k + 1]));
    }
  }
  return least;
}

double rounded(double x) {
  static constexpr double grid = 67108864.0; // 2^26
  return std::round(x * grid) / grid + 0.0;  // of the two zeros that without a sign
}

Vec3 rounded(const Vec3& x) {
  return {rounded(x.x()), rounded(x.y()), rounded(x.z())};
}

} // namespace spricka::mesh
