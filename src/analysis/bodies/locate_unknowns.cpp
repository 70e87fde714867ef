// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/bodies/locate_unknowns.hpp"
#include "base/index.hpp"

#include <cstddef>

namespace spricka::analysis {

solve::UnknownPlaces locate_unknowns(const model::Mesh& mesh, const fe::DofMap& map) {
  const auto dim = static_cast<std::size_t>(mesh.dim);
  std::vector<std::int32_t> number(mesh.node_count(), -1); // [node of the mesh]
  std::vector<std::size_t> nodes;
  solve::UnknownPlaces places;
  places.node.reserve(map.freedom.size());
  places.axis.reserve(map.freedom.size());
  for (const std::int32_t freedom : map.freedom) {
    const std::size_t node = static_cast<std::size_t>(freedom) / dim;
    if (number[node] < 0) {
      number[node] = static_cast<std::int32_t>(nodes.size());
      nodes.push_back(node);
    }
    places.node.push_back(number[node]);
    places.axis.push_back(static_cast<std::int8_t>(static_cast<std::size_t>(freedom) % dim));
  }
  places.position.resize(mesh.dim, base::index(nodes.size()));
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    places.position.col(base::index(a)) = mesh.x[nodes[a]].head(mesh.dim);
  }
  return places;
}

} // namespace spricka::analysis
