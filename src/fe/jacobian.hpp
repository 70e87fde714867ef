// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/law.hpp"
#include "model/mesh.hpp"
#include "shape/quadrature.hpp"
#include "shape/solid.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <span>

/// The map from the reference element, on fixed-size matrices; nothing here allocates.
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

/// Compiled in jacobian.cpp for each element.
template <shape::ElementShape S>
Jacobian<S> jacobian(const NodeVectors<S>& X, const shape::Point<S::dim>& r);

/// The rule that an element is integrated with. About an axis the strains of a TRIM3 are not
/// constant: one point would leave it a second free mode.
template <shape::ElementShape S>
std::span<const shape::QuadraturePoint<S::dim>> stiffness_rule(const Law& law) {
  return shape::quadrature<S>(law.axisymmetric ? std::max(S::degree, 2) : S::degree);
}

/// The circumferential strain of an axisymmetric element at a point, h^T u_x with h = N / x. All
/// zero for other bodies, whose kernels then are the plane ones.
template <shape::Shape S> struct Hoop {
  double x = 0.0; ///< first coordinate of the point
  Eigen::Matrix<double, S::nodes, 1> h = Eigen::Matrix<double, S::nodes, 1>::Zero();

  Hoop(const NodeVectors<S>& X, const Law& law, const shape::Point<S::dim>& r) {
    if (law.axisymmetric) {
      const Eigen::Matrix<double, S::nodes, 1> N = S::N(r);
      x = X.row(0) * N;
      h = N / x;
    }
  }
};

} // namespace spricka::fe
