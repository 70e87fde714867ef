// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/bodies/whole_stiffness.hpp"

#include "fe/assemble.hpp"
#include "fe/dof_map.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace spricka::analysis {

base::SymmetricCsc regularised_global_stiffness(const model::Model& model,
                                                const Discretisation& scene) {
  const model::Mesh& mesh = scene.cracked.mesh;
  std::vector<model::FreedomRole> cls = scene.cls;
  std::ranges::replace(cls, model::FreedomRole::external, model::FreedomRole::local);
  std::vector<base::NodeId> nodes;
  std::vector<base::ElementId> elements;
  // Joined, since nodes that only ties know are among the pieces then.
  for (const std::vector<fe::Body>& body :
       fe::join_tied_bodies(mesh, fe::find_bodies(mesh), *scene.ties, cls)) {
    for (const fe::Body& piece : body) {
      nodes.insert(nodes.end(), piece.nodes.begin(), piece.nodes.end());
      elements.insert(elements.end(), piece.elements.begin(), piece.elements.end());
    }
  }
  std::ranges::sort(nodes);
  fe::DofMap map = fe::number_freedoms(mesh, nodes, cls);
  if (!scene.ties->rows().empty()) {
    map.ties = scene.ties;
  }
  base::SymmetricCsc K = fe::assemble_stiffness(model, mesh, elements, {}, map);
  for (std::size_t j = 0; j + 1 < K.start.size(); ++j) {
    K.value[static_cast<std::size_t>(K.start[j])] *= 1.0 + 1e-6;
  }
  return K;
}

} // namespace spricka::analysis
