// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/modulus.hpp"

#include "fe/thermal.hpp"
#include "model/model.hpp"

#include <vector>

namespace spricka::estimate {

base::Matrix thermal_loads(const model::Model& model, const model::Mesh& mesh,
                           const base::Vector& temperature) {
  std::vector<base::Vector> own(model.materials.size(), base::Vector::Zero(temperature.size()));
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::size_t m = model.element_property(mesh, base::ElementId(e)).material.index();
    const auto first = static_cast<Eigen::Index>(mesh.first[e]);
    const auto count = static_cast<Eigen::Index>(mesh.element_nodes(base::ElementId(e)).size());
    own[m].segment(first, count) = temperature.segment(first, count);
  }
  base::Matrix out(static_cast<Eigen::Index>(mesh.node_count()) * mesh.dim,
                   static_cast<Eigen::Index>(own.size()));
  for (std::size_t m = 0; m < own.size(); ++m) {
    out.col(static_cast<Eigen::Index>(m)) = fe::thermal_load(model, mesh, own[m]);
  }
  return out;
}

} // namespace spricka::estimate
