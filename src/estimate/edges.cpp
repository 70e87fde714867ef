// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/edges.hpp"

#include "shape/topology.hpp"

#include <algorithm>
#include <numeric>

namespace spricka::estimate {

EdgeTable make_edge_table(const model::Mesh& mesh) {
  struct Side {
    std::array<base::NodeId, 3> nodes;
    std::size_t at = 0; ///< in of_side
  };
  EdgeTable table;
  table.first.push_back(0);
  std::vector<Side> sides;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementType type = mesh.type[e];
    const std::span<const base::NodeId> nodes = mesh.element_nodes(base::ElementId(e));
    for (int s = 0; s < base::element_info(type).sides; ++s) {
      const std::span<const int> local = shape::side_nodes(type, s);
      const auto node = [&](std::size_t i) { return nodes[static_cast<std::size_t>(local[i])]; };
      // Two faces of a crack may share both corners: the middle tells them apart.
      sides.push_back(
          {{std::min(node(0), node(1)), std::max(node(0), node(1)), node(2)}, sides.size()});
    }
    table.first.push_back(static_cast<std::int32_t>(sides.size()));
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.nodes != b.nodes ? a.nodes < b.nodes : a.at < b.at;
  });
  // The first side of an edge numbers it.
  std::vector<std::size_t> leader(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool same = i > 0 && sides[i].nodes == sides[i - 1].nodes;
    leader[sides[i].at] = same ? leader[sides[i - 1].at] : sides[i].at;
  }
  std::vector<std::array<base::NodeId, 3>> nodes(sides.size());
  for (const Side& side : sides) {
    nodes[side.at] = side.nodes;
  }
  table.of_side.resize(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (leader[i] == i) {
      table.of_side[i] = static_cast<std::int32_t>(table.edges.size());
      table.edges.push_back({nodes[i], 0});
    } else {
      table.of_side[i] = table.of_side[leader[i]];
    }
    table.edges[static_cast<std::size_t>(table.of_side[i])].elements += 1;
  }
  return table;
}

} // namespace spricka::estimate
