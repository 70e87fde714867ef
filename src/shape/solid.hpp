// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "shape/shape.hpp"

/// Reference shapes of solids. Tetrahedra live on (0,0,0) (1,0,0) (0,1,0) (0,0,1), pentahedra on
/// the triangle times [-1,1], hexahedra on [-1,1]^3. Nodes in the order of Abaqus: corners (of
/// pentahedra and hexahedra first those at t = -1), the middles of edges
///
///     TET10     01 12 20 03 13 23
///     PENTAC15  01 12 20  34 45 53  03 14 25
///     HEXEC20   01 12 23 30  45 56 67 74  04 15 26 37
///
/// and, in HEXEC27, the middles of the sides 0 to 5 (topology.hpp) and the centre.
namespace spricka::shape {

struct Tet4 : ShapeFromElementTable<base::ElementType::tet4> {
  static constexpr int degree = 0; ///< constant strain
  static constexpr std::array<std::array<double, 3>, 4> coordinates{
      {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

  /// Linear functions of the corners: the volume coordinates.
  static Eigen::Matrix<double, 4, 1> N(const Point<3>& r);
  /// Their derivatives, the same at all points.
  static Eigen::Matrix<double, 4, 3> dN(const Point<3>& r);
};

struct Tet10 : ShapeFromElementTable<base::ElementType::tet10> {
  /// 14 points. Straight sides need 2; on curved ones the integrand is rational.
  static constexpr int degree = 5;
  static constexpr std::array<std::array<double, 3>, 10> coordinates{{{0.0, 0.0, 0.0},
                                                                      {1.0, 0.0, 0.0},
                                                                      {0.0, 1.0, 0.0},
                                                                      {0.0, 0.0, 1.0},
                                                                      {0.5, 0.0, 0.0},
                                                                      {0.5, 0.5, 0.0},
                                                                      {0.0, 0.5, 0.0},
                                                                      {0.0, 0.0, 0.5},
                                                                      {0.5, 0.0, 0.5},
                                                                      {0.0, 0.5, 0.5}}};
  static constexpr std::array<std::array<int, 2>, 6> edges{
      {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

  /// Complete quadratic functions in volume coordinates: corners, then the edges in the order of
  /// `edges`.
  static Eigen::Matrix<double, 10, 1> N(const Point<3>& r);
  /// Their derivatives by the reference coordinates, linear.
  static Eigen::Matrix<double, 10, 3> dN(const Point<3>& r);
};

/// Sides 0 and 1 are triangles, 2 to 4 quadrilaterals.
struct Penta6 : ShapeFromElementTable<base::ElementType::penta6> {
  static constexpr int degree = 2; ///< 3 x 2 points
  static constexpr std::array<std::array<double, 3>, 6> coordinates{{{0.0, 0.0, -1.0},
                                                                     {1.0, 0.0, -1.0},
                                                                     {0.0, 1.0, -1.0},
                                                                     {0.0, 0.0, 1.0},
                                                                     {1.0, 0.0, 1.0},
                                                                     {0.0, 1.0, 1.0}}};

  /// Area coordinates of the triangle times linear functions along the third coordinate.
  static Eigen::Matrix<double, 6, 1> N(const Point<3>& r);
  /// Their derivatives by the reference coordinates.
  static Eigen::Matrix<double, 6, 3> dN(const Point<3>& r);
};

/// Serendipity. Sides as Penta6.
struct Pentac15 : ShapeFromElementTable<base::ElementType::pentac15> {
  static constexpr int degree = 5; ///< 7 x 3 points; straight sides need 4
  static constexpr std::array<std::array<double, 3>, 15> coordinates{{{0.0, 0.0, -1.0},
                                                                      {1.0, 0.0, -1.0},
                                                                      {0.0, 1.0, -1.0},
                                                                      {0.0, 0.0, 1.0},
                                                                      {1.0, 0.0, 1.0},
                                                                      {0.0, 1.0, 1.0},
                                                                      {0.5, 0.0, -1.0},
                                                                      {0.5, 0.5, -1.0},
                                                                      {0.0, 0.5, -1.0},
                                                                      {0.5, 0.0, 1.0},
                                                                      {0.5, 0.5, 1.0},
                                                                      {0.0, 0.5, 1.0},
                                                                      {0.0, 0.0, 0.0},
                                                                      {1.0, 0.0, 0.0},
                                                                      {0.0, 1.0, 0.0}}};

  // Corner at the end q = -1 or 1: N = l (1 + q t)(2 l + q t - 2) / 2; on the edges of an end
  // 2 l m (1 + q t); between the ends l (1 - t^2).
  static Eigen::Matrix<double, 15, 1> N(const Point<3>& r);
  /// Derivatives of these functions by the reference coordinates.
  static Eigen::Matrix<double, 15, 3> dN(const Point<3>& r);
};

namespace detail {

/// Nodes of the richest hexahedron; the poorer ones have the first 8 or 20.
inline constexpr std::array<std::array<double, 3>, 27> hexahedron{
    {{-1.0, -1.0, -1.0}, {1.0, -1.0, -1.0}, {1.0, 1.0, -1.0}, {-1.0, 1.0, -1.0}, {-1.0, -1.0, 1.0},
     {1.0, -1.0, 1.0},   {1.0, 1.0, 1.0},   {-1.0, 1.0, 1.0}, {0.0, -1.0, -1.0}, {1.0, 0.0, -1.0},
     {0.0, 1.0, -1.0},   {-1.0, 0.0, -1.0}, {0.0, -1.0, 1.0}, {1.0, 0.0, 1.0},   {0.0, 1.0, 1.0},
     {-1.0, 0.0, 1.0},   {-1.0, -1.0, 0.0}, {1.0, -1.0, 0.0}, {1.0, 1.0, 0.0},   {-1.0, 1.0, 0.0},
     {0.0, 0.0, -1.0},   {0.0, 0.0, 1.0},   {0.0, -1.0, 0.0}, {1.0, 0.0, 0.0},   {0.0, 1.0, 0.0},
     {-1.0, 0.0, 0.0},   {0.0, 0.0, 0.0}}};

/// Reference coordinates of the first n of these nodes.
template <std::size_t n> constexpr std::array<std::array<double, 3>, n> first_hexahedron_nodes() {
  std::array<std::array<double, 3>, n> first{};
  std::copy_n(hexahedron.begin(), n, first.begin());
  return first;
}

} // namespace detail

struct Hexe8 : ShapeFromElementTable<base::ElementType::hexe8> {
  static constexpr int degree = 3; ///< 2 x 2 x 2 points
  static constexpr std::array<std::array<double, 3>, 8> coordinates =
      detail::first_hexahedron_nodes<8>();

  /// Trilinear functions of the corners.
  static Eigen::Matrix<double, 8, 1> N(const Point<3>& r);
  /// Their derivatives by the reference coordinates.
  static Eigen::Matrix<double, 8, 3> dN(const Point<3>& r);
};

/// Serendipity.
struct Hexec20 : ShapeFromElementTable<base::ElementType::hexec20> {
  static constexpr int degree = 5; ///< 3 x 3 x 3 points
  static constexpr std::array<std::array<double, 3>, 20> coordinates =
      detail::first_hexahedron_nodes<20>();

  // Corner at p: N = prod(1 + p_k r_k) (sum p_k r_k - 2) / 8. In the middle of an edge the factor
  // along it is 1 - r^2, and 1/8 becomes 1/4.
  static Eigen::Matrix<double, 20, 1> N(const Point<3>& r);
  /// Derivatives of these functions by the reference coordinates.
  static Eigen::Matrix<double, 20, 3> dN(const Point<3>& r);

private:
  static const std::array<double, 3>& at(int i) { return coordinates[static_cast<std::size_t>(i)]; }
  static Point<3> factors(const Point<3>& p, const Point<3>& r) {
    Point<3> f;
    for (int k = 0; k < 3; ++k) {
      f[k] = p[k] != 0.0 ? 1.0 + p[k] * r[k] : 1.0 - r[k] * r[k];
    }
    return f;
  }
};

/// Lagrange.
struct Hexec27 : ShapeFromElementTable<base::ElementType::hexec27> {
  static constexpr int degree = 5; ///< 3 x 3 x 3 points
  static constexpr std::array<std::array<double, 3>, 27> coordinates = detail::hexahedron;

  /// Triquadratic functions: products of those of Line3 along the three coordinates.
  static Eigen::Matrix<double, 27, 1> N(const Point<3>& r);
  /// Their derivatives by the reference coordinates.
  static Eigen::Matrix<double, 27, 3> dN(const Point<3>& r);

private:
  /// The functions of Line3, or their derivatives, in the three directions.
  struct LineFactors {
    Eigen::Matrix3d value; ///< [function, direction]

    template <class F> LineFactors(const Point<3>& r, F&& f) {
      for (int k = 0; k < 3; ++k) {
        value.col(k) = f(Point<1>(r[k]));
      }
    }
    /// The factor of node i along direction k.
    double operator()(int i, int k) const {
      const double p = coordinates[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
      return value(p < 0.0 ? 0 : (p > 0.0 ? 1 : 2), k);
    }
  };
};

/// SPRICKA_EACH_PLANE_SHAPE for every type of the element library.
#define SPRICKA_EACH_SHAPE(ONE)                                                                    \
  SPRICKA_EACH_PLANE_SHAPE(ONE)                                                                    \
  ONE(shape::Tet4)                                                                                 \
  ONE(shape::Tet10)                                                                                \
  ONE(shape::Penta6)                                                                               \
  ONE(shape::Pentac15) ONE(shape::Hexe8) ONE(shape::Hexec20) ONE(shape::Hexec27)

/// with_plane_shape for every type of the element library.
template <class F> decltype(auto) with_element_shape(base::ElementType type, F&& f) {
  switch (type) {
  case base::ElementType::tet4:
    return std::forward<F>(f)(Tet4{});
  case base::ElementType::tet10:
    return std::forward<F>(f)(Tet10{});
  case base::ElementType::penta6:
    return std::forward<F>(f)(Penta6{});
  case base::ElementType::pentac15:
    return std::forward<F>(f)(Pentac15{});
  case base::ElementType::hexe8:
    return std::forward<F>(f)(Hexe8{});
  case base::ElementType::hexec20:
    return std::forward<F>(f)(Hexec20{});
  case base::ElementType::hexec27:
    return std::forward<F>(f)(Hexec27{});
  default:
    return with_plane_shape(type, std::forward<F>(f));
  }
}

} // namespace spricka::shape
