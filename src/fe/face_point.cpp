// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/face_point.hpp"

#include <algorithm>

namespace spricka::fe {

template <int dim>
shape::Point<dim> clamp_to_side(const AnyElement<dim>& side, const shape::Point<dim>& r) {
  if (side.domain != shape::ReferenceDomain::triangle) {
    return r.cwiseMax(-1.0).cwiseMin(1.0);
  }
  shape::Point<dim> in = r.cwiseMax(0.0);
  const double over = in.sum() - 1.0;
  if (over > 0.0) { // straight back to the slanted side, then along it
    in = (in.array() - 0.5 * over).cwiseMax(0.0);
    in /= std::max(in.sum(), 1.0);
  }
  return in;
}

namespace {

// Reference coordinates of the foot of the perpendicular from x, by Gauss and Newton's method from
// the centre, kept inside the side. Exact for points on the side and for those off it by a small
// share of the radius of curvature. Beyond an edge of a skewed side it stays on that edge, but is
// not the nearest point there.
template <int dim>
shape::Point<dim> foot_on_side(const AnyElement<dim>& side, const SpaceNodes<dim>& X,
                               const base::Vec3& x) {
  shape::Point<dim> r = side.centre();
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Eigen::Matrix<double, 3, dim> T = X.lazyProduct(side.dN(r));
    const base::Vec3 miss = x - X * side.N(r);
    const Eigen::Matrix<double, dim, dim> H = T.transpose() * T;
    shape::Point<dim> step = H.inverse() * (T.transpose() * miss);
    const double length = step.norm();
    if (!(length < 1e6)) {
      break; // a side without area
    }
    step *= std::min(1.0, 0.5 / std::max(length, 1e-300));
    const shape::Point<dim> next = clamp_to_side<dim>(side, r + step);
    const double moved = (next - r).norm();
    r = next;
    if (moved <= 1e-15) {
      break;
    }
  }
  return r;
}

} // namespace

template <int dim>
shape::Point<dim> nearest_on_side(const AnyElement<dim>& side, const SpaceNodes<dim>& X,
                                  const base::Vec3& x) {
  shape::Point<dim> best = foot_on_side<dim>(side, X, x);
  if constexpr (dim == 2) {
    double least = (x - X * side.N(best)).norm();
    const shape::ReferenceElement<1>& edge = shape::reference_line(side.quadratic ? 3 : 2);
    for (int s = 0; s < side.corners; ++s) { // edge s joins corners s and s + 1
      const int next = (s + 1) % side.corners;
      SpaceNodes<1> E(3, edge.nodes);
      E.col(0) = X.col(s);
      E.col(1) = X.col(next);
      if (side.quadratic) {
        E.col(2) = X.col(side.corners + s);
      }
      const double t = foot_on_side<1>(edge, E, x)[0];
      const shape::Point<2> r = 0.5 * (1.0 - t) * side.node_coordinates(s) +
                                0.5 * (1.0 + t) * side.node_coordinates(next);
      const double distance = (x - X * side.N(r)).norm();
      if (distance < (1.0 - 1e-9) * least) {
        least = distance;
        best = r;
      }
    }
  }
  return best;
}

#define NEAREST(dim)                                                                               \
  template shape::Point<dim> clamp_to_side<dim>(const AnyElement<dim>&, const shape::Point<dim>&); \
  template shape::Point<dim> nearest_on_side<dim>(const AnyElement<dim>&, const SpaceNodes<dim>&,  \
                                                  const base::Vec3&);
NEAREST(1)
NEAREST(2)

} // namespace spricka::fe
