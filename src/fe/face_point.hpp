// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/face.hpp"

#include <algorithm>

namespace spricka::fe {

/// The reference coordinates of a side, moved to the nearest point of its domain.
template <shape::Shape Side> shape::Point<Side::dim> into_side(const shape::Point<Side::dim>& r) {
  if constexpr (Side::domain == shape::Domain::triangle) {
    shape::Point<2> in = r.cwiseMax(0.0);
    const double over = in.sum() - 1.0;
    if (over > 0.0) { // straight back to the slanted side, then along it
      in = (in.array() - 0.5 * over).cwiseMax(0.0);
      in /= std::max(in.sum(), 1.0);
    }
    return in;
  } else {
    return r.cwiseMax(-1.0).cwiseMin(1.0);
  }
}

/// Reference coordinates of the foot of the perpendicular from x, by Gauss and Newton's method from
/// the centre, kept inside the side. Exact for points on the side and for those off it by a small
/// share of the radius of curvature. Beyond an edge of a skewed side it stays on that edge, but is
/// not the nearest point there.
template <shape::Shape Side>
shape::Point<Side::dim> foot_on_side(const SideNodes<Side>& X, const base::Vec3& x) {
  shape::Point<Side::dim> r = shape::centre<Side>();
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Eigen::Matrix<double, 3, Side::dim> T = X * Side::dN(r);
    const base::Vec3 miss = x - X * Side::N(r);
    const Eigen::Matrix<double, Side::dim, Side::dim> H = T.transpose() * T;
    shape::Point<Side::dim> step = H.inverse() * (T.transpose() * miss);
    const double length = step.norm();
    if (!(length < 1e6)) {
      break; // a side without area
    }
    step *= std::min(1.0, 0.5 / std::max(length, 1e-300));
    const shape::Point<Side::dim> next = into_side<Side>(r + step);
    const double moved = (next - r).norm();
    r = next;
    if (moved <= 1e-15) {
      break;
    }
  }
  return r;
}

/// Reference coordinates of the point of a side nearest to x: the foot of the perpendicular, or the
/// nearest point of its edges.
template <shape::Shape Side>
shape::Point<Side::dim> nearest_on_side(const SideNodes<Side>& X, const base::Vec3& x) {
  shape::Point<Side::dim> best = foot_on_side<Side>(X, x);
  if constexpr (Side::dim == 2) {
    using Edge = typename Side::Side;
    double least = (x - X * Side::N(best)).norm();
    for (int s = 0; s < base::info(Side::type).sides; ++s) {
      const std::span<const int> nodes = shape::side_nodes(Side::type, s);
      SideNodes<Edge> E;
      for (int i = 0; i < Edge::nodes; ++i) {
        E.col(i) = X.col(nodes[static_cast<std::size_t>(i)]);
      }
      const double t = foot_on_side<Edge>(E, x)[0];
      const shape::Point<2> r = 0.5 * (1.0 - t) * shape::node<Side>(nodes[0]) +
                                0.5 * (1.0 + t) * shape::node<Side>(nodes[1]);
      const double distance = (x - X * Side::N(r)).norm();
      if (distance < (1.0 - 1e-9) * least) {
        least = distance;
        best = r;
      }
    }
  }
  return best;
}

} // namespace spricka::fe
