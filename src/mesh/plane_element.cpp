// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/plane_element.hpp"

#include <cstddef>
#include <span>

namespace spricka::mesh {

base::Vec2 element_centroid(const model::Mesh& mesh, base::ElementId e) {
  const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e.index()]).corners);
  base::Vec2 sum = base::Vec2::Zero();
  for (const base::NodeId n : mesh.element_nodes(e).first(corners)) {
    sum += mesh.x[n.index()].head<2>();
  }
  return sum / static_cast<double>(corners);
}

double mean_side_length(const model::Mesh& mesh, base::ElementId e) {
  const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e.index()]).corners);
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  double sum = 0.0;
  for (std::size_t i = 0; i < corners; ++i) {
    sum += (mesh.x[nodes[(i + 1) % corners].index()] - mesh.x[nodes[i].index()]).norm();
  }
  return sum / static_cast<double>(corners);
}

} // namespace spricka::mesh
