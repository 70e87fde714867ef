// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/mode_kernel.hpp"

#include <Eigen/LU>

namespace spricka::estimate {

ModeGradients mode_gradients(const PlaneModes& modes, const fe::AnyNodeVectors<2>& X,
                             const shape::Point<2>& r, const Eigen::Matrix2d& J,
                             const SideModeFrames& sides) {
  const Eigen::Matrix2d inverse = J.inverse();
  PlaneModes::CoordinateGradients d = modes.dpsi(r).lazyProduct(inverse);
  for (int s = 0; s < modes.sides; ++s) {
    d.row(s) *= sides.sign[static_cast<std::size_t>(s)];
  }
  ModeGradients G = ModeGradients::Zero(4, modes.freedoms());
  for (int m = 0; m < modes.count; ++m) {
    G.block<2, 1>(0, 2 * m) = d.row(m).transpose();
    G.block<2, 1>(2, 2 * m + 1) = d.row(m).transpose();
  }
  if (!sides.any_framed()) {
    return G;
  }
  const PlaneModes::Values psi = modes.psi(r);
  for (int s = 0; s < modes.sides; ++s) {
    if (!sides.framed[static_cast<std::size_t>(s)]) {
      continue;
    }
    const SideFrame frame = side_frame(side_node_coordinates(modes, X, s), modes.along(r, s));
    // On a curved side the axis turns: grad(psi axis) = axis grad psi + psi axis' grad t.
    const Eigen::RowVector2d turn =
        sides.sign[static_cast<std::size_t>(s)] * psi[s] * (modes.d_along(s) * inverse);
    for (int k = 0; k < 2; ++k) {
      const base::Vec2& axis = frame.axis[static_cast<std::size_t>(k)];
      const base::Vec2& slope = frame.slope[static_cast<std::size_t>(k)];
      for (int i = 0; i < 2; ++i) {
        G.block<2, 1>(2 * i, 2 * s + k) = (axis[i] * d.row(s) + slope[i] * turn).transpose();
      }
    }
  }
  return G;
}

ModeNumbers mode_x_displacements(const PlaneModes& modes, const fe::AnyNodeVectors<2>& X,
                                 const shape::Point<2>& r, const SideModeFrames& sides) {
  const PlaneModes::Values psi = modes.psi(r);
  ModeNumbers along = ModeNumbers::Zero(modes.freedoms());
  for (int m = 0; m < modes.count; ++m) {
    if (m >= modes.sides) {
      along[2 * m] = psi[m];
      continue;
    }
    const auto s = static_cast<std::size_t>(m);
    along[2 * m] = sides.sign[s] * psi[m];
    if (sides.framed[s]) {
      const SideFrame frame = side_frame(side_node_coordinates(modes, X, m), modes.along(r, m));
      along[2 * m + 1] = along[2 * m] * frame.axis[1].x();
      along[2 * m] *= frame.axis[0].x();
    }
  }
  return along;
}

namespace {

// Strains xx yy xy of gradients as above.
template <int freedoms> Eigen::Matrix<double, 3, freedoms> strains_of(const ModeGradients& G) {
  Eigen::Matrix<double, 3, freedoms> B;
  B.row(0) = G.row(0);
  B.row(1) = G.row(3);
  B.row(2) = G.row(1) + G.row(2);
  return B;
}

} // namespace

template <shape::PlaneShape S>
EnrichedStiffness<S>::EnrichedStiffness(const fe::NodeVectors<S>& X, const fe::ConstitutiveLaw& law,
                                        const SideModeFrames& sides) {
  // Moments know modes along x and y only; in a frame the directions change from point to point.
  if (law.axisymmetric) {
    about_axis(X, law, sides);
  } else if (sides.any_framed()) {
    by_strains(X, law, sides);
  } else {
    by_moments(X, law, sides);
  }
}

template <shape::PlaneShape S>
void EnrichedStiffness<S>::by_strains(const fe::NodeVectors<S>& X, const fe::ConstitutiveLaw& law,
                                      const SideModeFrames& sides) {
  Eigen::Matrix3d D = Eigen::Matrix3d::Zero();
  D.topLeftCorner<2, 2>().setConstant(law.lambda);
  // (fe.3): mu on all, another mu on the normal strains.
  D.diagonal().array() += law.mu;
  D.diagonal().head<2>().array() += law.mu;
  ee.setZero();
  ep.setZero();
  const PlaneModes& of = PlaneModes::for_type(S::type);
  const fe::AnyNodeVectors<2> nodes = X;
  for (const auto& point : shape::quadrature<S>(Modes<S>::degree)) {
    const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
    const double w = point.weight * at.det * law.thickness;
    const Eigen::Matrix<double, 3, mode_freedoms<S>> B =
        strains_of<mode_freedoms<S>>(mode_gradients(of, nodes, point.r, at.J, sides));
    const Eigen::Matrix<double, 3, mode_freedoms<S>> DB = (w * D) * B;
    ee.noalias() += B.transpose() * DB;
    ep.noalias() += DB.transpose() * fe::strain_matrix<S>(at.dNdx);
  }
}

// As by_strains, with the strain round the axis as the fourth.
template <shape::PlaneShape S>
void EnrichedStiffness<S>::about_axis(const fe::NodeVectors<S>& X, const fe::ConstitutiveLaw& law,
                                      const SideModeFrames& sides) {
  Eigen::Matrix4d D = Eigen::Matrix4d::Zero();
  D.topLeftCorner<2, 2>().setConstant(law.lambda);
  D.block<2, 1>(0, 3).setConstant(law.lambda);
  D.block<1, 2>(3, 0).setConstant(law.lambda);
  D(3, 3) = law.lambda;
  D.diagonal() += law.mu * Eigen::Vector4d(2.0, 2.0, 1.0, 2.0);
  ee.setZero();
  ep.setZero();
  const PlaneModes& of = PlaneModes::for_type(S::type);
  const fe::AnyNodeVectors<2> nodes = X;
  for (const auto& point : shape::quadrature<S>(Modes<S>::degree)) {
    const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
    const fe::HoopStrain<S> hoop(X, law, point.r);
    const double w = point.weight * at.det * law.depth(hoop.x);
    Eigen::Matrix<double, 4, mode_freedoms<S>> B;
    B.template topRows<3>() =
        strains_of<mode_freedoms<S>>(mode_gradients(of, nodes, point.r, at.J, sides));
    B.row(3) = mode_x_displacements(of, nodes, point.r, sides).transpose() / hoop.x;
    Eigen::Matrix<double, 4, 2 * S::nodes> P = Eigen::Matrix<double, 4, 2 * S::nodes>::Zero();
    P.template topRows<3>() = fe::strain_matrix<S>(at.dNdx);
    for (int n = 0; n < S::nodes; ++n) {
      P(3, 2 * n) = hoop.h[n];
    }
    const Eigen::Matrix<double, 4, mode_freedoms<S>> DB = (w * D) * B;
    ee.noalias() += B.transpose() * DB;
    ep.noalias() += DB.transpose() * P;
  }
}

// As fe::element_stiffness: with the moments M_pq = integral of d_p d_q^T dV of the gradients the
// block of directions a, b is lambda M_ab + mu M_ba + mu delta_ab sum_p M_pp.
template <shape::PlaneShape S>
void EnrichedStiffness<S>::by_moments(const fe::NodeVectors<S>& X, const fe::ConstitutiveLaw& law,
                                      const SideModeFrames& sides) {
  using Square = Eigen::Matrix<double, modes, modes>;
  using Mixed = Eigen::Matrix<double, modes, S::nodes>;
  std::array<std::array<Square, 2>, 2> E;
  std::array<std::array<Mixed, 2>, 2> P;
  for (std::size_t p = 0; p < 2; ++p) {
    for (std::size_t q = 0; q < 2; ++q) {
      E[p][q].setZero();
      P[p][q].setZero();
    }
  }
  for (const auto& point : shape::quadrature<S>(Modes<S>::degree)) {
    const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
    Eigen::Matrix<double, modes, 2> d = Modes<S>::dpsi(point.r) * at.J.inverse();
    for (int s = 0; s < Modes<S>::sides; ++s) {
      d.row(s) *= sides.sign[static_cast<std::size_t>(s)];
    }
    const Eigen::Matrix<double, modes, 2> weighted = (point.weight * at.det * law.thickness) * d;
    for (int p = 0; p < 2; ++p) {
      for (int q = 0; q < 2; ++q) {
        const auto i = static_cast<std::size_t>(p);
        const auto j = static_cast<std::size_t>(q);
        // Rows are modes and columns nodes: these moments have no symmetry, those of E have (fe.7).
        P[i][j].noalias() += weighted.col(p) * at.dNdx.col(q).transpose();
        if (p <= q) {
          E[i][j].noalias() += weighted.col(p) * d.col(q).transpose();
        }
      }
    }
  }
  E[1][0] = E[0][1].transpose();
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) {
      const auto i = static_cast<std::size_t>(a);
      const auto j = static_cast<std::size_t>(b);
      Square e = law.lambda * E[i][j] + law.mu * E[j][i];
      Mixed m = law.lambda * P[i][j] + law.mu * P[j][i];
      if (a == b) {
        e += law.mu * (E[0][0] + E[1][1]);
        m += law.mu * (P[0][0] + P[1][1]);
      }
      for (int k = 0; k < modes; ++k) {
        for (int l = 0; l < modes; ++l) {
          ee(2 * k + a, 2 * l + b) = e(k, l);
        }
        for (int l = 0; l < S::nodes; ++l) {
          ep(2 * k + a, 2 * l + b) = m(k, l);
        }
      }
    }
  }
}

template struct EnrichedStiffness<shape::Trimc6>;
template struct EnrichedStiffness<shape::Quamc8>;
template struct EnrichedStiffness<shape::Quamc9>;

} // namespace spricka::estimate
