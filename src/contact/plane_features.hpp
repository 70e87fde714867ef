// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/facet.hpp"
#include "mesh/plane_edge.hpp"

#include <cstddef>
#include <span>
#include <vector>

/// What contact surfaces have in the plane only: edges that follow one another along curves.
namespace spricka::contact {

using Edge = mesh::PlaneEdge;
using mesh::edge_dN;
using mesh::edge_N;
using mesh::outer_normal;
using mesh::point_on;
using mesh::tangent_on;

inline FacetValues edge_hats(const Edge& edge, double xi) {
  return line_hats(edge.count, xi);
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

/// Nodes of a chain in order, mid nodes between their ends.
std::vector<base::NodeId> ordered_nodes(std::span<const Edge> edges, bool closed);

} // namespace spricka::contact
