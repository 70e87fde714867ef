// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/path_gap.hpp"

#include "shape/topology.hpp"

#include <algorithm>
#include <span>

namespace spricka::mesh {

std::optional<std::size_t> find_path_gap(const model::Mesh& mesh,
                                         const std::vector<base::NodeId>& path) {
  if (mesh.dim != 2 || path.size() < 2) {
    return std::nullopt;
  }
  // place of a node in the path, from 1; 0: not in it
  std::vector<std::size_t> place(mesh.node_count(), 0);
  for (std::size_t i = 0; i < path.size(); ++i) {
    place[path[i].index()] = i + 1;
  }
  std::vector<bool> joined(path.size(), false); // with the node before it
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::span<const base::NodeId> nodes = mesh.element_nodes(base::ElementId(e));
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const std::span<const int> side = shape::side_nodes(mesh.type[e], s);
      for (const int a : side) {
        for (const int b : side) {
          const std::size_t i = place[nodes[static_cast<std::size_t>(a)].index()];
          const std::size_t j = place[nodes[static_cast<std::size_t>(b)].index()];
          // Both orders come up in the two loops, and middle nodes with either end.
          if (i > 0 && j == i + 1) {
            joined[i] = true;
          }
        }
      }
    }
  }
  const auto gap = std::find(joined.begin() + 1, joined.end(), false);
  return gap == joined.end() ? std::nullopt
                             : std::optional(static_cast<std::size_t>(gap - joined.begin()));
}

} // namespace spricka::mesh
