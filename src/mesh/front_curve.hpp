// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/spline_curve.hpp"

#include <vector>

/// The front of a crack in space as a smooth curve.
namespace spricka::mesh {

/// The crack's axes at a place of its front: m grows, b is the normal of the crack from its lower
/// to its upper face, t = m x b runs along the front; and how they turn along it.
struct FrontFrame {
  double s = 0.0; ///< length along the front from its first point
  base::Vec3 x = base::Vec3::Zero();
  base::Vec3 m = base::Vec3::UnitX();
  base::Vec3 b = base::Vec3::UnitY();
  base::Vec3 t = base::Vec3::UnitZ();
  base::Vec3 dm = base::Vec3::Zero(); ///< dm/ds, db/ds, dt/ds [1/length]
  base::Vec3 db = base::Vec3::Zero();
  base::Vec3 dt = base::Vec3::Zero();

  /// One over the radius of curvature in the crack's plane, positive where the crack is convex (its
  /// front as that of a penny): t' = -curvature m.
  [[nodiscard]] double curvature() const { return -dt.dot(m); }
};

/// A smooth curve through points with the normals of the crack. Beyond the ends of an open front it
/// goes on straight.
class FrontCurve {
public:
  /// Through `points` [>= 2; >= 4 if closed, the first not repeated], in the order of t, with a
  /// unit normal b at each; of a crack with one plane all the same.
  FrontCurve(std::vector<base::Vec3> points, std::vector<base::Vec3> normals, bool closed);

  [[nodiscard]] double length() const { return curve_.length(); }
  [[nodiscard]] bool closed() const { return curve_.closed(); }
  /// The axes at a length s; of a closed front s counts on over its end.
  [[nodiscard]] FrontFrame at(double s) const;
  /// Where the front is nearest to x [length]; below 0 or above length() beyond an open end.
  [[nodiscard]] double nearest_length(const base::Vec3& x) const {
    return curve_.nearest_length(x);
  }
  [[nodiscard]] const std::vector<base::Vec3>& points() const { return x_; }
  [[nodiscard]] const std::vector<base::Vec3>& normals() const { return normal_; } ///< [point]

private:
  std::vector<base::Vec3> x_, normal_; ///< [knot]
  geometry::SplineCurve curve_;
};

} // namespace spricka::mesh
