// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/williams.hpp"

#include "model/materials.hpp"

#include <cmath>
#include <numbers>

namespace spricka::crack {

namespace {

// u = sqrt(r / 2 pi) / (2 mu) g(theta) in the tip's axes; g and dg/dtheta for a unit K.
struct Angular {
  base::Vec2 g, dg;
};

Angular angular(double theta, int mode, double kappa) {
  const double c = std::cos(0.5 * theta);
  const double s = std::sin(0.5 * theta);
  const double C = std::cos(theta);
  const double S = std::sin(theta);
  // (crack.6), then (crack.7).
  if (mode == 1) {
    return {{c * (kappa - C), s * (kappa - C)},
            {-0.5 * s * (kappa - C) + c * S, 0.5 * c * (kappa - C) + s * S}};
  }
  return {{s * (kappa + 2.0 + C), -c * (kappa - 2.0 + C)},
          {0.5 * c * (kappa + 2.0 + C) - s * S, 0.5 * s * (kappa - 2.0 + C) + c * S}};
}

// The factor in front of g [length^0.5 / stress].
double amplitude(double r, const model::ElasticMaterial& m) {
  const double shear = m.E / (2.0 * (1.0 + m.nu));
  return std::sqrt(r / (2.0 * std::numbers::pi)) / (2.0 * shear);
}

} // namespace

Polar polar(const TipFrame& tip, const base::Vec2& at) {
  const base::Vec2 d = at - tip.x;
  const double x1 = d.dot(tip.e1);
  const double x2 = d.dot(tip.e2);
  return {std::hypot(x1, x2), std::atan2(x2, x1)};
}

Polar polar_on_face(const TipFrame& tip, const base::Vec2& at, const base::Vec2& n) {
  const Polar p = polar(tip, at);
  // On the faces theta is pi or -pi by round-off: the side that the body lies on decides.
  return {p.r, std::copysign(p.theta, -n.dot(tip.e2))};
}

double kolosov(double nu, model::StressState state) {
  return state == model::StressState::plane_stress ? (3.0 - nu) / (1.0 + nu) : 3.0 - 4.0 * nu;
}

Eigen::Matrix2d near_tip_gradient(const TipFrame& tip, const Polar& at, int mode,
                                  const model::ElasticMaterial& material,
                                  model::StressState state) {
  const auto [r, theta] = at;
  const Angular f = angular(theta, mode, kolosov(material.nu, state));
  const double a = amplitude(r, material) / r;
  const double C = std::cos(theta);
  const double S = std::sin(theta);
  // u_,r = u / 2r; u_,1 = C u_,r - S u_,theta / r; u_,2 = S u_,r + C u_,theta / r (crack.8)
  Eigen::Matrix2d local;
  local.col(0) = a * (0.5 * C * f.g - S * f.dg);
  local.col(1) = a * (0.5 * S * f.g + C * f.dg);
  Eigen::Matrix2d Q;
  Q << tip.e1, tip.e2;
  return Q * local * Q.transpose();
}

base::Vec2 near_tip_displacement(const TipFrame& tip, const Polar& at, int mode,
                                 const model::ElasticMaterial& material, model::StressState state) {
  const auto [r, theta] = at;
  const Angular f = angular(theta, mode, kolosov(material.nu, state));
  const base::Vec2 u = amplitude(r, material) * f.g;
  return u.x() * tip.e1 + u.y() * tip.e2;
}

} // namespace spricka::crack
