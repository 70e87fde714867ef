// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/law.hpp"
#include "model/mesh.hpp"
#include "shape/quadrature.hpp"
#include "shape/reference_element.hpp"
#include "shape/solid.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <span>

/// The map from the reference element, on matrices that keep their numbers in place; nothing here
/// allocates. What is called for each element and hot is compiled for each shape, `jacobian<S>(X,
/// r)`; what is not takes the shape as data, `jacobian(shape::reference_element<dim>(type), X, r)`.
namespace spricka::fe {

/// Values of a vector field (coordinates, displacements, forces) at the nodes of an element.
template <class S>
using NodeVectors = Eigen::Matrix<double, S::dim, shape::MatrixNodeCounts<S>::nodes, 0, S::dim,
                                  shape::MatrixNodeCounts<S>::most_nodes>;
/// Values of a function at the nodes of an element.
template <class S>
using NodeValues = Eigen::Matrix<double, shape::MatrixNodeCounts<S>::nodes, 1, 0,
                                 shape::MatrixNodeCounts<S>::most_nodes, 1>;
/// Derivatives of the shape functions with respect to x.
template <class S>
using Gradients = Eigen::Matrix<double, shape::MatrixNodeCounts<S>::nodes, S::dim, 0,
                                shape::MatrixNodeCounts<S>::most_nodes, S::dim>;
/// An element or a side known when run, and vectors at its nodes in its own space and in space.
template <int dim> using AnyElement = shape::ReferenceElement<dim>;
template <int dim> using AnyNodeVectors = NodeVectors<AnyElement<dim>>;
template <int dim>
using SpaceNodes = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, shape::most_nodes<dim>>;
/// Coordinates in the plane or in space with three components.
template <int dim> SpaceNodes<dim> embed_nodes_in_space(const AnyNodeVectors<dim>& X) {
  SpaceNodes<dim> x = SpaceNodes<dim>::Zero(3, X.cols());
  x.template topRows<dim>() = X;
  return x;
}
template <shape::Shape S>
using ElementMatrix = Eigen::Matrix<double, S::dim * S::nodes, S::dim * S::nodes>;

/// Coordinates of the nodes of an element [dim, nodes].
template <shape::Element S>
NodeVectors<S> element_coordinates(const S& element, const model::Mesh& mesh, base::ElementId e) {
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  assert(nodes.size() == static_cast<std::size_t>(element.nodes));
  NodeVectors<S> X(S::dim, element.nodes);
  for (int i = 0; i < element.nodes; ++i) {
    X.col(i) = mesh.x[nodes[static_cast<std::size_t>(i)].index()].template head<S::dim>();
  }
  return X;
}
/// The nodal coordinates [dim, nodes] for an element type known when compiled.
template <shape::ElementShape S>
NodeVectors<S> element_coordinates(const model::Mesh& mesh, base::ElementId e) {
  return element_coordinates(S{}, mesh, e);
}

/// The part of a nodal vector [dim * node] that belongs to an element [dim, nodes].
template <shape::Element S>
NodeVectors<S> gather_element_values(const S& element, const model::Mesh& mesh, base::ElementId e,
                                     const base::Vector& u) {
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  NodeVectors<S> U(S::dim, element.nodes);
  for (int i = 0; i < element.nodes; ++i) {
    const auto n = static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(i)].index());
    U.col(i) = u.template segment<S::dim>(S::dim * n);
  }
  return U;
}
/// The nodal vectors [dim, nodes] for an element type known when compiled.
template <shape::ElementShape S>
NodeVectors<S> gather_element_values(const model::Mesh& mesh, base::ElementId e,
                                     const base::Vector& u) {
  return gather_element_values(S{}, mesh, e, u);
}

/// Adds vectors at the nodes of an element [dim, nodes] to their places in a nodal vector
/// [dim * node].
template <class Vectors>
void add_at_nodes(const model::Mesh& mesh, base::ElementId e, const Vectors& F, base::Vector& f) {
  Eigen::Index i = 0;
  for (const base::NodeId n : mesh.element_nodes(e)) {
    f.segment(F.rows() * static_cast<Eigen::Index>(n.index()), F.rows()) += F.col(i++);
  }
}

/// The map from the reference element at one point: J = dx/dr = X dN, its determinant, and
/// dNdx = dN J^-1. Where det is zero (the tip of a quarter-point element) dNdx is not finite.
template <class S> struct Jacobian {
  Eigen::Matrix<double, S::dim, S::dim> J;
  double det = 0.0;
  Gradients<S> dNdx;
};

/// Compiled in jacobian.cpp for each element, and for elements known when run.
template <shape::Element S>
Jacobian<S> jacobian(const S& element, const NodeVectors<S>& X, const shape::Point<S::dim>& r);
/// The same from the derivatives of the shape functions at the point.
template <shape::Element S>
Jacobian<S> jacobian_by_derivatives(const NodeVectors<S>& X, const Gradients<S>& dN);
/// The Jacobian at a reference point for an element type known when compiled.
template <shape::ElementShape S>
Jacobian<S> jacobian(const NodeVectors<S>& X, const shape::Point<S::dim>& r) {
  return jacobian(S{}, X, r);
}

/// The rule that an element is integrated with. About an axis the strains of a TRIM3 are not
/// constant: one point would leave it a second free mode.
template <shape::Element S>
std::span<const shape::QuadraturePoint<S::dim>> stiffness_rule(const S& element,
                                                               const ConstitutiveLaw& law) {
  return shape::quadrature<S::dim>(element.domain,
                                   law.axisymmetric ? std::max(element.degree, 2) : element.degree);
}
/// The stiffness rule for an element type known when compiled.
template <shape::ElementShape S>
std::span<const shape::QuadraturePoint<S::dim>> stiffness_rule(const ConstitutiveLaw& law) {
  return stiffness_rule(S{}, law);
}

/// The circumferential strain of an axisymmetric element at a point, h^T u_x with h = N / x. All
/// zero for other bodies, whose kernels then are the plane ones.
template <class S> struct HoopStrain {
  double x = 0.0; ///< first coordinate of the point
  NodeValues<S> h;

  HoopStrain(const S& element, const NodeVectors<S>& X, const ConstitutiveLaw& law,
             const shape::Point<S::dim>& r)
      : h(NodeValues<S>::Zero(element.nodes)) {
    if (law.is_axisymmetric<S::dim>()) {
      const NodeValues<S> N = element.N(r);
      x = X.row(0) * N;
      h = N / x;
    }
  }
  HoopStrain(const NodeVectors<S>& X, const ConstitutiveLaw& law, const shape::Point<S::dim>& r)
      : HoopStrain(S{}, X, law, r) {}
};

} // namespace spricka::fe
