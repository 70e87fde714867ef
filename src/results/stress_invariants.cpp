// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/stress_invariants.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace spricka::results {

double von_mises(const Stress& s) {
  const double a = s[0] - s[1];
  const double b = s[1] - s[2];
  const double c = s[2] - s[0];
  const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * shear);
}

std::array<double, 3> principal_stresses(const Stress& s) {
  Eigen::Matrix3d tensor;
  tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& value = solver.eigenvalues(); // ascending
  return {value[2], value[1], value[0]};
}

} // namespace spricka::results
