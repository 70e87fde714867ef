// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/make_scene.hpp"
#include "fe/assemble.hpp"
#include "fe/dof_map.hpp"
#include "solve/condense.hpp"

#include <algorithm>
#include <vector>

namespace spricka::bench {

/// All bodies of a scene in one matrix, nothing external. Bodies that only contact holds get a
/// little on their diagonal: the factorisation costs the same.
inline base::SymmetricCsc whole_stiffness(const model::Model& model, const analysis::Scene& scene) {
  const model::Mesh& mesh = scene.cracked.mesh;
  std::vector<model::FreedomClass> cls = scene.cls;
  std::replace(cls.begin(), cls.end(), model::FreedomClass::external, model::FreedomClass::local);
  std::vector<base::NodeId> nodes;
  std::vector<base::ElementId> elements;
  for (const fe::Body& body : fe::find_bodies(mesh)) {
    nodes.insert(nodes.end(), body.nodes.begin(), body.nodes.end());
    elements.insert(elements.end(), body.elements.begin(), body.elements.end());
  }
  std::sort(nodes.begin(), nodes.end());
  base::SymmetricCsc K =
      fe::assemble_stiffness(model, mesh, elements, {}, fe::number_freedoms(mesh, nodes, cls));
  for (std::size_t j = 0; j + 1 < K.start.size(); ++j) {
    K.value[static_cast<std::size_t>(K.start[j])] *= 1.0 + 1e-6;
  }
  return K;
}

} // namespace spricka::bench
