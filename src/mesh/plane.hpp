// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <limits>
#include <vector>

/// Plane geometry of points, segments and polygons, for decisions on rounded coordinates.
namespace spricka::mesh {

/// The cross product of two vectors in the plane: positive where v lies to the left of u.
inline double cross(const base::Vec2& u, const base::Vec2& v) {
  return u.x() * v.y() - u.y() * v.x();
}

/// Distance between two segments; 0 if they meet.
double distance(const base::Vec2& a, const base::Vec2& b, const base::Vec2& c, const base::Vec2& d);

/// Where two segments come nearest to each other, on the first.
struct ClosestApproach {
  base::Vec2 at = base::Vec2::Zero();
  double distance = std::numeric_limits<double>::max();
};
/// Nearest approach of the segment a b to the segment c d: at their crossing, else where an end of
/// either is nearest.
ClosestApproach closest_approach(const base::Vec2& a, const base::Vec2& b, const base::Vec2& c,
                                 const base::Vec2& d);

/// Whether a point lies in a polygon (even-odd rule).
bool is_inside_polygon(const base::Vec2& p, const std::vector<base::Vec2>& polygon);

/// Twice the area of a loop of points; negative if it runs clockwise.
double twice_area(const std::vector<base::Vec2>& points, const std::vector<int>& loop);

/// Distance between a filled polygon and a polyline; 0 if they meet.
double distance(const std::vector<base::Vec2>& polygon, const std::vector<base::Vec2>& polyline);

/// To a multiple of 2^-26: much coarser than round-off, so that it almost never sees it, much finer
/// than any element.
double rounded(double x);
base::Vec3 rounded(const base::Vec3& x);

/// Room for round-off in comparisons of local coordinates.
inline constexpr double coordinate_tolerance = 1e-7;

} // namespace spricka::mesh
