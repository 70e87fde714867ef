// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/folded_elements.hpp"

#include <algorithm>
#include <numeric>

namespace spricka::mesh {

using base::NodeId;

std::vector<InvalidElement> find_folded_elements(std::span<const PatchNode> nodes,
                                                 std::span<const PatchElement> elements,
                                                 const std::vector<std::size_t>& asked) {
  model::Mesh mesh;
  std::vector<NodeId> number(nodes.size());
  std::vector<NodeId> own_nodes;
  for (const std::size_t e : asked) {
    own_nodes.clear();
    for (const int n : elements[e].nodes) {
      const auto i = static_cast<std::size_t>(n);
      if (!number[i].valid()) {
        number[i] = model::add_node(mesh, nodes[i].x, 0, {});
      }
      own_nodes.push_back(number[i]);
    }
    model::add_element(mesh, elements[e].type, own_nodes, 0, {});
  }
  std::vector<InvalidElement> bad = find_invalid_elements(mesh);
  for (InvalidElement& element : bad) {
    element.element = base::ElementId(asked[element.element.index()]);
  }
  return bad;
}

std::vector<InvalidElement> find_folded_elements(std::span<const PatchNode> nodes,
                                                 std::span<const PatchElement> elements) {
  std::vector<std::size_t> all(elements.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return find_folded_elements(nodes, elements, all);
}

const InvalidElement& most_folded_element(const std::vector<InvalidElement>& folded) {
  return *std::ranges::min_element(folded, {}, &InvalidElement::jacobian);
}

} // namespace spricka::mesh
