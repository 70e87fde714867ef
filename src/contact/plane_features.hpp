// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/plane_edge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

/// What contact surfaces have in the plane only: edges that follow one another along curves.
namespace spricka::contact {

using Edge = mesh::PlaneEdge;
using mesh::edge_shape_functions;
using mesh::edge_tangent;
using mesh::outer_normal;
using mesh::point_on_edge;

/// Hats on half edges: piecewise linear, non-negative, sum 1; [node of the edge], those behind its
/// last node zero.
inline std::array<double, 3> edge_hat_values(const Edge& edge, double xi) {
  if (edge.count == 2) {
    return {0.5 * (1.0 - xi), 0.5 * (1.0 + xi), 0.0};
  }
  return {std::max(0.0, -xi), std::max(0.0, xi), 1.0 - std::abs(xi)};
}

/// Edges one behind the other, the body on their left; a closed chain ends where it starts.
struct EdgeChain {
  std::size_t first = 0, count = 0; ///< among the edges of the surface
  bool closed = false;
};

/// The order of a surface along its curves.
struct PlanarEdgeChains {
  std::vector<Edge> edges; ///< [facet], chain by chain
  std::vector<EdgeChain> chains;

  [[nodiscard]] std::span<const Edge> edges_of_chain(const EdgeChain& chain) const {
    return std::span(edges).subspan(chain.first, chain.count);
  }
};

} // namespace spricka::contact
