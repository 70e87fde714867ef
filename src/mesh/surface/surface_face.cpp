// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_face.hpp"

#include "shape/reference_element.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

namespace {

constexpr int most_steps = 60;

Vec2 into_domain(shape::ReferenceDomain domain, const Vec2& r) {
  if (domain != shape::ReferenceDomain::triangle) {
    return r.cwiseMax(-1.0).cwiseMin(1.0);
  }
  Vec2 in = r.cwiseMax(0.0);
  const double over = in.sum() - 1.0;
  if (over > 0.0) { // straight back to the slanted side, then along it
    in = (in.array() - 0.5 * over).cwiseMax(0.0);
    in /= std::max(in.sum(), 1.0);
  }
  return in;
}

/// Foot of the perpendicular by Gauss and Newton's method, kept inside the face.
Vec2 foot_on(const CurvedFace& face, const Vec3& x) {
  const shape::ReferenceElement<2>& element = shape::reference_element<2>(face.shape);
  Vec2 r = element.centre();
  for (int i = 0; i < most_steps; ++i) {
    const Eigen::Matrix<double, 3, 2> T = face.X.lazyProduct(element.dN(r));
    const Vec3 miss = x - face.X * element.N(r);
    const Eigen::Matrix2d H = T.transpose() * T;
    Vec2 step = H.inverse() * (T.transpose() * miss);
    const double length = step.norm();
    if (!(length < 1e6)) {
      break; // a face without area
    }
    step *= std::min(1.0, 0.5 / std::max(length, 1e-300));
    const Vec2 next = into_domain(element.domain, r + step);
    const double moved = (next - r).norm();
    r = next;
    if (moved <= 1e-15) {
      break;
    }
  }
  return r;
}

/// The foot on the edge from corner i to the next, as t.
double foot_on_edge(const CurvedFace& face, int i, const Vec3& x) {
  const std::span<const int> nodes = shape::side_nodes(face.shape, i);
  const shape::ReferenceElement<1>& edge = shape::reference_line(static_cast<int>(nodes.size()));
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, shape::most_nodes<1>> E(3, edge.nodes);
  for (int k = 0; k < edge.nodes; ++k) {
    E.col(k) = face.X.col(nodes[static_cast<std::size_t>(k)]);
  }
  shape::Point<1> t(0.0);
  for (int step = 0; step < most_steps; ++step) {
    const Vec3 T = E * edge.dN(t);
    const Vec3 miss = x - E * edge.N(t);
    const double to = T.dot(miss) / std::max(T.squaredNorm(), 1e-300);
    const double next = std::clamp(t[0] + std::clamp(to, -0.5, 0.5), -1.0, 1.0);
    const double moved = std::abs(next - t[0]);
    t[0] = next;
    if (moved <= 1e-15) {
      break;
    }
  }
  return t[0];
}

} // namespace

CurvedFace make_surface_face(const model::Mesh& mesh, const model::Face& face) {
  const base::ElementType type = mesh.type[face.element.index()];
  const std::span<const base::NodeId> nodes = mesh.element_nodes(face.element);
  CurvedFace out{face, shape::solid_side_type(type, face.side), {}, {}};
  for (const int local : shape::side_nodes(type, face.side)) {
    out.nodes.push_back(nodes[static_cast<std::size_t>(local)]);
  }
  out.X.resize(3, static_cast<Eigen::Index>(out.nodes.size()));
  for (std::size_t i = 0; i < out.nodes.size(); ++i) {
    out.X.col(static_cast<Eigen::Index>(i)) = mesh.x[out.nodes[i].index()];
  }
  return out;
}

Vec3 CurvedFacePoint::normal() const {
  return slope.col(0).cross(slope.col(1)).normalized();
}

CurvedFacePoint point_on(const CurvedFace& face, const Vec2& r) {
  const shape::ReferenceElement<2>& element = shape::reference_element<2>(face.shape);
  return {face.X * element.N(r), face.X.lazyProduct(element.dN(r))};
}

Vec2 edge_coordinates(base::ElementType shape, int i, double t) {
  const shape::ReferenceElement<2>& element = shape::reference_element<2>(shape);
  const int next = (i + 1) % element.corners;
  return 0.5 * (1.0 - t) * element.node_coordinates(i) +
         0.5 * (1.0 + t) * element.node_coordinates(next);
}

double distance_outside(base::ElementType shape, const Vec2& r) {
  return shape::reference_element<2>(shape).distance_outside(r);
}

Vec2 clamp_to_face(base::ElementType shape, const Vec2& r) {
  return into_domain(shape::reference_element<2>(shape).domain, r);
}

Vec2 nearest_on(const CurvedFace& face, const Vec3& x) {
  Vec2 best = foot_on(face, x);
  // A foot that was kept from leaving is not the nearest place of its edge.
  double least = distance_outside(face.shape, best) < -1e-14 ? (x - point_on(face, best).x).norm()
                                                             : std::numeric_limits<double>::max();
  for (int i = 0; i < face.corners(); ++i) {
    const Vec2 r = edge_coordinates(face.shape, i, foot_on_edge(face, i, x));
    const double distance = (x - point_on(face, r).x).norm();
    if (distance < (1.0 - 1e-9) * least) {
      least = distance;
      best = r;
    }
  }
  return best;
}

// A quadratic face lies in the hull of its Bezier points (Farin 2002): corners, twice the mid nodes
// less the middle of the edge's ends, and of quadrilaterals one for the centre.
std::array<Vec3, 2> bounding_box(const CurvedFace& face) {
  const Eigen::Index corners = face.corners();
  Vec3 low = face.X.leftCols(corners).rowwise().minCoeff();
  Vec3 high = face.X.leftCols(corners).rowwise().maxCoeff();
  const auto take = [&](const Vec3& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  };
  if (face.quadratic()) {
    Vec3 mids = Vec3::Zero();
    for (Eigen::Index i = 0; i < corners; ++i) {
      const Vec3 mid = face.X.col(corners + i);
      take(2.0 * mid - 0.5 * (face.X.col(i) + face.X.col((i + 1) % corners)));
      mids += mid;
    }
    if (corners == 4) {
      const Vec3 ends = face.X.leftCols(4).rowwise().sum();
      const Vec3 centre = face.X.cols() == 9 ? Vec3(face.X.col(8)) : Vec3(0.5 * mids - 0.25 * ends);
      take(4.0 * centre - mids + 0.25 * ends);
    }
  }
  return {low, high};
}

} // namespace spricka::mesh
