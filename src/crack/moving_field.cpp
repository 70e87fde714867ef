// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/moving_field.hpp"

namespace spricka::crack {

using base::Vec3;

FrontAxesDerivatives::FrontAxesDerivatives(const FrontCoordinates& at) : section(at.r, at.theta) {
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
  [[nodiscard]] Tensor<3> with(const FrontAxesDerivatives::CoordinateGradients& slopes) const {
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

Tensor<3> front_auxiliary_gradient(std::size_t auxiliary, const FrontAxesDerivatives& axes,
                                   const FrontBody& body) {
  // Q (w_,y grad y + w_,z grad z) + Q' w grad s
  const SectionField w = section_field(auxiliary, axes.section, body.plane_strain_section());
  return Across{axes.Q * w.w_y, axes.Q * w.w_z, axes.dQ * w.w}.with(axes.grad);
}

AuxiliaryField<3> front_auxiliary_field(std::size_t auxiliary, const FrontAxesDerivatives& axes,
                                        const FrontBody& body) {
  const SectionField w = section_field(auxiliary, axes.section, body.plane_strain_section());
  // As in the gradient, with the slopes of the coordinates or with derivatives of them.
  const Across field_across{axes.Q * w.w_y, axes.Q * w.w_z, axes.dQ * w.w};
  AuxiliaryField<3> field;
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
