// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space_dual.hpp"

#include <Eigen/Eigenvalues>

namespace spricka::contact {

namespace {

constexpr double least_moment = 1e-8; // of a sliver's hats, scaled: they are one function there

} // namespace

Eigen::Matrix3d dual_hat_weights(const Eigen::Matrix3d& moment) {
  const Eigen::Vector3d area = moment.rowwise().sum();
  const Eigen::Vector3d scale = moment.diagonal().cwiseSqrt();
  if (!(scale.minCoeff() > 0.0)) {
    return Eigen::Matrix3d::Zero();
  }
  const Eigen::Vector3d unscale = scale.cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
      Eigen::Matrix3d(unscale.asDiagonal() * moment * unscale.asDiagonal()));
  Eigen::Vector3d inverse = eigen.eigenvalues();
  const double least = least_moment * inverse.maxCoeff();
  inverse = inverse.unaryExpr([&](double v) { return v > least ? 1.0 / v : 0.0; });
  const Eigen::Matrix3d pseudo =
      eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
  return area.cwiseProduct(unscale).asDiagonal() * pseudo * unscale.asDiagonal();
}

} // namespace spricka::contact
