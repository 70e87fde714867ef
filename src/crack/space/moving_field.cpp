// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/space/moving_field.hpp"

#include "crack/williams.hpp"
#include "model/materials.hpp"

#include <cmath>
#include <numbers>

namespace spricka::crack {

using base::Vec3;

namespace {

// amplitude (r^power g(theta) + a ln r), g with its derivatives by theta.
struct AngularParts {
  double amplitude = 0.0, power = 0.0;
  Vec3 g = Vec3::Zero(), dg = Vec3::Zero(), ddg = Vec3::Zero();
  Vec3 a = Vec3::Zero();
};

// (crack.6), (crack.7) and mode 3, their products of cosines and sines resolved.
AngularParts near_front(std::size_t mode, double theta, const FrontBody& body) {
  const double kappa = kolosov(body.nu, model::State::plane_strain);
  const double c1 = std::cos(0.5 * theta);
  const double s1 = std::sin(0.5 * theta);
  const double c3 = std::cos(1.5 * theta);
  const double s3 = std::sin(1.5 * theta);
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
AngularParts line_force(double theta, const FrontBody& body) {
  const double kappa = kolosov(body.nu, model::State::plane_strain);
  const double C = std::cos(2.0 * theta);
  const double S = std::sin(2.0 * theta);
  AngularParts f;
  f.amplitude = -1.0 / (8.0 * std::numbers::pi * body.mu);
  f.a.x() = kappa + 1.0;
  f.g = {1.0 - C, (kappa - 1.0) * theta - S, 0.0};
  f.dg = {2.0 * S, kappa - 1.0 - 2.0 * C, 0.0};
  f.ddg = {4.0 * C, 4.0 * S, 0.0};
  return f;
}

} // namespace

SectionField section_field(std::size_t partner, double r, double theta, const FrontBody& body) {
  const AngularParts f =
      partner == line_force_partner ? line_force(theta, body) : near_front(partner, theta, body);
  const double C = std::cos(theta);
  const double S = std::sin(theta);
  const double p = f.power;
  // r^(p-1) Y and r^(p-1) Z are the derivatives by y and z, as (crack.8); they once more.
  const Vec3 Y = p * C * f.g - S * f.dg + C * f.a;
  const Vec3 dY = -p * S * f.g + (p - 1.0) * C * f.dg - S * f.ddg - S * f.a;
  const Vec3 Z = p * S * f.g + C * f.dg + S * f.a;
  const Vec3 dZ = p * C * f.g + (p - 1.0) * S * f.dg + C * f.ddg + C * f.a;
  const double zeroth = f.amplitude * std::pow(r, p);
  const double first = zeroth / r;
  const double second = first / r;
  SectionField w;
  w.w = zeroth * f.g + f.amplitude * std::log(r / body.unit) * f.a;
  w.w_y = first * Y;
  w.w_z = first * Z;
  w.w_yy = second * ((p - 1.0) * C * Y - S * dY);
  w.w_yz = second * ((p - 1.0) * C * Z - S * dZ);
  w.w_zz = second * ((p - 1.0) * S * Z + C * dZ);
  return w;
}

TurningAxes::TurningAxes(const FrontPlace& at) {
  const mesh::FrontFrame& f = at.frame;
  Q << f.m, f.b, f.t;
  dQ << f.dm, f.db, f.dt;
  ddQ << at.ddm, at.ddb, at.ddt;
  const double along = f.dm.dot(f.t); // the axes' turn about b, about m, about t
  const double rise = f.db.dot(f.t);
  const double twist = f.dm.dot(f.b);
  const double d_along = at.ddm.dot(f.t) + f.dm.dot(f.dt);
  const double d_rise = at.ddb.dot(f.t) + f.db.dot(f.dt);
  const double d_twist = at.ddm.dot(f.b) + f.dm.dot(f.db);
  const double J = 1.0 + along * at.y + rise * at.z;
  const double J_s = d_along * at.y + d_rise * at.z;
  grad.s = f.t / J;
  by_s.s = f.dt / J - J_s / (J * J) * f.t;
  by_y.s = -along / (J * J) * f.t;
  by_z.s = -rise / (J * J) * f.t;
  grad.y = f.m + twist * at.z * grad.s;
  by_s.y = f.dm + d_twist * at.z * grad.s + twist * at.z * by_s.s;
  by_y.y = twist * at.z * by_y.s;
  by_z.y = twist * grad.s + twist * at.z * by_z.s;
  grad.z = f.b - twist * at.y * grad.s;
  by_s.z = f.db - d_twist * at.y * grad.s - twist * at.y * by_s.s;
  by_y.z = -twist * grad.s - twist * at.y * by_y.s;
  by_z.z = -twist * at.y * by_z.s;
}

MovingField moving_field(std::size_t partner, const FrontPlace& at, const TurningAxes& axes,
                         const FrontBody& body) {
  const SectionField w = section_field(partner, at.r, at.theta, body);
  using Section = Eigen::Matrix<double, 3, 2>;
  const auto pair = [](const Vec3& one, const Vec3& other) {
    Section both;
    both << one, other;
    return both;
  };
  const Section across = axes.Q * pair(w.w_y, w.w_z);
  const Vec3 turned = axes.dQ * w.w;
  // Q (w_,y grad y + w_,z grad z) + Q' w grad s, with these gradients or with derivatives of them.
  const auto gradient = [&](const TurningAxes::Slopes& by) -> Tensor<3> {
    return across * pair(by.y, by.z).transpose() + turned * by.s.transpose();
  };
  const Section grad = pair(axes.grad.y, axes.grad.z);
  MovingField field;
  field.H = gradient(axes.grad);
  field.sigma = isotropic_stress(body, field.H);
  // Derivatives of H by s, y and z (crack_space.5).
  const Tensor<3> H_s = axes.dQ * pair(w.w_y, w.w_z) * grad.transpose() +
                        axes.ddQ * w.w * axes.grad.s.transpose() + gradient(axes.by_s);
  const Tensor<3> H_y = axes.Q * pair(w.w_yy, w.w_yz) * grad.transpose() +
                        axes.dQ * w.w_y * axes.grad.s.transpose() + gradient(axes.by_y);
  const Tensor<3> H_z = axes.Q * pair(w.w_yz, w.w_zz) * grad.transpose() +
                        axes.dQ * w.w_z * axes.grad.s.transpose() + gradient(axes.by_z);
  field.divergence = isotropic_stress(body, H_s) * axes.grad.s +
                     isotropic_stress(body, H_y) * axes.grad.y +
                     isotropic_stress(body, H_z) * axes.grad.z;
  return field;
}

} // namespace spricka::crack
