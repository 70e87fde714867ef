// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"

#include <Eigen/Core>

#include <limits>

namespace spricka::base {

/// A parallelepiped of places: centre + axes t for t in [-1, 1]^3, give or take `bulge` along each
/// coordinate. Axes may be zero.
struct PlaceCell {
  Vec3 centre = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  Vec3 bulge = Vec3::Zero();
  /// No place lies beyond these.
  Vec3 least = Vec3::Constant(-std::numeric_limits<double>::infinity());
  Vec3 most = Vec3::Constant(std::numeric_limits<double>::infinity());
};

struct ValueRange {
  double low = 0.0;
  double high = 0.0;
};

/// Bounds of an expression over a cell: no place of it has a value outside of them, but for
/// round-off; infinite where the bounds are not known. Affine forms with interval remainders (de
/// Figueiredo, Stolfi 2004): what they overestimate falls with the square of the cell where the
/// expression is smooth, and linear expressions are exact.
ValueRange range_over(const Expression& expression, const PlaceCell& cell);

} // namespace spricka::base
