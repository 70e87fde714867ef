// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/williams.hpp"

#include "model/materials.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace spricka::crack {

namespace {

// amplitude (r^power g(theta) + a ln r), g with its derivatives by theta.
struct AngularParts {
  double amplitude = 0.0, power = 0.0;
  base::Vec3 g = base::Vec3::Zero(), dg = base::Vec3::Zero(), ddg = base::Vec3::Zero();
  base::Vec3 a = base::Vec3::Zero();
};

// (crack.6), (crack.7) and mode 3, their products of cosines and sines resolved.
AngularParts near_front(std::size_t mode, const SectionPolarPoint& at, const SectionBody& body) {
  const double kappa = body.kappa;
  const auto [c1, s1, c3, s3] = std::array{at.c1, at.s1, at.c3, at.s3};
  AngularParts f;
  f.amplitude = 1.0 / (2.0 * body.mu * std::sqrt(2.0 * std::numbers::pi));
  f.power = 0.5;
  if (mode == 1) {
    f.g = {(kappa - 0.5) * c1 - 0.5 * c3, (kappa + 0.5) * s1 - 0.5 * s3, 0.0};
    f.dg = {-0.5 * (kappa - 0.5) * s1 + 0.75 * s3, 0.5 * (kappa + 0.5) * c1 - 0.75 * c3, 0.0};
    f.ddg = {-0.25 * (kappa - 0.5) * c1 + 1.125 * c3, -0.25 * (kappa + 0.5) * s1 + 1.125 * s3, 0.0};
  } else if (mode == 2) {
    f.g = {(kappa + 1.5) * s1 + 0.5 * s3, -(kappa - 1.5) * c1 - 0.5 * c3, 0.0};
    f.dg = {0.5 * (kappa + 1.5) * c1 + 0.75 * c3, 0.5 * (kappa - 1.5) * s1 + 0.75 * s3, 0.0};
    f.ddg = {-0.25 * (kappa + 1.5) * s1 - 1.125 * s3, 0.25 * (kappa - 1.5) * c1 + 1.125 * c3, 0.0};
  } else {
    f.g.z() = 4.0 * s1;
    f.dg.z() = 2.0 * c1;
    f.ddg.z() = -s1;
  }
  return f;
}

// (crack.24).
AngularParts line_force(const SectionPolarPoint& at, const SectionBody& body) {
  const double kappa = body.kappa;
  const double theta = at.theta;
  const double C = at.C * at.C - at.S * at.S; // of twice the angle
  const double S = 2.0 * at.C * at.S;
  AngularParts f;
  f.amplitude = -1.0 / (8.0 * std::numbers::pi * body.mu);
  f.a.x() = kappa + 1.0;
  f.g = {1.0 - C, (kappa - 1.0) * theta - S, 0.0};
  f.dg = {2.0 * S, kappa - 1.0 - 2.0 * C, 0.0};
  f.ddg = {4.0 * C, 4.0 * S, 0.0};
  return f;
}

} // namespace

PolarCoordinates polar_coordinates(const TipFrame& tip, const base::Vec2& at) {
  const base::Vec2 d = at - tip.x;
  const double x1 = d.dot(tip.e1);
  const double x2 = d.dot(tip.e2);
  return {std::hypot(x1, x2), std::atan2(x2, x1)};
}

PolarCoordinates polar_coordinates_on_face(const TipFrame& tip, const base::Vec2& at,
                                           const base::Vec2& n) {
  const PolarCoordinates p = polar_coordinates(tip, at);
  // On the faces theta is pi or -pi by round-off: the side that the body lies on decides.
  return {p.r, std::copysign(p.theta, -n.dot(tip.e2))};
}

double kolosov_constant(double nu, model::StressState state) {
  return state == model::StressState::plane_stress ? (3.0 - nu) / (1.0 + nu) : 3.0 - 4.0 * nu;
}

SectionBody make_section_body(const model::ElasticMaterial& material, model::StressState state,
                              double unit) {
  return {material.E / (2.0 * (1.0 + material.nu)), kolosov_constant(material.nu, state), unit};
}

SectionPolarPoint::SectionPolarPoint(double radius, double angle)
    : r(radius), theta(angle), c1(std::cos(0.5 * angle)), s1(std::sin(0.5 * angle)),
      C(c1 * c1 - s1 * s1), S(2.0 * c1 * s1), c3(C * c1 - S * s1), s3(S * c1 + C * s1) {}

SectionField section_field(std::size_t auxiliary, const SectionPolarPoint& at,
                           const SectionBody& body) {
  const bool force = auxiliary == line_force_auxiliary;
  const AngularParts f = force ? line_force(at, body) : near_front(auxiliary, at, body);
  const double C = at.C;
  const double S = at.S;
  const double p = f.power;
  // r^(p-1) Y and r^(p-1) Z are the derivatives by y and z, as (crack.8); they once more.
  const base::Vec3 Y = p * C * f.g - S * f.dg + C * f.a;
  const base::Vec3 dY = -p * S * f.g + (p - 1.0) * C * f.dg - S * f.ddg - S * f.a;
  const base::Vec3 Z = p * S * f.g + C * f.dg + S * f.a;
  const base::Vec3 dZ = p * C * f.g + (p - 1.0) * S * f.dg + C * f.ddg + C * f.a;
  const double zeroth = f.amplitude * (force ? 1.0 : std::sqrt(at.r)); // the powers 0 and 1/2
  const double first = zeroth / at.r;
  const double second = first / at.r;
  SectionField w;
  w.w = zeroth * f.g;
  if (force) {
    w.w += f.amplitude * std::log(at.r / body.unit) * f.a;
  }
  w.w_y = first * Y;
  w.w_z = first * Z;
  w.w_yy = second * ((p - 1.0) * C * Y - S * dY);
  w.w_yz = second * ((p - 1.0) * C * Z - S * dZ);
  w.w_zz = second * ((p - 1.0) * S * Z + C * dZ);
  return w;
}

Eigen::Matrix2d near_tip_gradient(const TipFrame& tip, const PolarCoordinates& at,
                                  std::size_t auxiliary, const SectionBody& body) {
  const SectionField f = section_field(auxiliary, {at.r, at.theta}, body);
  Eigen::Matrix2d local;
  local << f.w_y.head<2>(), f.w_z.head<2>();
  Eigen::Matrix2d Q;
  Q << tip.e1, tip.e2;
  return Q * local * Q.transpose();
}

base::Vec2 near_tip_displacement(const TipFrame& tip, const PolarCoordinates& at,
                                 std::size_t auxiliary, const SectionBody& body) {
  const base::Vec3 u = section_field(auxiliary, {at.r, at.theta}, body).w;
  return u.x() * tip.e1 + u.y() * tip.e2;
}

} // namespace spricka::crack
