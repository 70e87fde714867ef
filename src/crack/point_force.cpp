// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/point_force.hpp"

#include "model/materials.hpp"

#include <cmath>
#include <numbers>

namespace spricka::crack {

namespace {

double shear_modulus(const model::ElasticMaterial& m) {
  return m.E / (2.0 * (1.0 + m.nu));
}

} // namespace

// u1 = -((kappa + 1) ln r + 2 sin^2 theta) / (8 pi mu),
// u2 = -((kappa - 1) theta - 2 sin theta cos theta) / (8 pi mu) along e1 and e2.
base::Vec2 point_force_displacement(const TipFrame& tip, const Polar& at, double unit,
                                    const model::ElasticMaterial& material,
                                    model::StressState state) {
  const double kappa = kolosov(material.nu, state);
  const double C = std::cos(at.theta);
  const double S = std::sin(at.theta);
  const double scale = -1.0 / (8.0 * std::numbers::pi * shear_modulus(material));
  const double u1 = scale * ((kappa + 1.0) * std::log(at.r / unit) + 2.0 * S * S);
  const double u2 = scale * ((kappa - 1.0) * at.theta - 2.0 * S * C);
  return u1 * tip.e1 + u2 * tip.e2;
}

Eigen::Matrix2d point_force_gradient(const TipFrame& tip, const Polar& at,
                                     const model::ElasticMaterial& material,
                                     model::StressState state) {
  const double kappa = kolosov(material.nu, state);
  const double C = std::cos(at.theta);
  const double S = std::sin(at.theta);
  // u_,1 and u_,2 by u_,r and u_,theta / r, as in williams.cpp.
  const double scale = -1.0 / (8.0 * std::numbers::pi * shear_modulus(material) * at.r);
  const base::Vec2 of_r((kappa + 1.0), 0.0);                                     // r u_,r
  const base::Vec2 of_theta(4.0 * S * C, (kappa - 1.0) - 2.0 * (C * C - S * S)); // u_,theta
  Eigen::Matrix2d local;
  local.col(0) = scale * (C * of_r - S * of_theta);
  local.col(1) = scale * (S * of_r + C * of_theta);
  Eigen::Matrix2d Q;
  Q << tip.e1, tip.e2;
  return Q * local * Q.transpose();
}

} // namespace spricka::crack
