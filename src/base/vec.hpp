// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>

namespace spricka::base {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// The cross product of two vectors in the plane: positive where v lies to the left of u.
inline double cross(const Vec2& u, const Vec2& v) {
  return u.x() * v.y() - u.y() * v.x();
}

/// A vector of the plane z = 0.
inline Vec3 embed_in_space(const Vec2& x) {
  return {x.x(), x.y(), 0.0};
}

} // namespace spricka::base
