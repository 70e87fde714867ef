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
bool is_inside(const base::Vec2& p, const std::vector<base::Vec2>& polygon);

/// Distance between a filled polygon and a polyline; 0 if they meet.
double distance(const std::vector<base::Vec2>& polygon, const std::vector<base::Vec2>& polyline);

/// To a multiple of 2^-26: much coarser than round-off, so that it almost never sees it, much finer
/// than any element.
double rounded(double x);

/// A frame that goes with a crack: origin at the mouth, x along its first segment, lengths divided
/// by `a`. Coordinates in it are rounded: they serve decisions only, which the deck's unit and the
/// crack's place must not change, ties among them.
struct PlanarCrackFrame {
  base::Vec3 origin = base::Vec3::Zero();
  base::Vec3 e1 = base::Vec3::UnitX();
  double a = 1.0;

  /// Coordinates of a point in the frame, in units of `a`, not rounded.
  [[nodiscard]] base::Vec2 exact_local(const base::Vec3& x) const;
  /// Coordinates of a point in the frame, in units of `a`, for decisions.
  [[nodiscard]] base::Vec2 rounded_local(const base::Vec3& x) const; ///< rounded
  /// The point of the mesh at coordinates in the frame [length], z that of the origin.
  [[nodiscard]] base::Vec3 global(const base::Vec2& x) const;
};

/// Room for round-off in comparisons of local coordinates.
inline constexpr double same = 1e-7;

} // namespace spricka::mesh
