// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/dilatation.hpp"
#include "fe/jacobian.hpp"
#include "fe/law.hpp"

#include <array>
#include <span>

/// Kernels of one element, on fixed-size matrices; nothing here allocates. Freedom c of local node
/// i is row dim * i + c of an element matrix.
namespace spricka::fe {

/// eps = B u with u by node [components(dim), dim * nodes].
template <shape::Shape S>
Eigen::Matrix<double, components(S::dim), S::dim * S::nodes>
strain_matrix(const Gradients<S>& dNdx) {
  Eigen::Matrix<double, components(S::dim), S::dim * S::nodes> B;
  B.setZero();
  for (int i = 0; i < S::nodes; ++i) {
    const int k = S::dim * i;
    for (int c = 0; c < S::dim; ++c) {
      B(c, k + c) = dNdx(i, c);
    }
    // Shear rows: xy, then yz and zx in space.
    for (int row = S::dim; row < components(S::dim); ++row) {
      const int a = row - S::dim;
      const int b = (a + 1) % S::dim;
      B(row, k + a) = dNdx(i, b);
      B(row, k + b) = dNdx(i, a);
    }
  }
  return B;
}

/// Strain of a displacement gradient H = du/dx = U dNdx.
template <int dim> Strain<dim> strain(const Eigen::Matrix<double, dim, dim>& H) {
  Strain<dim> eps;
  eps.template head<dim>() = H.diagonal();
  for (int row = dim; row < components(dim); ++row) {
    const int a = row - dim;
    const int b = (a + 1) % dim;
    eps[row] = H(a, b) + H(b, a);
  }
  return eps;
}

/// A stress vector as a symmetric tensor.
template <int dim> Eigen::Matrix<double, dim, dim> stress_tensor(const Strain<dim>& sigma) {
  Eigen::Matrix<double, dim, dim> T;
  T.diagonal() = sigma.template head<dim>();
  for (int row = dim; row < components(dim); ++row) {
    const int a = row - dim;
    const int b = (a + 1) % dim;
    T(a, b) = T(b, a) = sigma[row];
  }
  return T;
}

/// Moments of the shape function gradients, M_pq = integral of dN/dx_p (dN/dx_q)^T dV for p <= q,
/// and for axisymmetric elements those with the hoop function h = N / x: H = integral of h h^T dV,
/// L_p = integral of h (dN/dx_p)^T dV.
template <shape::ElementShape S> struct Moments {
  static constexpr int dim = S::dim;
  using Square = Eigen::Matrix<double, S::nodes, S::nodes>;
  std::array<std::array<Square, dim>, dim> M;
  Square H;
  std::array<Square, dim> L;

  Moments(const NodeVectors<S>& X, const Law& law) {
    for (std::size_t p = 0; p < dim; ++p) {
      for (std::size_t q = p; q < dim; ++q) {
        M[p][q].setZero();
      }
      L[p].setZero();
    }
    H.setZero();
    for (const auto& point : stiffness_rule<S>(law)) {
      const Jacobian<S> at = jacobian<S>(X, point.r);
      const Hoop<S> hoop(X, law, point.r);
      const double w = point.weight * at.det * law.depth(hoop.x);
      const Gradients<S> weighted = w * at.dNdx;
      for (int p = 0; p < dim; ++p) {
        for (int q = p; q < dim; ++q) {
          M[static_cast<std::size_t>(p)][static_cast<std::size_t>(q)].noalias() +=
              weighted.col(p) * at.dNdx.col(q).transpose();
        }
      }
      if (law.axisymmetric) {
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
      Ke(dim * i, dim * j) += (lambda + 2.0 * mu) * moments.H(i, j);
      for (int b = 0; b < dim; ++b) {
        const auto& L = moments.L[static_cast<std::size_t>(b)];
        Ke(dim * i, dim * j + b) += lambda * L(i, j);
        Ke(dim * j + b, dim * i) += lambda * L(i, j);
      }
    }
  }
}

/// Ke = integral of B^T D B dV [force/length] from nodal coordinates X [dim, nodes]. With the
/// moments M the block of directions a, b is lambda M_ab + mu M_ba + mu delta_ab sum_p M_pp: a
/// quarter of the work of the triple product. Axisymmetric elements add the hoop strain, nearly
/// incompressible ones take lambda with the projected dilatation.
template <shape::ElementShape S>
ElementMatrix<S> element_stiffness(const NodeVectors<S>& X, const Law& law) {
  constexpr int dim = S::dim;
  const Moments<S> moments(X, law);
  const auto& M = moments.M;
  const double lambda = law.projected ? 0.0 : law.lambda;
  const double mu = law.mu;
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
  if (law.axisymmetric) {
    add_hoop<S>(moments, lambda, mu, Ke);
  }
  if (law.projected) {
    const Dilatation<S> theta(X, law);
    Ke.noalias() += law.lambda * theta.C.transpose() * theta.G.inverse() * theta.C;
    Ke = (0.5 * (Ke + Ke.transpose())).eval(); // symmetric to the last bit
  }
  return Ke;
}

/// Volume change at each point: div u with the hoop strain, or its projection.
template <shape::ElementShape S> struct VolumeChange {
  const Law& law;
  typename Dilatation<S>::Modes projected;

  VolumeChange(const NodeVectors<S>& X, const Law& law_, const NodeVectors<S>& U) : law(law_) {
    projected.setZero();
    if (law.projected) {
      projected = Dilatation<S>(X, law).of(U.reshaped());
    }
  }
  [[nodiscard]] double at(const shape::Point<S::dim>& r, double plain) const {
    return law.projected ? Dilatation<S>::phi(r).dot(projected) : plain;
  }
};

/// Nodal forces Ke U of displacements U, both [dim, nodes], without forming Ke. With H = (U dN)
/// J^-1 and F = w T J^-T dN^T no derivative with respect to x is formed at the nodes.
template <shape::ElementShape S>
NodeVectors<S> element_force(const NodeVectors<S>& X, const Law& law, const NodeVectors<S>& U) {
  using Square = Eigen::Matrix<double, S::dim, S::dim>;
  NodeVectors<S> F = NodeVectors<S>::Zero();
  const VolumeChange<S> change(X, law, U);
  for (const auto& point : stiffness_rule<S>(law)) {
    const Gradients<S> dN = S::dN(point.r);
    const Square J = X * dN;
    const Square J_inverse = J.inverse();
    const Hoop<S> hoop(X, law, point.r);
    const double w = point.weight * J.determinant() * law.depth(hoop.x);
    const Square H = (U * dN).eval() * J_inverse;
    const double ring = U.row(0) * hoop.h;
    const double pressure = law.lambda * change.at(point.r, H.trace() + ring);
    Square T = law.mu * (H + H.transpose());
    T.diagonal().array() += pressure;
    const Square flow = w * T * J_inverse.transpose();
    F.noalias() += flow * dN.transpose();
    if (law.axisymmetric) {
      F.row(0) += (w * (pressure + 2.0 * law.mu * ring)) * hoop.h.transpose();
    }
  }
  return F;
}

/// Calls f(type, block) for each run of equal element types in `elements`, in their order.
template <class F>
void for_runs(const model::Mesh& mesh, std::span<const base::ElementId> elements, F&& f) {
  std::size_t begin = 0;
  while (begin < elements.size()) {
    const base::ElementType type = mesh.type[elements[begin].index()];
    std::size_t end = begin + 1;
    while (end < elements.size() && mesh.type[elements[end].index()] == type) {
      ++end;
    }
    f(type, elements.subspan(begin, end - begin));
    begin = end;
  }
}

/// Calls f(S{}, block) for each run of equal element types in `elements`, in their order; f is a
/// generic lambda `[&]<shape::ElementShape S>(S, std::span<const base::ElementId> block)`.
template <class F>
void for_blocks(const model::Mesh& mesh, std::span<const base::ElementId> elements, F&& f) {
  for_runs(mesh, elements, [&](base::ElementType type, std::span<const base::ElementId> block) {
    shape::with_shape(type, [&]<shape::ElementShape S>(S shape) { f(shape, block); });
  });
}

/// The same where all elements are plane.
template <class F>
void for_plane_blocks(const model::Mesh& mesh, std::span<const base::ElementId> elements, F&& f) {
  for_runs(mesh, elements, [&](base::ElementType type, std::span<const base::ElementId> block) {
    shape::with_plane_shape(type, [&]<shape::PlaneShape S>(S shape) { f(shape, block); });
  });
}

} // namespace spricka::fe
