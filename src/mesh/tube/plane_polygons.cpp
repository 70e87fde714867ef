// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/plane_polygons.hpp"

#include "geometry/polyline.hpp"
#include "mesh/plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

namespace {

PlaneBasis basis_of(const SolidCrack& crack) {
  const CrackFrame own = make_crack_frame(crack);
  return {own.origin, own.axes.col(0), own.axes.col(1), own.axes.col(2), crack.relief};
}

template <class F> void for_edges(const std::vector<std::vector<Vec2>>& outlines, F&& f) {
  for (const std::vector<Vec2>& outline : outlines) {
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
      f(outline[j], outline[i]);
    }
  }
}

} // namespace

PlanePolygons::PlanePolygons(const PlaneBasis& plane,
                             const std::vector<std::vector<Vec3>>& outlines)
    : plane_(plane) {
  for (const std::vector<Vec3>& outline : outlines) {
    std::vector<Vec2>& flat = outlines_.emplace_back();
    for (const Vec3& x : outline) {
      flat.push_back(plane_.project(x));
    }
  }
}

PlanePolygons::PlanePolygons(const SolidCrack& crack,
                             const std::vector<std::vector<Vec3>>& outlines)
    : PlanePolygons(basis_of(crack), outlines) {}

bool PlanePolygons::contains(const Vec2& q) const {
  return std::ranges::count_if(
             outlines_, [&](const std::vector<Vec2>& outline) { return is_inside(q, outline); }) %
             2 ==
         1;
}

double PlanePolygons::area() const {
  double sum = 0.0;
  for (const std::vector<Vec2>& outline : outlines_) {
    double own = 0.0;
    for_edges({outline}, [&](const Vec2& a, const Vec2& b) {
      own += 0.5 * cross(a - outline.front(), b - outline.front());
    });
    const auto round = std::ranges::count_if(outlines_, [&](const std::vector<Vec2>& other) {
      return &other != &outline && is_inside(outline.front(), other);
    });
    sum += round % 2 == 0 ? std::abs(own) : -std::abs(own);
  }
  return sum;
}

double PlanePolygons::distance_to_outlines(const Vec2& q) const {
  double least = std::numeric_limits<double>::max();
  for (const std::vector<Vec2>& outline : outlines_) {
    least = std::min(least, geometry::distance_to_outline(q, outline));
  }
  return least;
}

double PlanePolygons::distance(const Vec3& x) const {
  const Vec2 q = plane_.project(x);
  return std::hypot(plane_.height(x), contains(q) ? 0.0 : distance_to_outlines(q));
}

std::vector<Vec3> PlanePolygons::intersect_triangle(const geometry::CornerPlaces& triangle) const {
  std::vector<Vec2> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = triangle[i];
    const Vec3& b = triangle[(i + 1) % 3];
    const double ha = plane_.height(a);
    const double hb = plane_.height(b);
    if ((ha < 0.0) != (hb < 0.0)) {
      ends.push_back(plane_.project(a + ha / (ha - hb) * (b - a)));
    }
  }
  std::vector<Vec3> places;
  constexpr int steps = 8; // a triangle may be larger than the crack
  for (int i = 0; i <= steps && ends.size() == 2; ++i) {
    places.push_back(
        plane_.lift_to_crack(ends[0] + i / static_cast<double>(steps) * (ends[1] - ends[0])));
  }
  return places;
}

std::optional<double> PlanePolygons::exit_distance(const Vec2& q, const Vec2& d) const {
  std::optional<double> least;
  for_edges(outlines_, [&](const Vec2& a, const Vec2& b) {
    const Vec2 side = b - a;
    const double turn = cross(d, side);
    if (std::abs(turn) < 1e-12 * side.norm() * d.norm()) {
      return;
    }
    const double along = cross(a - q, side) / turn;
    const double part = cross(a - q, d) / turn;
    const bool at_q =
        geometry::distance_to_segment(q, a, b) < 0.02 * side.norm(); // its own edge, and its chord
    if (!at_q && along > 0.0 && part >= 0.0 && part <= 1.0 && (!least || along < *least)) {
      least = along;
    }
  });
  return least;
}

} // namespace spricka::mesh
