// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/circle_fit.hpp"

#include <Eigen/LU>

#include <cmath>

namespace spricka::geometry {

FittedCircle fit_circle(const std::vector<WeightedPoint>& points) {
  base::Vec2 mean = base::Vec2::Zero();
  double count = 0.0;
  for (const WeightedPoint& p : points) {
    mean += p.weight * p.x;
    count += p.weight;
  }
  mean /= count;
  // |y|^2 = 2 a . y + b with y = x - mean: normal equations for (2 a, b).
  // About the mean: squares of coordinates far from the origin would cancel.
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  base::Vec3 rhs = base::Vec3::Zero();
  for (const WeightedPoint& p : points) {
    const base::Vec2 y = p.x - mean;
    const base::Vec3 row(y.x(), y.y(), 1.0);
    A += p.weight * row * row.transpose();
    rhs += p.weight * y.squaredNorm() * row;
  }
  const base::Vec3 solution = A.fullPivLu().solve(rhs);
  const base::Vec2 a = 0.5 * solution.head<2>();
  return {mean + a, std::sqrt(solution[2] + a.squaredNorm())};
}

} // namespace spricka::geometry
