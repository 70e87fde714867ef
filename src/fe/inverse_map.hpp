// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"

#include <optional>

namespace spricka::fe {

/// Reference coordinates of a point x of the plane or space, which may lie outside the element, by
/// Newton's method from the centre with steps of at most half the domain; empty when it does not
/// get there. At a quarter-point tip convergence is linear (J vanishes there), which the number of
/// iterations allows for.
template <shape::ElementShape S>
std::optional<shape::Point<S::dim>> inverse_map(const NodeVectors<S>& X,
                                                const shape::Point<S::dim>& x) {
  const double size = (X.colwise() - X.col(0)).cwiseAbs().maxCoeff();
  for (int i = 0; i < S::nodes; ++i) {
    if ((X.col(i) - x).norm() <= 1e-12 * size) {
      return shape::node<S>(i);
    }
  }
  shape::Point<S::dim> r = shape::centre<S>();
  for (int iteration = 0; iteration < 60; ++iteration) {
    const shape::Point<S::dim> miss = x - X * S::N(r);
    if (miss.norm() <= 1e-13 * size) {
      return r;
    }
    const Eigen::Matrix<double, S::dim, S::dim> J = X * S::dN(r);
    shape::Point<S::dim> step = J.inverse() * miss;
    const double length = step.norm();
    if (!(length < 1e6)) { // also when J is singular
      return std::nullopt;
    }
    r += length > 0.5 ? shape::Point<S::dim>(step * (0.5 / length)) : step;
    if (length <= 1e-15) {
      return r;
    }
  }
  return std::nullopt;
}

} // namespace spricka::fe
