// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cavity.hpp"
#include "mesh/cut/patch_crack.hpp"
#include "mesh/cut/patch_net.hpp"
#include "mesh/link/grading.hpp"

#include <vector>

namespace spricka::mesh {

/// Growth of sizes in a patch with the distance from its curves: that of its finest crack.
Grading patch_grading_without_sources(const std::vector<PatchCrack>& cracks);

/// Sizes wanted along the curves of a patch before they are divided: those of the rosettes' rims,
/// of mouths, of the cavity's edges, of gaps beside cracks. `fineness` divides those along the
/// boundary of the host. The rosettes are made already.
Grading patch_curve_sizes(const HostMesh& host, const std::vector<PatchCrack>& cracks,
                          const Cavity& cavity, const PatchMeshBuilder& net, double fineness);

/// Asks for the length of the edge between two nodes of a patch, at its middle.
void add_edge_size(Grading& grading, const PatchMeshBuilder& net, int a, int b);

} // namespace spricka::mesh
