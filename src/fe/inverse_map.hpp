// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"

#include <optional>

namespace spricka::fe {

/// Reference coordinates of a point x of the plane or space, which may lie outside the element, by
/// Newton's method from the centre with steps of at most half the domain; empty when it does not
/// get there. At a quarter-point tip convergence is linear (J vanishes there), which the number of
/// iterations allows for.
template <int dim>
std::optional<shape::Point<dim>> inverse_map(const AnyElement<dim>& element,
                                             const AnyNodeVectors<dim>& X,
                                             const shape::Point<dim>& x) {
  const double size = (X.colwise() - X.col(0)).cwiseAbs().maxCoeff();
  for (int i = 0; i < element.nodes; ++i) {
    if ((X.col(i) - x).norm() <= 1e-12 * size) {
      return element.node_local_coordinates(i);
    }
  }
  shape::Point<dim> r = element.centre();
  for (int iteration = 0; iteration < 60; ++iteration) {
    const shape::Point<dim> miss = x - X * element.N(r);
    if (miss.norm() <= 1e-13 * size) {
      return r;
    }
    const Eigen::Matrix<double, dim, dim> J = X.lazyProduct(element.dN(r));
    shape::Point<dim> step = J.inverse() * miss;
    const double length = step.norm();
    if (!(length < 1e6)) { // also when J is singular
      return std::nullopt;
    }
    r += length > 0.5 ? shape::Point<dim>(step * (0.5 / length)) : step;
    if (length <= 1e-15) {
      return r;
    }
  }
  return std::nullopt;
}

} // namespace spricka::fe
