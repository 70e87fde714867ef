// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/modulus.hpp"

#include "fe/assemble.hpp"
#include "fe/thermal.hpp"

#include <vector>

namespace spricka::estimate {

base::Matrix modulus_loads(const model::Model& model, const model::Mesh& mesh,
                           const fe::StateField& state) {
  std::vector<std::vector<base::ElementId>> elements(model.materials.size());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    elements[model.property_of(mesh, base::ElementId(e)).material.index()].emplace_back(e);
  }
  base::Matrix out(state.u.size(), static_cast<Eigen::Index>(elements.size()));
  for (std::size_t m = 0; m < elements.size(); ++m) {
    base::Vector force = base::Vector::Zero(state.u.size());
    fe::add_internal_force(model, mesh, elements[m], state.u, force);
    if (state.temperature != nullptr) {
      base::Vector own = base::Vector::Zero(state.temperature->size());
      for (const base::ElementId e : elements[m]) {
        const auto first = static_cast<Eigen::Index>(mesh.first[e.index()]);
        const auto count = static_cast<Eigen::Index>(mesh.nodes_of(e).size());
        own.segment(first, count) = state.temperature->segment(first, count);
      }
      force -= fe::thermal_load(model, mesh, own);
    }
    out.col(static_cast<Eigen::Index>(m)) = -force;
  }
  return out;
}

} // namespace spricka::estimate
