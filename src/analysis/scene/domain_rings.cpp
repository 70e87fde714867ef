// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/domain_rings.hpp"

#include "analysis/scene/tip_net_of.hpp"
#include "base/by_dimension.hpp"
#include "mesh/tube/solid_crack.hpp"
#include "model/model.hpp"

namespace spricka::analysis {

std::vector<int> domain_ring_counts(const model::Model& model, base::CrackId crack) {
  for (const model::VirtualCrackExtensionSettings& vce : model.vces) {
    if (vce.crack == crack && !vce.domains.empty()) {
      return vce.domains;
    }
  }
  const model::TipMeshSettings* tip = find_tip_mesh_settings(model, crack);
  const base::ByDimension<int> usual{model::TipMeshSettings{}.rings,
                                     mesh::TubeMeshParameters{}.rings};
  const int rings = tip != nullptr ? tip->rings : usual.at(model.mesh.dim);
  std::vector<int> domains;
  for (int ring = 2; ring <= rings; ++ring) {
    domains.push_back(ring);
  }
  return domains;
}

} // namespace spricka::analysis
