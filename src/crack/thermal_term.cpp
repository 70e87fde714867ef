// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/thermal_term.hpp"

#include "fe/thermal_kernel.hpp"

namespace spricka::crack {

double thermal_stress_at_tip(const TipSetting& set, const mesh::CrackFront& front) {
  if (set.loads.temperature.size() == 0) {
    return 0.0;
  }
  double sum = set.affine ? set.affine->at_tip : 0.0;
  int count = set.affine ? 1 : 0;
  for (std::size_t i = 0; i < set.mesh.nodes.size() && !set.affine; ++i) {
    if (set.mesh.nodes[i] == front.tip_point().node) { // a corner of its elements
      sum += set.loads.temperature[static_cast<Eigen::Index>(i)];
      ++count;
    }
  }
  const double strain = set.state() == model::StressState::plane_stress
                            ? set.material.alpha
                            : (1.0 + set.material.nu) * set.material.alpha;
  return fe::effective_modulus(set.material, set.state()) * strain * sum / std::max(count, 1);
}

} // namespace spricka::crack
