// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <vector>

namespace spricka::geometry {

/// Points of the plane with what each counts.
struct WeightedPoint {
  base::Vec2 x = base::Vec2::Zero();
  double weight = 1.0;
};

struct FittedCircle {
  base::Vec2 centre = base::Vec2::Zero();
  double radius = 0.0;
};

/// The circle through some points by least squares of |x - c|^2 - R^2 (Kasa 1976); exact where they
/// lie on one.
FittedCircle fit_circle(const std::vector<WeightedPoint>& points);

} // namespace spricka::geometry
