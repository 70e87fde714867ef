// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "base/vec.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstdlib>
#include <utility>

/// Reference shapes: plain structs with shape functions N and their derivatives dN. Triangles live
/// on (0,0) (1,0) (0,1), lines and quadrilaterals on [-1,1]^dim. Nodes: corners, then mid-edge
/// nodes (node corners + s lies on edge s, which joins corners s and s + 1), then the centre. The
/// shapes of solids stand in shape/solid.hpp.
namespace spricka::shape {

/// A point in reference coordinates.
template <int dim> using Point = Eigen::Matrix<double, dim, 1>;

using base::ReferenceDomain;

/// How many reference coordinates of a domain, the first ones, run over a simplex: from 0 on, their
/// sum up to 1. The others run from -1 to 1.
constexpr int simplex_coordinate_count(ReferenceDomain domain) {
  constexpr std::array<int, 6> directions{0, 2, 0, 3, 2, 0};
  return directions[static_cast<std::size_t>(domain)];
}

/// A shape known when run only (reference_element.hpp).
template <int dim> struct ReferenceElement;
template <class S> inline constexpr bool known_when_run = false;
template <int dim> inline constexpr bool known_when_run<ReferenceElement<dim>> = true;

/// N(r) [nodes], dN(r) [nodes, dim] derivatives with respect to r, coordinates [nodes][dim] of the
/// nodes in reference coordinates.
template <class S>
concept Shape = !known_when_run<S> && requires(const Point<S::dim>& r) {
  { S::nodes } -> std::convertible_to<int>;
  { S::domain } -> std::convertible_to<ReferenceDomain>;
  { S::N(r) } -> std::same_as<Eigen::Matrix<double, S::nodes, 1>>;
  { S::dN(r) } -> std::same_as<Eigen::Matrix<double, S::nodes, S::dim>>;
  { S::coordinates[0][0] } -> std::convertible_to<double>;
};

/// A shape of the element library: its type and the degree of exactness that its stiffness is
/// integrated with.
template <class S>
concept ElementShape = Shape<S> && requires {
  { S::type } -> std::convertible_to<base::ElementType>;
  { S::degree } -> std::convertible_to<int>;
};

/// The shape of a plane element has one `Side` for all its sides.
template <class S>
concept PlaneShape = ElementShape<S> && Shape<typename S::Side>;

struct Line2 {
  static constexpr int nodes = 2;
  static constexpr int dim = 1;
  static constexpr ReferenceDomain domain = ReferenceDomain::line;
  static constexpr std::array<std::array<double, 1>, 2> coordinates{{{-1.0}, {1.0}}};

  /// Linear functions of the two ends.
  static Eigen::Matrix<double, 2, 1> N(const Point<1>& r);
  /// Their derivatives, the same at all points.
  static Eigen::Matrix<double, 2, 1> dN(const Point<1>& r);
};

/// Ends first, then the middle.
struct Line3 {
  static constexpr int nodes = 3;
  static constexpr int dim = 1;
  static constexpr ReferenceDomain domain = ReferenceDomain::line;
  static constexpr std::array<std::array<double, 1>, 3> coordinates{{{-1.0}, {1.0}, {0.0}}};

  /// Quadratic functions of ends and middle.
  static Eigen::Matrix<double, 3, 1> N(const Point<1>& r);
  /// Their derivatives by the coordinate of the line.
  static Eigen::Matrix<double, 3, 1> dN(const Point<1>& r);
};

/// What the table of the element library says of a shape.
template <base::ElementType element> struct ShapeFromElementTable {
  static constexpr base::ElementType type = element;
  static constexpr int nodes = base::element_info(element).nodes;
  static constexpr int dim = base::element_info(element).dim;
  static constexpr ReferenceDomain domain = base::element_info(element).domain;
};

struct Trim3 : ShapeFromElementTable<base::ElementType::trim3> {
  static constexpr int degree = 0; ///< constant strain
  using Side = Line2;
  static constexpr std::array<std::array<double, 2>, 3> coordinates{
      {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};

  /// Linear functions of the corners: the area coordinates.
  static Eigen::Matrix<double, 3, 1> N(const Point<2>& r);
  /// Their derivatives, the same at all points.
  static Eigen::Matrix<double, 3, 2> dN(const Point<2>& r);
};

struct Trimc6 : ShapeFromElementTable<base::ElementType::trimc6> {
  /// Straight sides need 2. Curved and quarter-point ones have a rational integrand: with 7 points
  /// (degree 5) the energy of a sqrt(r) field in a tip element is off by 5e-4, with these 12 by
  /// 2e-4. Constant strain passes with degree 2, as dN times the adjugate of J is a polynomial.
  static constexpr int degree = 6;
  using Side = Line3;
  static constexpr std::array<std::array<double, 2>, 6> coordinates{
      {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}}};

  /// Complete quadratic functions in area coordinates, corners first, then middles of the sides.
  static Eigen::Matrix<double, 6, 1> N(const Point<2>& r);
  /// Their derivatives by the reference coordinates, linear.
  static Eigen::Matrix<double, 6, 2> dN(const Point<2>& r);
};

struct Quam4 : ShapeFromElementTable<base::ElementType::quam4> {
  static constexpr int degree = 3; ///< 2 x 2 points
  using Side = Line2;
  static constexpr std::array<std::array<double, 2>, 4> coordinates{
      {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};

  /// Bilinear functions of the corners.
  static Eigen::Matrix<double, 4, 1> N(const Point<2>& r);
  /// Their derivatives by the reference coordinates.
  static Eigen::Matrix<double, 4, 2> dN(const Point<2>& r);
};

/// Serendipity.
struct Quamc8 : ShapeFromElementTable<base::ElementType::quamc8> {
  static constexpr int degree = 5; ///< 3 x 3 points
  using Side = Line3;
  static constexpr std::array<std::array<double, 2>, 8> coordinates{{{-1.0, -1.0},
                                                                     {1.0, -1.0},
                                                                     {1.0, 1.0},
                                                                     {-1.0, 1.0},
                                                                     {0.0, -1.0},
                                                                     {1.0, 0.0},
                                                                     {0.0, 1.0},
                                                                     {-1.0, 0.0}}};

  // Corner i at (p, q): N = (1 + p x)(1 + q y)(p x + q y - 1) / 4.
  /// Functions of the serendipity quadrilateral: corners, then middles of the sides.
  static Eigen::Matrix<double, 8, 1> N(const Point<2>& r);
  /// Their derivatives by the reference coordinates.
  static Eigen::Matrix<double, 8, 2> dN(const Point<2>& r);
};

/// Lagrange; the ninth node is the centre.
struct Quamc9 : ShapeFromElementTable<base::ElementType::quamc9> {
  static constexpr int degree = 5; ///< 3 x 3 points
  using Side = Line3;
  static constexpr std::array<std::array<double, 2>, 9> coordinates{{{-1.0, -1.0},
                                                                     {1.0, -1.0},
                                                                     {1.0, 1.0},
                                                                     {-1.0, 1.0},
                                                                     {0.0, -1.0},
                                                                     {1.0, 0.0},
                                                                     {0.0, 1.0},
                                                                     {-1.0, 0.0},
                                                                     {0.0, 0.0}}};
  /// Which functions of Line3 in x and in y make the function of a node.
  static constexpr std::array<std::array<int, 2>, 9> factors{
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {1, 2}, {2, 1}, {0, 2}, {2, 2}}};

  /// Biquadratic functions, products of those of Line3 in x and in y; the centre last.
  static Eigen::Matrix<double, 9, 1> N(const Point<2>& r);
  /// Their derivatives by the reference coordinates.
  static Eigen::Matrix<double, 9, 2> dN(const Point<2>& r);
};

/// Reference coordinates of node i of a shape known when compiled.
template <Shape S> Point<S::dim> node_local_coordinates(int i) {
  return Eigen::Map<const Point<S::dim>>(S::coordinates[static_cast<std::size_t>(i)].data());
}

/// The middle of a reference domain.
template <int dim> Point<dim> centre(ReferenceDomain domain) {
  Point<dim> middle = Point<dim>::Zero();
  const int simplex = simplex_coordinate_count(domain);
  middle.head(simplex).setConstant(1.0 / (simplex + 1.0));
  return middle;
}
/// The middle of the domain of a shape known when compiled.
template <Shape S> Point<S::dim> centre() {
  return centre<S::dim>(S::domain);
}

/// How far a point lies outside a reference domain: the largest violation of a side, on domains
/// of side 1 and 2 alike; negative inside.
template <int dim> double distance_outside(ReferenceDomain domain, const Point<dim>& r) {
  const int simplex = simplex_coordinate_count(domain);
  if (simplex == 0) {
    return r.cwiseAbs().maxCoeff() - 1.0;
  }
  if (simplex == dim) {
    return std::max(-r.minCoeff(), r.sum() - 1.0);
  }
  const auto in_simplex = r.head(simplex);
  return std::max({-in_simplex.minCoeff(), in_simplex.sum() - 1.0,
                   r.tail(dim - simplex).cwiseAbs().maxCoeff() - 1.0});
}
/// How far a point lies outside the domain of a shape known when compiled; negative inside.
template <Shape S> double distance_outside(const Point<S::dim>& r) {
  return distance_outside<S::dim>(S::domain, r);
}

/// ONE(S) for each plane element: what a source compiles for all of them, so that headers need not
/// hold it (a kernel takes seconds for each shape, in every source that has its body).
#define SPRICKA_EACH_PLANE_SHAPE(ONE)                                                              \
  ONE(shape::Trim3) ONE(shape::Trimc6) ONE(shape::Quam4) ONE(shape::Quamc8) ONE(shape::Quamc9)

/// Calls f with a value of the shape struct of a plane element and returns what it returns; f is a
/// generic lambda, `[&]<shape::PlaneShape S>(S) { .. S::N(r) .. }`. Dispatch once for a block of
/// equal elements, not once for each.
template <class F> decltype(auto) with_plane_shape(base::ElementType type, F&& f) {
  switch (type) {
  case base::ElementType::trim3:
    return std::forward<F>(f)(Trim3{});
  case base::ElementType::trimc6:
    return std::forward<F>(f)(Trimc6{});
  case base::ElementType::quam4:
    return std::forward<F>(f)(Quam4{});
  case base::ElementType::quamc8:
    return std::forward<F>(f)(Quamc8{});
  case base::ElementType::quamc9:
    return std::forward<F>(f)(Quamc9{});
  default:
    assert(false && "with_plane_shape: a type without a plane shape");
    std::abort();
  }
}

} // namespace spricka::shape
