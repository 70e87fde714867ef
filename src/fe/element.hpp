// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/elasticity.hpp"
#include "shape/quadrature.hpp"
#include "shape/shape.hpp"

#include <Eigen/LU>

#include <array>
#include <cassert>
#include <span>

/// Kernels of one element, on fixed-size matrices; nothing here allocates. Freedom c of local node
/// i is row dim * i + c of an element matrix.
namespace spricka::fe {

/// Values of a vector field (coordinates, displacements, forces) at the nodes of an element.
template <shape::Shape S> using NodeVectors = Eigen::Matrix<double, S::dim, S::nodes>;
/// Derivatives of the shape functions with respect to x.
template <shape::Shape S> using Gradients = Eigen::Matrix<double, S::nodes, S::dim>;
template <shape::Shape S>
using ElementMatrix = Eigen::Matrix<double, S::dim * S::nodes, S::dim * S::nodes>;

/// Coordinates of the nodes of an element [dim, nodes].
template <shape::ElementShape S>
NodeVectors<S> coordinates(const model::Mesh& mesh, base::ElementId e) {
  const std::span<const base::NodeId> nodes = mesh.nodes_of(e);
  assert(nodes.size() == static_cast<std::size_t>(S::nodes));
  NodeVectors<S> X;
  for (int i = 0; i < S::nodes; ++i) {
    X.col(i) = mesh.x[nodes[static_cast<std::size_t>(i)].index()].template head<S::dim>();
  }
  return X;
}

/// The part of a nodal vector [dim * node] that belongs to an element [dim, nodes].
template <shape::ElementShape S>
NodeVectors<S> gather(const model::Mesh& mesh, base::ElementId e, const base::Vector& u) {
  const std::span<const base::NodeId> nodes = mesh.nodes_of(e);
  NodeVectors<S> U;
  for (int i = 0; i < S::nodes; ++i) {
    const auto n = static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(i)].index());
    U.col(i) = u.template segment<S::dim>(S::dim * n);
  }
  return U;
}

/// The map from the reference element at one point: J = dx/dr = X dN, its determinant, and
/// dNdx = dN J^-1. Where det is zero (the tip of a quarter-point element) dNdx is not finite.
template <shape::Shape S> struct Jacobian {
  Eigen::Matrix<double, S::dim, S::dim> J;
  double det = 0.0;
  Gradients<S> dNdx;
};

template <shape::Shape S>
Jacobian<S> jacobian(const NodeVectors<S>& X, const shape::Point<S::dim>& r) {
  const Gradients<S> dN = S::dN(r);
  Jacobian<S> at;
  at.J.noalias() = X * dN;
  at.det = at.J.determinant();
  at.dNdx.noalias() = dN * at.J.inverse();
  return at;
}

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

/// Ke = integral of B^T D B dV [force/length] from nodal coordinates X [dim, nodes] and an
/// isotropic D; thickness is 1 for a solid. With M_pq = integral of dN/dx_p (dN/dx_q)^T dV the
/// block of directions a, b is lambda M_ab + mu M_ba + mu delta_ab sum_p M_pp: a quarter of the
/// work of the triple product.
template <shape::ElementShape S>
ElementMatrix<S> element_stiffness(const NodeVectors<S>& X, const Elasticity<S::dim>& D,
                                   double thickness) {
  constexpr int dim = S::dim;
  using Square = Eigen::Matrix<double, S::nodes, S::nodes>;
  std::array<std::array<Square, dim>, dim> M; // p <= q only
  for (int p = 0; p < dim; ++p) {
    for (int q = p; q < dim; ++q) {
      M[static_cast<std::size_t>(p)][static_cast<std::size_t>(q)].setZero();
    }
  }
  for (const auto& point : shape::quadrature<S>()) {
    const Jacobian<S> at = jacobian<S>(X, point.r);
    const Gradients<S> weighted = (point.weight * at.det * thickness) * at.dNdx;
    for (int p = 0; p < dim; ++p) {
      for (int q = p; q < dim; ++q) {
        M[static_cast<std::size_t>(p)][static_cast<std::size_t>(q)].noalias() +=
            weighted.col(p) * at.dNdx.col(q).transpose();
      }
    }
  }
  const double lambda = D(0, 1);
  const double mu = D(components(dim) - 1, components(dim) - 1);
  Square trace = M[0][0];
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
  return Ke;
}

/// Nodal forces Ke U of displacements U, both [dim, nodes], without forming Ke.
template <shape::ElementShape S>
NodeVectors<S> element_force(const NodeVectors<S>& X, const Elasticity<S::dim>& D, double thickness,
                             const NodeVectors<S>& U) {
  NodeVectors<S> F = NodeVectors<S>::Zero();
  for (const auto& point : shape::quadrature<S>()) {
    const Jacobian<S> at = jacobian<S>(X, point.r);
    const Eigen::Matrix<double, S::dim, S::dim> H = U * at.dNdx;
    const Strain<S::dim> sigma = D * strain<S::dim>(H);
    const Eigen::Matrix<double, S::dim, S::dim> T =
        (point.weight * at.det * thickness) * stress_tensor<S::dim>(sigma);
    F.noalias() += T * at.dNdx.transpose();
  }
  return F;
}

/// Calls f(S{}, block) for each run of equal element types in `elements`, in their order; f is a
/// generic lambda `[&]<shape::ElementShape S>(S, std::span<const base::ElementId> block)`.
template <class F>
void for_blocks(const model::Mesh& mesh, std::span<const base::ElementId> elements, F&& f) {
  std::size_t begin = 0;
  while (begin < elements.size()) {
    const base::ElementType type = mesh.type[elements[begin].index()];
    std::size_t end = begin + 1;
    while (end < elements.size() && mesh.type[elements[end].index()] == type) {
      ++end;
    }
    const std::span<const base::ElementId> block = elements.subspan(begin, end - begin);
    shape::with_plane_shape(type, [&]<shape::ElementShape S>(S shape) { f(shape, block); });
    begin = end;
  }
}

} // namespace spricka::fe
