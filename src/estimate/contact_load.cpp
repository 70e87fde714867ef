// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/contact_load.hpp"

#include "estimate/mode_kernel.hpp"

#include <map>

namespace spricka::estimate {

std::vector<ContactModeWeight> target_mode_weights(const EdgeTable& table,
                                                   const contact::PairConstraints& pair) {
  if (!pair.segments || pair.rigid) {
    return {};
  }
  const EdgeIndex index = index_boundary_edges(table);
  const std::map<base::NodeId, std::size_t> row_of = contact::map_nodes_to_normal_rows(pair);
  std::map<std::pair<std::size_t, std::size_t>, double> sums; // by freedom and row
  for (std::size_t e = 0; e < pair.contact.elements.size(); ++e) {
    const contact::HatElement& element = pair.contact.elements[e];
    const std::vector<base::NodeId>& nodes = pair.contact.facets[element.facet].nodes;
    for (const contact::PairQuadraturePoint& p : (*pair.opposite)[e]) {
      const contact::Edge& target = pair.target.plane.edges[p.target];
      const std::optional<std::size_t> at = find_mesh_edge(index, target);
      if (!at) {
        continue;
      }
      const double sign = side_mode_sign(target.nodes[0], target.nodes[1]);
      const base::Vec2 n = p.normal.head<2>();
      // The normal mode of the target's edge, psi n_m . n of (estimate.14).
      const double mode =
          sign * side_mode_value(p.s[0]) * side_frame(target.x, p.s[0]).axis[0].dot(n);
      for (std::size_t i = 0; i < element.node_count(); ++i) {
        const auto row = row_of.find(nodes[static_cast<std::size_t>(element.node[i])]);
        if (row != row_of.end()) {
          sums[{2 * *at, row->second}] += p.weight * p.hat[static_cast<Eigen::Index>(i)] * mode;
        }
      }
    }
  }
  std::vector<ContactModeWeight> weights;
  weights.reserve(sums.size());
  for (const auto& [place, weight] : sums) {
    weights.push_back({place.first, place.second, weight});
  }
  return weights;
}

} // namespace spricka::estimate
