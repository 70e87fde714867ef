// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/tip_net_of.hpp"

#include "model/model.hpp"

#include <algorithm>

namespace spricka::analysis {

const model::TipMeshSettings* find_tip_mesh_settings(const model::Model& model,
                                                     base::CrackId crack) {
  const auto found = std::ranges::find(model.tip_nets, crack, &model::TipMeshSettings::crack);
  return found == model.tip_nets.end() ? nullptr : &*found;
}

} // namespace spricka::analysis
