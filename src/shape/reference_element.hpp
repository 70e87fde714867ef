// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "shape/quadrature_point.hpp"
#include "shape/shape.hpp"

#include <span>

namespace spricka::shape {

/// Nodes of an element at most.
template <int dim> inline constexpr int most_nodes = 3 * most_nodes<dim - 1>;
template <> inline constexpr int most_nodes<0> = 1;
/// Its corners at most.
template <int dim> inline constexpr int most_corners = 1 << dim;

/// The shape of an element or a side as data, for kernels that are not hot: they are compiled once
/// for a dimension instead of once for each shape. What a shape struct has as N and dN this has,
/// too, in matrices of run-time size that keep their numbers in place.
template <int d> struct ReferenceElement {
  static constexpr int dim = d;
  /// One number for each node. [nodes]
  using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_nodes<d>, 1>;
  /// [nodes, dim]
  using ShapeDerivatives = Eigen::Matrix<double, Eigen::Dynamic, d, 0, most_nodes<d>, d>;

  ReferenceDomain domain{};
  int nodes = 0;
  int corners = 0;
  int degree = 0; ///< of the rule of its stiffness; lines have none
  bool quadratic = false;
  Values (*N)(const Point<d>& r) = nullptr;
  ShapeDerivatives (*dN)(const Point<d>& r) = nullptr;
  std::span<const std::array<double, d>> coordinates; ///< of its nodes
  const ReferenceElement* relative = nullptr; ///< of a quadratic element, see linear_element()

  /// Reference coordinates of node i by the table of the element.
  [[nodiscard]] Point<d> node_local_coordinates(int i) const {
    return Eigen::Map<const Point<d>>(coordinates[static_cast<std::size_t>(i)].data());
  }
  /// The linear element with the same corners.
  [[nodiscard]] const ReferenceElement& linear_element() const {
    return relative == nullptr ? *this : *relative;
  }
  /// The middle of the reference domain.
  [[nodiscard]] Point<d> centre() const { return shape::centre<d>(domain); }
  /// How far a point lies outside it (shape.hpp).
  [[nodiscard]] double distance_outside(const Point<d>& r) const {
    return shape::distance_outside<d>(domain, r);
  }
};

/// A shape known when compiled, or one known when run.
template <class S>
concept Element = known_when_run<S> || ElementShape<S>;

/// The nodes of a shape as the size of matrices: a constant, or not known when compiled but
/// bounded.
template <class S> struct MatrixNodeCounts {
  static constexpr int nodes = S::nodes;
  static constexpr int most_nodes = S::nodes;
};
template <int dim> struct MatrixNodeCounts<ReferenceElement<dim>> {
  static constexpr int nodes = Eigen::Dynamic;
  static constexpr int most_nodes = shape::most_nodes<dim>;
};

/// The elements of dimension 2 and 3; compiled for both.
template <int dim> const ReferenceElement<dim>& reference_element(base::ElementType type);

/// A side of two nodes, or of three.
const ReferenceElement<1>& reference_line(int nodes);

/// The shape functions of an element and their derivatives at a point.
template <int dim> struct ShapeFunctionValues {
  typename ReferenceElement<dim>::Values N;
  typename ReferenceElement<dim>::ShapeDerivatives dN;
};
/// At the points of quadrature<dim>(element.domain, degree), in their order; computed once for each
/// element of the library and degree. Compiled for both dimensions.
template <int dim>
std::span<const ShapeFunctionValues<dim>>
shape_functions_at_quadrature_points(const ReferenceElement<dim>& element, int degree);

/// A shape struct as data: a side of two or three nodes.
template <Shape S> const ReferenceElement<1>& as_reference_element() {
  return reference_line(S::nodes);
}
/// A shape struct of the element library as data.
template <ElementShape S> const ReferenceElement<S::dim>& as_reference_element() {
  return reference_element<S::dim>(S::type);
}

} // namespace spricka::shape
