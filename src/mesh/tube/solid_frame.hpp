// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/crack_frame.hpp"
#include "mesh/surface/crack_relief.hpp"
#include "mesh/tube/solid_crack.hpp"

#include <memory>

namespace spricka::mesh {

/// Frame of a crack in space. Of an open front the area between it and the chord of its ends
/// counts; of a straight one a quarter of its length stands for the radius.
CrackFrame make_crack_frame(const SolidCrack& crack);

/// What a crack has made of its plane, in a frame; empty: it has not turned.
std::shared_ptr<const NonPlanarCrackSurface> crack_surface_in_frame(const CrackFrame& frame,
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
    return relief ? -relief->crack_height_over_plane(p) : normal.dot(p - origin);
  }
  /// On the crack.
  [[nodiscard]] base::Vec3 lift_to_crack(const base::Vec2& q) const {
    const base::Vec3 p = origin + q.x() * u + q.y() * v;
    return relief ? base::Vec3(p + relief->crack_height_over_plane(p) * normal) : p;
  }
};

} // namespace spricka::mesh
