// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/plane_features.hpp"

namespace spricka::contact {

std::vector<base::NodeId> ordered_nodes(std::span<const Edge> edges, bool closed) {
  std::vector<base::NodeId> nodes;
  for (const Edge& edge : edges) {
    nodes.push_back(edge.nodes[0]);
    if (edge.count == 3) {
      nodes.push_back(edge.nodes[2]);
    }
  }
  if (!closed) {
    nodes.push_back(edges.back().nodes[1]);
  }
  return nodes;
}

} // namespace spricka::contact
