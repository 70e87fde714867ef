// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "shape/quadrature_point.hpp"

#include <vector>

namespace spricka::shape {

/// n Gauss points for the weight (1 - x)^a on [-1,1], a = 0, 1 or 2, ascending; exact for
/// polynomials of degree 2n - 1 times the weight.
std::vector<QuadraturePoint<1>> gauss_jacobi_rule(int n, double a);

} // namespace spricka::shape
