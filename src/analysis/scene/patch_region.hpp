// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/cut_cracks.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/mesh.hpp"

namespace spricka::analysis {

/// In space what a patch will replace is only known once it is made. A plan that follows patches
/// keeps its region as long as all host elements that the patches of this cut replace are in it.
/// Else these become the region, with what lies within half a crack's size of them, where the next
/// fronts will be. Returns whether there is a new region.
bool follow_patches(const model::Mesh& host, const mesh::CrackedMesh& cracked,
                    CrackRegionPlan& plan);

} // namespace spricka::analysis
