// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/element_side.hpp"

#include "shape/topology.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <limits>

namespace spricka::geometry {

using base::Vec2;
using base::Vec3;

namespace {

template <int dim>
shape::Point<dim> clamp_to_domain(shape::ReferenceDomain domain, const shape::Point<dim>& r) {
  if (domain != shape::ReferenceDomain::triangle) {
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

// Foot of the perpendicular from x, from the centre, kept inside the domain. Beyond an edge of a
// skewed face it stays on that edge, but is not the nearest point there. Steps of `longest` and
// more end it: a side without area, or a point very far off.
template <int dim>
shape::Point<dim> foot_of_perpendicular(const shape::ReferenceElement<dim>& element,
                                        const SidePositions& X, const Vec3& x, double longest) {
  shape::Point<dim> r = element.centre();
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Eigen::Matrix<double, 3, dim> T = X.lazyProduct(element.dN(r));
    const Vec3 miss = x - X * element.N(r);
    const Eigen::Matrix<double, dim, dim> H = T.transpose() * T;
    shape::Point<dim> step = H.inverse() * (T.transpose() * miss);
    const double length = step.norm();
    if (!(length < longest)) {
      break;
    }
    step *= std::min(1.0, 0.5 / std::max(length, 1e-300));
    const shape::Point<dim> next = clamp_to_domain<dim>(element.domain, r + step);
    const double moved = (next - r).norm();
    r = next;
    if (moved <= 1e-15) {
      break;
    }
  }
  return r;
}

constexpr double longest_step = 1e6; // in local coordinates

} // namespace

std::vector<base::NodeId> side_nodes(base::ElementType type, int side,
                                     std::span<const base::NodeId> element_nodes) {
  std::vector<base::NodeId> nodes;
  for (const int local : shape::side_nodes(type, side)) {
    nodes.push_back(element_nodes[static_cast<std::size_t>(local)]);
  }
  return nodes;
}

ElementSide::ElementSide(base::ElementType type, int side_,
                         std::span<const base::NodeId> element_nodes, std::span<const Vec3> x)
    : side(side_), nodes(side_nodes(type, side_, element_nodes)),
      X(3, static_cast<Eigen::Index>(nodes.size())) {
  if (shape::side_domain(type, side) == shape::ReferenceDomain::line) {
    edge_ = &shape::reference_line(static_cast<int>(nodes.size()));
  } else {
    face_ = &shape::reference_element<2>(shape::solid_side_type(type, side));
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    X.col(static_cast<Eigen::Index>(i)) = x[nodes[i].index()];
  }
}

Vec2 ElementSide::node_local_coordinates(int node) const {
  return is_edge() ? Vec2(edge_->node_local_coordinates(node)[0], 0.0)
                   : face_->node_local_coordinates(node);
}

Vec2 ElementSide::domain_centre() const {
  return is_edge() ? Vec2(edge_->centre()[0], 0.0) : face_->centre();
}

double ElementSide::distance_outside(const Vec2& r) const {
  return is_edge() ? edge_->distance_outside(r.head<1>()) : face_->distance_outside(r);
}

Vec2 ElementSide::clamp_to_side(const Vec2& r) const {
  return clamp_to_domain<2>(domain(), r);
}

Vec2 ElementSide::edge_coordinates(int i, double t) const {
  assert(face_ != nullptr);
  const int next = (i + 1) % face_->corners;
  return 0.5 * (1.0 - t) * face_->node_local_coordinates(i) +
         0.5 * (1.0 + t) * face_->node_local_coordinates(next);
}

SideValues ElementSide::N(const Vec2& r) const {
  if (is_edge()) {
    return edge_->N(r.head<1>());
  }
  return face_->N(r);
}

SideDerivatives ElementSide::dN(const Vec2& r) const {
  if (face_ != nullptr) {
    return face_->dN(r);
  }
  SideDerivatives dN = SideDerivatives::Zero(edge_->nodes, 2);
  dN.col(0) = edge_->dN(r.head<1>());
  return dN;
}

SideTangents ElementSide::tangents(const Vec2& r) const {
  if (face_ != nullptr) {
    return X.lazyProduct(face_->dN(r));
  }
  SideTangents tangents;
  tangents << X.lazyProduct(edge_->dN(r.head<1>())), Vec3::UnitZ();
  return tangents;
}

double ElementSide::area(int degree) const {
  double area = 0.0;
  for_quadrature_points(
      degree, [&](const Vec2& r, double weight) { area += weight * area_vector(r).norm(); });
  return area;
}

Vec2 ElementSide::nearest_local_coordinates(const Vec3& x, ClampedFootPolicy border) const {
  if (is_edge()) {
    return {foot_of_perpendicular<1>(*edge_, X, x, longest_step)[0], 0.0};
  }
  Vec2 best = foot_of_perpendicular<2>(*face_, X, x, longest_step);
  const bool stands = border == ClampedFootPolicy::compared || distance_outside(best) < -1e-14;
  const double longest = border == ClampedFootPolicy::compared
                             ? longest_step
                             : std::numeric_limits<double>::infinity();
  double least = stands ? (x - position(best)).norm() : std::numeric_limits<double>::max();
  const shape::ReferenceElement<1>& edge = shape::reference_line(is_quadratic() ? 3 : 2);
  for (int i = 0; i < corner_count(); ++i) {
    SidePositions E(3, edge.nodes);
    E.col(0) = X.col(i);
    E.col(1) = X.col((i + 1) % corner_count());
    if (is_quadratic()) {
      E.col(2) = X.col(corner_count() + i);
    }
    const Vec2 r = edge_coordinates(i, foot_of_perpendicular<1>(edge, E, x, longest)[0]);
    const double distance = (x - position(r)).norm();
    if (distance < (1.0 - 1e-9) * least) {
      least = distance;
      best = r;
    }
  }
  return best;
}

// Corners, twice the mid nodes less the middle of the edge's ends, and of quadrilaterals one for
// the centre.
Box<3> ElementSide::bounding_box() const {
  const Eigen::Index count = corner_count();
  Box<3> box{X.leftCols(count).rowwise().minCoeff(), X.leftCols(count).rowwise().maxCoeff()};
  const auto take = [&](const Vec3& x) { box.extend({x, x}); };
  if (!is_quadratic()) {
    return box;
  }
  Vec3 mids = Vec3::Zero();
  for (Eigen::Index i = 0; i < (is_edge() ? 1 : count); ++i) {
    const Vec3 mid = X.col(count + i);
    take(2.0 * mid - 0.5 * (X.col(i) + X.col((i + 1) % count)));
    mids += mid;
  }
  if (count == 4) {
    const Vec3 ends = X.leftCols(4).rowwise().sum();
    const Vec3 centre = X.cols() == 9 ? Vec3(X.col(8)) : Vec3(0.5 * mids - 0.25 * ends);
    take(4.0 * centre - mids + 0.25 * ends);
  }
  return box;
}

} // namespace spricka::geometry
