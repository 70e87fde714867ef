// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "shape/shape.hpp"

namespace spricka::shape {

/// A point of a quadrature rule; the weights of a rule sum to the size of the reference domain
/// (line 2, triangle 1/2, quadrilateral 4, tetrahedron 1/6, prism 1, hexahedron 8) and are all
/// positive.
template <int dim> struct QuadraturePoint {
  Point<dim> r;
  double weight = 0.0;
};

} // namespace spricka::shape
