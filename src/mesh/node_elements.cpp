// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/node_elements.hpp"

namespace spricka::mesh {

NodeToElementsMap::NodeToElementsMap(const model::Mesh& mesh)
    : start_(mesh.node_count() + 1, 0), elements_(mesh.nodes.size()) {
  for (const base::NodeId n : mesh.nodes) {
    ++start_[n.index() + 1];
  }
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    start_[n + 1] += start_[n];
  }
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
      elements_[next[n.index()]++] = base::ElementId(e);
    }
  }
}

} // namespace spricka::mesh
