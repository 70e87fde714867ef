// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/set_members.hpp"

#include <algorithm>

namespace spricka::report {

std::vector<base::NodeId> set_members(const model::Mesh& mesh, std::string_view name) {
  std::vector<base::NodeId> found;
  for (const model::NodeSet& set : mesh.node_sets) {
    if (set.name == name) {
      found = set.nodes;
    }
  }
  for (const model::ElementSet& set : mesh.element_sets) {
    if (set.name == name) {
      for (const base::ElementId e : set.elements) {
        const std::span<const base::NodeId> own = mesh.nodes_of(e);
        found.insert(found.end(), own.begin(), own.end());
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

} // namespace spricka::report
