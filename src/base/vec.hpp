// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>

namespace spricka::base {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

} // namespace spricka::base
