// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "shape/quadrature_point.hpp"
#include "shape/shape.hpp"

#include <span>

namespace spricka::shape {

/// Highest degree of exactness on offer.
inline constexpr int max_degree = 31;

/// Gauss-Legendre on [-1,1], exact for polynomials up to `degree` <= max_degree.
std::span<const QuadraturePoint<1>> line_rule(int degree);

/// Products of line_rule on [-1,1]^2, exact up to `degree` in each coordinate.
std::span<const QuadraturePoint<2>> quadrilateral_rule(int degree);

/// Rules on the triangle (0,0) (1,0) (0,1), exact up to total `degree`, points inside. Up to degree
/// 8 symmetric ones with 1, 3, 6, 7, 12, 16 points (Strang, Fix 1973; Radon 1948; Dunavant 1985);
/// above, products of Gauss-Legendre and Gauss-Jacobi points on the collapsed square (Stroud 1971).
std::span<const QuadraturePoint<2>> triangle_rule(int degree);

/// Highest degree of exactness on offer in space.
inline constexpr int max_solid_degree = 15;

/// Products of line_rule on [-1,1]^3, exact up to `degree` in each coordinate.
std::span<const QuadraturePoint<3>> hexahedron_rule(int degree);

/// Products of triangle_rule and line_rule, exact up to `degree` in both.
std::span<const QuadraturePoint<3>> prism_rule(int degree);

/// Rules on the tetrahedron (0,0,0) (1,0,0) (0,1,0) (0,0,1), exact up to total `degree`, points
/// inside. Up to degree 6 symmetric ones with 1, 4, 14, 24 points (Hammer, Stroud 1956; Walkington
/// 2000; Keast 1986); above, products of Gauss-Jacobi points on the collapsed cube (Stroud 1971).
std::span<const QuadraturePoint<3>> tetrahedron_rule(int degree);

/// The rule of a domain of so many dimensions.
template <int dim>
std::span<const QuadraturePoint<dim>> quadrature(ReferenceDomain domain, int degree);
template <>
inline std::span<const QuadraturePoint<1>> quadrature<1>(ReferenceDomain /*line*/, int degree) {
  return line_rule(degree);
}
template <>
inline std::span<const QuadraturePoint<2>> quadrature<2>(ReferenceDomain domain, int degree) {
  return domain == ReferenceDomain::triangle ? triangle_rule(degree) : quadrilateral_rule(degree);
}
template <>
inline std::span<const QuadraturePoint<3>> quadrature<3>(ReferenceDomain domain, int degree) {
  return domain == ReferenceDomain::tetrahedron ? tetrahedron_rule(degree)
         : domain == ReferenceDomain::prism     ? prism_rule(degree)
                                                : hexahedron_rule(degree);
}
/// The rule of a shape's own domain that is exact up to a degree.
template <Shape S> std::span<const QuadraturePoint<S::dim>> quadrature(int degree) {
  return quadrature<S::dim>(S::domain, degree);
}

/// The rule that an element's stiffness is integrated with.
template <ElementShape S> std::span<const QuadraturePoint<S::dim>> quadrature() {
  return quadrature<S>(S::degree);
}

} // namespace spricka::shape
