// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

namespace spricka::mesh {

/// A frame that goes with a crack, lengths divided by `a`. In the plane: origin at the mouth, x
/// along the first segment, z out of the plane. In space: origin in the middle of the crack, x
/// towards the first point of its front, z its normal, `a` the radius of a circle of its area.
/// Rounded coordinates serve decisions only, which the deck's unit and the crack's place must not
/// change, ties among them.
struct CrackFrame {
  base::Vec3 origin = base::Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< [, axis]
  double a = 1.0;

  [[nodiscard]] base::Vec3 exact_local_coordinates(const base::Vec3& x) const {
    // Divided first: the first segment of a straight crack of length a lies on the axis exactly.
    return axes.transpose() * ((x - origin) / a);
  }
  [[nodiscard]] base::Vec3 rounded_local_coordinates(const base::Vec3& x) const;
  [[nodiscard]] base::Vec3 global(const base::Vec3& p) const { return origin + a * (axes * p); }
};

} // namespace spricka::mesh
