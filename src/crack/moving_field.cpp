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

struct SectionFields {
  VectorOfFields<3> w, w_y, w_z, w_yy, w_yz, w_zz;
};

SectionFields section_fields(const SectionPolarPoint& at, const FrontBody& body) {
  SectionFields all;
  const SectionBody section = body.plane_strain_section();
  for (Eigen::Index k = 0; k < OfFields<3>::SizeAtCompileTime; ++k) {
    const SectionField f = section_field(static_cast<std::size_t>(k) + 1, at, section);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto c = static_cast<Eigen::Index>(i);
      all.w[i][k] = f.w[c];
      all.w_y[i][k] = f.w_y[c];
      all.w_z[i][k] = f.w_z[c];
      all.w_yy[i][k] = f.w_yy[c];
      all.w_yz[i][k] = f.w_yz[c];
      all.w_zz[i][k] = f.w_zz[c];
    }
  }
  return all;
}

// Q v.
VectorOfFields<3> turned(const Tensor<3>& Q, const VectorOfFields<3>& v) {
  VectorOfFields<3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    out[i] = Q(row, 0) * v[0] + Q(row, 1) * v[1] + Q(row, 2) * v[2];
  }
  return out;
}

// With slopes of the coordinates: y (x) slopes.y + z (x) slopes.z + s (x) slopes.s.
struct Across {
  using Slopes = FrontAxesDerivatives::CoordinateGradients;
  VectorOfFields<3> y, z, s;

  [[nodiscard]] TensorOfFields<3> with(const Slopes& slopes) const {
    TensorOfFields<3> sum;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto c = static_cast<Eigen::Index>(j);
      for (std::size_t i = 0; i < 3; ++i) {
        sum[j][i] = slopes.y[c] * y[i] + slopes.z[c] * z[i] + slopes.s[c] * s[i];
      }
    }
    return sum;
  }
  // Of two with slopes of their own.
  [[nodiscard]] TensorOfFields<3> with(const Slopes& slopes, const Across& more,
                                       const Slopes& of_more) const {
    TensorOfFields<3> sum;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto c = static_cast<Eigen::Index>(j);
      for (std::size_t i = 0; i < 3; ++i) {
        sum[j][i] = slopes.y[c] * y[i] + slopes.z[c] * z[i] + slopes.s[c] * s[i] +
                    of_more.y[c] * more.y[i] + of_more.z[c] * more.z[i] + of_more.s[c] * more.s[i];
      }
    }
    return sum;
  }
};

// Adds the stress of A times g.
void add_stress_times(const FrontBody& body, const TensorOfFields<3>& A, const Vec3& g,
                      VectorOfFields<3>& sum) {
  const OfFields<3> pressure = body.lambda * (A[0][0] + A[1][1] + A[2][2]);
  const Vec3 shear = body.mu * g;
  for (std::size_t i = 0; i < 3; ++i) {
    sum[i] += pressure * g[static_cast<Eigen::Index>(i)] + (A[0][i] + A[i][0]) * shear[0] +
              (A[1][i] + A[i][1]) * shear[1] + (A[2][i] + A[i][2]) * shear[2];
  }
}

} // namespace

Tensor<3> front_auxiliary_gradient(std::size_t auxiliary, const FrontAxesDerivatives& axes,
                                   const FrontBody& body) {
  // Q (w_,y grad y + w_,z grad z) + Q' w grad s
  const SectionField w = section_field(auxiliary, axes.section, body.plane_strain_section());
  const Vec3 y = axes.Q * w.w_y;
  const Vec3 z = axes.Q * w.w_z;
  const Vec3 s = axes.dQ * w.w;
  Tensor<3> H;
  for (Eigen::Index j = 0; j < 3; ++j) { // products of fixed size would be matrices of their own
    H.col(j) = axes.grad.y[j] * y + axes.grad.z[j] * z + axes.grad.s[j] * s;
  }
  return H;
}

FrontAuxiliaryValues front_auxiliary_values(const FrontAxesDerivatives& axes,
                                            const FrontBody& body) {
  const SectionFields w = section_fields(axes.section, body);
  // As in the gradient, with the slopes of the coordinates or with derivatives of them.
  const Across across{turned(axes.Q, w.w_y), turned(axes.Q, w.w_z), turned(axes.dQ, w.w)};
  const TensorOfFields<3> H = across.with(axes.grad);
  // Derivatives of H by s, y and z (crack_space.5).
  const VectorOfFields<3> mixed = turned(axes.Q, w.w_yz);
  const VectorOfFields<3> turned_y = turned(axes.dQ, w.w_y);
  const VectorOfFields<3> turned_z = turned(axes.dQ, w.w_z);
  const Across by_s{turned_y, turned_z, turned(axes.ddQ, w.w)};
  const Across by_y{turned(axes.Q, w.w_yy), mixed, turned_y};
  const Across by_z{mixed, turned(axes.Q, w.w_zz), turned_z};
  VectorOfFields<3> divergence{OfFields<3>::Zero(), OfFields<3>::Zero(), OfFields<3>::Zero()};
  add_stress_times(body, by_s.with(axes.grad, across, axes.by_s), axes.grad.s, divergence);
  add_stress_times(body, by_y.with(axes.grad, across, axes.by_y), axes.grad.y, divergence);
  add_stress_times(body, by_z.with(axes.grad, across, axes.by_z), axes.grad.z, divergence);
  return {H, divergence};
}

AuxiliaryField<3> front_auxiliary_field(std::size_t auxiliary, const FrontAxesDerivatives& axes,
                                        const FrontBody& body) {
  const FrontAuxiliaryValues all = front_auxiliary_values(axes, body);
  const auto k = static_cast<Eigen::Index>(auxiliary - 1);
  AuxiliaryField<3> w;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    w.divergence[row] = all.divergence[i][k];
    for (std::size_t j = 0; j < 3; ++j) {
      w.H(row, static_cast<Eigen::Index>(j)) = all.H[j][i][k];
    }
  }
  w.sigma = isotropic_stress(body, w.H);
  return w;
}

} // namespace spricka::crack
