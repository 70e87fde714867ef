// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/space/moving_field.hpp"

#include "crack/williams.hpp"
#include "model/materials.hpp"

#include <array>
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
AngularParts near_front(std::size_t mode, const SectionPolarPoint& at, const FrontBody& body) {
  const double kappa = kolosov(body.nu, model::StressState::plane_strain);
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
AngularParts line_force(const SectionPolarPoint& at, const FrontBody& body) {
  const double kappa = kolosov(body.nu, model::StressState::plane_strain);
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

SectionPolarPoint::SectionPolarPoint(double radius, double angle)
    : r(radius), theta(angle), c1(std::cos(0.5 * angle)), s1(std::sin(0.5 * angle)),
      C(c1 * c1 - s1 * s1), S(2.0 * c1 * s1), c3(C * c1 - S * s1), s3(S * c1 + C * s1) {}

SectionField section_field(std::size_t auxiliary, const SectionPolarPoint& at,
                           const FrontBody& body) {
  const bool force = auxiliary == line_force_auxiliary;
  const AngularParts f = force ? line_force(at, body) : near_front(auxiliary, at, body);
  const double C = at.C;
  const double S = at.S;
  const double p = f.power;
  // r^(p-1) Y and r^(p-1) Z are the derivatives by y and z, as (crack.8); they once more.
  const Vec3 Y = p * C * f.g - S * f.dg + C * f.a;
  const Vec3 dY = -p * S * f.g + (p - 1.0) * C * f.dg - S * f.ddg - S * f.a;
  const Vec3 Z = p * S * f.g + C * f.dg + S * f.a;
  const Vec3 dZ = p * C * f.g + (p - 1.0) * S * f.dg + C * f.ddg + C * f.a;
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

TurningAxes::TurningAxes(const FrontCoordinates& at) : section(at.r, at.theta) {
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

namespace {

// by_y (x) slopes.y + by_z (x) slopes.z + by_s (x) slopes.s, column by column: products of fixed
// size would each become a matrix of its own.
struct Across {
  Vec3 y, z, s;
  [[nodiscard]] Tensor<3> with(const TurningAxes::CoordinateGradients& slopes) const {
    Tensor<3> sum;
    for (Eigen::Index j = 0; j < 3; ++j) {
      sum.col(j) = slopes.y[j] * y + slopes.z[j] * z + slopes.s[j] * s;
    }
    return sum;
  }
};

// The stress of A, times g.
Vec3 stress_times(const FrontBody& body, const Tensor<3>& A, const Vec3& g) {
  const Vec3 Ag = g[0] * A.col(0) + g[1] * A.col(1) + g[2] * A.col(2);
  const Vec3 transposed(A.col(0).dot(g), A.col(1).dot(g), A.col(2).dot(g));
  return body.lambda * A.trace() * g + body.mu * (Ag + transposed);
}

} // namespace

FrontAuxiliaryField front_auxiliary_field(std::size_t auxiliary, const TurningAxes& axes,
                                          const FrontBody& body) {
  const SectionField w = section_field(auxiliary, axes.section, body);
  // Q (w_,y grad y + w_,z grad z) + Q' w grad s, with these gradients or with derivatives of them.
  const Across field_across{axes.Q * w.w_y, axes.Q * w.w_z, axes.dQ * w.w};
  FrontAuxiliaryField field;
  field.H = field_across.with(axes.grad);
  field.sigma = isotropic_stress(body, field.H);
  // Derivatives of H by s, y and z (crack_space.5).
  const Vec3 mixed = axes.Q * w.w_yz;
  const Vec3 turned_y = axes.dQ * w.w_y;
  const Vec3 turned_z = axes.dQ * w.w_z;
  const Tensor<3> H_s =
      Across{turned_y, turned_z, axes.ddQ * w.w}.with(axes.grad) + field_across.with(axes.by_s);
  const Tensor<3> H_y =
      Across{axes.Q * w.w_yy, mixed, turned_y}.with(axes.grad) + field_across.with(axes.by_y);
  const Tensor<3> H_z =
      Across{mixed, axes.Q * w.w_zz, turned_z}.with(axes.grad) + field_across.with(axes.by_z);
  field.divergence = stress_times(body, H_s, axes.grad.s) + stress_times(body, H_y, axes.grad.y) +
                     stress_times(body, H_z, axes.grad.z);
  return field;
}

} // namespace spricka::crack
