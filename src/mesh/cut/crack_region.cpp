// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/crack_region.hpp"

#include "mesh/cut/cavity.hpp"
#include "mesh/cut/path.hpp"

namespace spricka::mesh {

using base::ElementId;
using base::NodeId;

std::vector<ElementId> possible_cavity_elements(const HostMesh& host,
                                                std::span<const CrackLine> lines,
                                                std::span<const TipMeshParameters> tips) {
  const model::Mesh& mesh = host.mesh();
  std::vector<bool> in(mesh.element_count(), false);
  base::Diagnostics ignored; // insert_cracks reports
  std::vector<CrackPlacement> placements;
  std::vector<ElementId> core;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (tips[i].patch) {
      if (auto placement = place_crack_in_host(host, lines[i], tips[i], {}, ignored)) {
        placements.push_back(std::move(*placement));
      }
    } else if (const auto path = find_crack_path_nodes(host, lines[i], {}, ignored)) {
      for (const NodeId n : *path) {
        core.insert(core.end(), host.elements_around(n).begin(), host.elements_around(n).end());
      }
    }
  }
  for (const Cavity& cavity : find_cavities(host, placements).each) {
    core.insert(core.end(), cavity.elements.begin(), cavity.elements.end());
  }
  // One more layer, as a margin.
  for (const ElementId e : core) {
    for (const NodeId n : mesh.element_nodes(e)) {
      for (const ElementId next : host.elements_around(n)) {
        in[next.index()] = true;
      }
    }
  }
  std::vector<ElementId> result;
  for (std::size_t e = 0; e < in.size(); ++e) {
    if (in[e]) {
      result.emplace_back(e);
    }
  }
  return result;
}

} // namespace spricka::mesh
