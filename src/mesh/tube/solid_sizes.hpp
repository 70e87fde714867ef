// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/patch_net.hpp"
#include "mesh/link/grading.hpp"
#include "mesh/tube/laid_crack.hpp"

#include <span>
#include <vector>

namespace spricka::mesh {

/// Sizes of the tetrahedra of a patch: those of the fronts, growing with the distance, and of the
/// faces of a finer host at its rim.
SolidGrading solid_patch_grading(std::span<const PatchSolidCrack> cracks,
                                 const std::vector<std::vector<PatchTriangle>>& rims,
                                 const PatchMeshBuilder& net);

} // namespace spricka::mesh
