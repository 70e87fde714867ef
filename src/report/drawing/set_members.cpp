// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/set_members.hpp"

#include "model/property_points.hpp"

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
        const std::span<const base::NodeId> own = mesh.element_nodes(e);
        found.insert(found.end(), own.begin(), own.end());
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<StressPoint> stress_points(const model::Mesh& mesh, std::string_view name) {
  const model::PropertyPoints points = model::property_points(mesh);
  std::vector<bool> wanted(points.node.size(), false);
  for (const model::ElementSet& set : mesh.element_sets) {
    for (std::size_t i = 0; set.name == name && i < set.elements.size(); ++i) {
      const std::size_t e = set.elements[i].index();
      for (std::int32_t k = mesh.first[e]; k < mesh.first[e + 1]; ++k) {
        wanted[static_cast<std::size_t>(points.of[static_cast<std::size_t>(k)])] = true;
      }
    }
  }
  for (const model::NodeSet& set : mesh.node_sets) {
    if (set.name == name) {
      std::vector<bool> inside(mesh.node_count(), false);
      for (const base::NodeId n : set.nodes) {
        inside[n.index()] = true;
      }
      for (std::size_t p = 0; p < wanted.size(); ++p) {
        wanted[p] = wanted[p] || inside[points.node[p].index()];
      }
    }
  }
  std::vector<StressPoint> found;
  for (std::size_t p = 0; p < wanted.size(); ++p) {
    if (wanted[p]) {
      found.push_back({points.node[p], p});
    }
  }
  std::ranges::stable_sort(found, {}, &StressPoint::node);
  return found;
}

} // namespace spricka::report
