// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/side_index.hpp"

#include "shape/topology.hpp"

#include <algorithm>

namespace spricka::mesh {

SideIndex::SideIndex(const model::Mesh& mesh, std::size_t first) {
  for (std::size_t e = first; e < mesh.element_count(); ++e) {
    const base::ElementInfo& info = base::info(mesh.type[e]);
    const auto nodes = mesh.nodes_of(base::ElementId(e));
    for (int s = 0; s < info.sides; ++s) {
      std::vector<base::NodeId> key;
      for (const int i : shape::side_nodes(mesh.type[e], s)) {
        if (i < info.corners) {
          key.push_back(nodes[static_cast<std::size_t>(i)]);
        }
      }
      std::sort(key.begin(), key.end());
      sides_[key].push_back({base::ElementId(e), s});
    }
  }
}

std::span<const model::Face> SideIndex::find(std::vector<base::NodeId> corners) const {
  std::sort(corners.begin(), corners.end());
  const auto at = sides_.find(corners);
  return at == sides_.end() ? std::span<const model::Face>() : at->second;
}

} // namespace spricka::mesh
