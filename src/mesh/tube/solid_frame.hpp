// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/crack_relief.hpp"
#include "mesh/tube/solid_crack.hpp"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace spricka::mesh {

/// A frame that goes with a crack in space: origin in its middle, x towards the first point of its
/// front, z its normal, lengths divided by `a`, the radius of a circle of its area. Decisions are
/// taken on rounded coordinates, which the deck's unit and the crack's place do not change.
struct SolidCrackFrame {
  base::Vec3 origin = base::Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< [, axis]
  double a = 1.0;

  [[nodiscard]] base::Vec3 exact_local(const base::Vec3& x) const {
    return axes.transpose() * (x - origin) / a;
  }
  [[nodiscard]] base::Vec3 rounded_local(const base::Vec3& x) const; ///< rounded
  [[nodiscard]] base::Vec3 global(const base::Vec3& p) const { return origin + a * (axes * p); }
};

/// Of an open front the area between it and the chord of its ends counts; of a straight one a
/// quarter of its length stands for the radius.
SolidCrackFrame make_crack_frame(const SolidCrack& crack);

base::Vec3 rounded(const base::Vec3& p);

/// What a crack has made of its plane, in a frame; empty: it has not turned.
std::shared_ptr<const NonPlanarCrackSurface> surface_in_frame(const SolidCrackFrame& frame,
                                                              const SolidCrack& crack);

/// A plane in space with coordinates, (u, v) of places on it, and what a crack has made of it.
struct PlaneBasis {
  base::Vec3 origin = base::Vec3::Zero();
  base::Vec3 u = base::Vec3::UnitX();
  base::Vec3 v = base::Vec3::UnitY();
  base::Vec3 normal = base::Vec3::UnitZ();
  std::shared_ptr<const NonPlanarCrackSurface> relief =
      {}; ///< of a crack that has turned out of it

  [[nodiscard]] base::Vec2 project(const base::Vec3& p) const {
    return {u.dot(p - origin), v.dot(p - origin)};
  }
  /// Along the normal, above the crack.
  [[nodiscard]] double height(const base::Vec3& p) const {
    return relief ? -relief->height_above(p) : normal.dot(p - origin);
  }
  /// On the crack.
  [[nodiscard]] base::Vec3 lift_to_crack(const base::Vec2& q) const {
    const base::Vec3 p = origin + q.x() * u + q.y() * v;
    return relief ? base::Vec3(p + relief->height_above(p) * normal) : p;
  }
};

} // namespace spricka::mesh
