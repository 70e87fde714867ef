// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/folded_elements.hpp"

#include <utility>

namespace spricka::mesh {

using base::NodeId;

std::vector<InvalidElement> folded_elements(const SolidPatchNet& net,
                                            const std::vector<std::size_t>& elements) {
  model::Mesh mesh;
  mesh.dim = 3;
  std::vector<NodeId> number(net.nodes.size());
  std::vector<NodeId> nodes;
  for (const std::size_t e : elements) {
    const SolidPatchElement& element = net.elements[e];
    nodes.clear();
    for (const int n : element.nodes) {
      NodeId& own = number[static_cast<std::size_t>(n)];
      if (!own.valid()) {
        own = model::add_node(mesh, net.position(n), 0, {});
      }
      nodes.push_back(own);
    }
    model::add_element(mesh, element.type, nodes, 0, {});
  }
  std::vector<InvalidElement> bad = mesh_faults(mesh).bad;
  for (InvalidElement& element : bad) {
    element.element = base::ElementId(elements[element.element.index()]);
  }
  return bad;
}

} // namespace spricka::mesh
