// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/plane_edge.hpp"

#include "shape/quadrature.hpp"
#include "shape/topology.hpp"

#include <span>

namespace spricka::mesh {

using base::Vec2;

PlaneEdge plane_edge(const model::Mesh& mesh, const model::Face& face) {
  const std::span<const base::NodeId> nodes = mesh.element_nodes(face.element);
  const std::span<const int> side = shape::side_nodes(mesh.type[face.element.index()], face.side);
  PlaneEdge edge;
  edge.count = static_cast<int>(side.size());
  for (std::size_t i = 0; i < side.size(); ++i) {
    edge.nodes[i] = nodes[static_cast<std::size_t>(side[i])];
    edge.x[i] = mesh.x[edge.nodes[i].index()].head<2>();
  }
  // exact for the length of a straight edge, 1e-8 for arcs of 30 degrees
  for (const auto& [r, weight] : shape::line_rule(5)) {
    edge.length += weight * edge_tangent(edge, r[0]).norm();
  }
  return edge;
}

std::array<double, 3> edge_shape_functions(const PlaneEdge& edge, double xi) {
  if (edge.count == 2) {
    return {0.5 * (1.0 - xi), 0.5 * (1.0 + xi), 0.0};
  }
  return {0.5 * xi * (xi - 1.0), 0.5 * xi * (xi + 1.0), 1.0 - xi * xi};
}

namespace {

/// Derivatives of the shape functions by xi; entry 2 is zero for straight edges.
std::array<double, 3> edge_dN(const PlaneEdge& edge, double xi) {
  if (edge.count == 2) {
    return {-0.5, 0.5, 0.0};
  }
  return {xi - 0.5, xi + 0.5, -2.0 * xi};
}

Vec2 combine_nodes(const PlaneEdge& edge, const std::array<double, 3>& factor) {
  Vec2 sum = factor[0] * edge.x[0] + factor[1] * edge.x[1];
  if (edge.count == 3) {
    sum += factor[2] * edge.x[2];
  }
  return sum;
}

} // namespace

Vec2 point_on_edge(const PlaneEdge& edge, double xi) {
  return combine_nodes(edge, edge_shape_functions(edge, xi));
}

Vec2 edge_tangent(const PlaneEdge& edge, double xi) {
  return combine_nodes(edge, edge_dN(edge, xi));
}

Vec2 outer_normal(const PlaneEdge& edge, double xi) {
  const Vec2 t = edge_tangent(edge, xi).normalized();
  return {t.y(), -t.x()};
}

} // namespace spricka::mesh
