// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spricka::model {

void reserve(Mesh& mesh, std::size_t nodes, std::size_t elements, std::size_t entries) {
  mesh.x.reserve(nodes);
  mesh.node_label.reserve(nodes);
  mesh.node_net.reserve(nodes);
  mesh.type.reserve(elements);
  mesh.first.reserve(elements + 1);
  mesh.nodes.reserve(entries);
  mesh.element_label.reserve(elements);
  mesh.element_net.reserve(elements);
  mesh.property.reserve(elements);
}

std::vector<base::ElementId> all_elements(const Mesh& mesh) {
  std::vector<base::ElementId> elements;
  elements.reserve(mesh.element_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    elements.emplace_back(e);
  }
  return elements;
}

base::Vec3 element_corner_mean(const Mesh& mesh, base::ElementId e) {
  const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e.index()]).corners);
  base::Vec3 mean = base::Vec3::Zero();
  for (const base::NodeId n : mesh.element_nodes(e).first(corners)) {
    mean += mesh.x[n.index()] / static_cast<double>(corners);
  }
  return mean;
}

std::vector<bool> mark_nodes_in_use(const Mesh& mesh) {
  return mark_members(mesh.node_count(), mesh.nodes);
}

double axis_tolerance(const Mesh& mesh) {
  double largest = 0.0;
  for (const base::Vec3& x : mesh.x) {
    largest = std::max(largest, std::abs(x.x()));
  }
  return 1e-9 * largest;
}

base::NodeId add_node(Mesh& mesh, const base::Vec3& x, base::Label label, base::NetId net) {
  mesh.x.push_back(x);
  mesh.node_label.push_back(label);
  mesh.node_net.push_back(net);
  return base::NodeId(mesh.x.size() - 1);
}

base::ElementId add_element(Mesh& mesh, base::ElementType type, std::span<const base::NodeId> nodes,
                            base::Label label, base::NetId net) {
  assert(static_cast<int>(nodes.size()) == base::element_info(type).nodes);
  if (mesh.first.empty()) {
    mesh.first.push_back(0);
  }
  mesh.type.push_back(type);
  mesh.nodes.insert(mesh.nodes.end(), nodes.begin(), nodes.end());
  mesh.first.push_back(static_cast<std::int32_t>(mesh.nodes.size()));
  mesh.element_label.push_back(label);
  mesh.element_net.push_back(net);
  mesh.property.emplace_back();
  return base::ElementId(mesh.type.size() - 1);
}

} // namespace spricka::model
