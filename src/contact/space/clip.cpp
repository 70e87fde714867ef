// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/clip.hpp"

namespace spricka::contact {

using base::Vec2;

namespace {

// Twice the area of a triangle; positive where c lies on the left of the way from a to b.
double left_of(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Whether the smallest boxes round two triangles have no point in common.
bool boxes_are_apart(const PlaneTriangle& a, const PlaneTriangle& b) {
  const auto low = [](const PlaneTriangle& t) { return t[0].cwiseMin(t[1]).cwiseMin(t[2]); };
  const auto high = [](const PlaneTriangle& t) { return t[0].cwiseMax(t[1]).cwiseMax(t[2]); };
  return (low(a).array() > high(b).array()).any() || (low(b).array() > high(a).array()).any();
}

} // namespace

double twice_area(const PlaneTriangle& t) {
  return left_of(t[0], t[1], t[2]);
}

std::vector<Vec2> intersect_triangles(const PlaneTriangle& a, const PlaneTriangle& b) {
  constexpr std::size_t most_corners = 6;
  if (boxes_are_apart(a, b)) {
    return {};
  }
  std::vector<Vec2> polygon;
  std::vector<Vec2> cut;
  polygon.reserve(most_corners);
  cut.reserve(most_corners);
  polygon.assign(a.begin(), a.end());
  for (std::size_t i = 0; i < b.size() && !polygon.empty(); ++i) {
    const Vec2& from = b[i];
    const Vec2& to = b[(i + 1) % b.size()];
    cut.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2& p = polygon[k];
      const Vec2& q = polygon[(k + 1) % polygon.size()];
      const double at_p = left_of(from, to, p);
      const double at_q = left_of(from, to, q);
      if (at_p >= 0.0) {
        cut.push_back(p);
      }
      if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0)) {
        cut.emplace_back(p + at_p / (at_p - at_q) * (q - p));
      }
    }
    polygon.swap(cut);
  }
  if (polygon.size() < 3) {
    polygon.clear();
  }
  return polygon;
}

Eigen::Vector3d barycentric_coordinates(const PlaneTriangle& t, const Vec2& x) {
  const double whole = twice_area(t);
  const double b = left_of(t[2], t[0], x) / whole;
  const double c = left_of(t[0], t[1], x) / whole;
  return {1.0 - b - c, b, c};
}

} // namespace spricka::contact
