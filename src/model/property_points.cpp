// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/property_points.hpp"

#include <map>
#include <utility>

namespace spricka::model {

FieldPointsByProperty property_points(const Mesh& mesh) {
  FieldPointsByProperty points;
  points.of.reserve(mesh.nodes.size());
  points.node.reserve(mesh.node_count());
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    points.node.emplace_back(n);
  }
  std::vector<base::PropertyId> first(mesh.node_count());
  std::vector<bool> met(mesh.node_count(), false);
  std::map<std::pair<base::NodeId, base::PropertyId>, std::int32_t> further;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::PropertyId property = mesh.property[e];
    for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
      if (!met[n.index()]) {
        met[n.index()] = true;
        first[n.index()] = property;
      }
      if (first[n.index()] == property) {
        points.of.push_back(n.value);
        continue;
      }
      const auto [place, fresh] =
          further.try_emplace({n, property}, static_cast<std::int32_t>(points.node.size()));
      if (fresh) {
        points.node.push_back(n);
      }
      points.of.push_back(place->second);
    }
  }
  return points;
}

} // namespace spricka::model
