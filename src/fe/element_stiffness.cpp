// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/element.hpp"

#include <array>

namespace spricka::fe {

namespace {

/// Moments of the shape function gradients, M_pq = integral of dN/dx_p (dN/dx_q)^T dV for p <= q,
/// and for axisymmetric elements those with the hoop function h = N / x: H = integral of h h^T dV,
/// L_p = integral of h (dN/dx_p)^T dV.
template <shape::ElementShape S> struct Moments {
  static constexpr int dim = S::dim;
  using Square = Eigen::Matrix<double, S::nodes, S::nodes>;
  std::array<std::array<Square, dim>, dim> M;
  Square H;
  std::array<Square, dim> L;

  Moments(const NodeVectors<S>& X, const ConstitutiveLaw& law) {
    for (std::size_t p = 0; p < dim; ++p) {
      for (std::size_t q = p; q < dim; ++q) {
        M[p][q].setZero();
      }
      L[p].setZero();
    }
    H.setZero();
    for (const auto& point : stiffness_rule<S>(law)) {
      const Jacobian<S> at = jacobian<S>(X, point.r);
      const HoopStrain<S> hoop(X, law, point.r);
      const double w = point.weight * at.det * law.depth(hoop.x);
      const Gradients<S> weighted = w * at.dNdx;
      for (int p = 0; p < dim; ++p) {
        for (int q = p; q < dim; ++q) {
          M[static_cast<std::size_t>(p)][static_cast<std::size_t>(q)].noalias() +=
              weighted.col(p) * at.dNdx.col(q).transpose();
        }
      }
      if (law.is_axisymmetric<dim>()) {
        H.noalias() += (w * hoop.h) * hoop.h.transpose();
        for (int p = 0; p < dim; ++p) {
          L[static_cast<std::size_t>(p)].noalias() += hoop.h * weighted.col(p).transpose();
        }
      }
    }
  }
};

/// Adds what the hoop strain h^T u_x brings to a stiffness.
template <shape::ElementShape S>
void add_hoop(const Moments<S>& moments, double lambda, double mu, ElementMatrix<S>& Ke) {
  constexpr int dim = S::dim;
  for (int i = 0; i < S::nodes; ++i) {
    for (int j = 0; j < S::nodes; ++j) {
      // (fe.10).
      Ke(dim * i, dim * j) += (lambda + 2.0 * mu) * moments.H(i, j);
      for (int b = 0; b < dim; ++b) {
        const auto& L = moments.L[static_cast<std::size_t>(b)];
        Ke(dim * i, dim * j + b) += lambda * L(i, j);
        Ke(dim * j + b, dim * i) += lambda * L(i, j);
      }
    }
  }
}

/// Adds A B, which is symmetric but for round-off, of matrices of any size: compiled once.
void add_volume_part(const base::Matrix& A, const base::Matrix& B, Eigen::Ref<base::Matrix> Ke) {
  Ke.noalias() += A * B;
  Ke = (0.5 * (Ke + Ke.transpose())).eval(); // symmetric to the last bit
}

} // namespace

template <shape::ElementShape S>
ElementMatrix<S> element_stiffness(const NodeVectors<S>& X, const ConstitutiveLaw& law) {
  constexpr int dim = S::dim;
  const Moments<S> moments(X, law);
  const auto& M = moments.M;
  const double lambda = law.projected ? 0.0 : law.lambda;
  const double mu = law.mu;
  // (fe.8); where the dilatation is projected lambda comes in by (fe.15).
  typename Moments<S>::Square trace = M[0][0];
  for (std::size_t p = 1; p < dim; ++p) {
    trace += M[p][p];
  }
  ElementMatrix<S> Ke;
  for (int i = 0; i < S::nodes; ++i) {
    for (int j = 0; j < S::nodes; ++j) {
      for (int a = 0; a < dim; ++a) {
        const auto p = static_cast<std::size_t>(a);
        Ke(dim * i + a, dim * j + a) = (lambda + mu) * M[p][p](i, j) + mu * trace(i, j);
        for (int b = a + 1; b < dim; ++b) {
          const auto q = static_cast<std::size_t>(b);
          const double k = lambda * M[p][q](i, j) + mu * M[p][q](j, i);
          Ke(dim * i + a, dim * j + b) = k;
          Ke(dim * j + b, dim * i + a) = k;
        }
      }
    }
  }
  if (law.is_axisymmetric<dim>()) {
    add_hoop<S>(moments, lambda, mu, Ke);
  }
  if (law.projected) {
    const ProjectedDilatation<S> theta(S{}, X, law);
    add_volume_part(law.lambda * theta.C.transpose() * theta.G.inverse(), theta.C, Ke);
  }
  return Ke;
}

#define STIFFNESS(S)                                                                               \
  template ElementMatrix<S> element_stiffness<S>(const NodeVectors<S>&, const ConstitutiveLaw&);
SPRICKA_EACH_SHAPE(STIFFNESS)

} // namespace spricka::fe
