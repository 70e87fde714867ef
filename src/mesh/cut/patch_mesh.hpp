// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cavity.hpp"
#include "mesh/cut/patch_crack.hpp"
#include "mesh/cut/patch_net.hpp"

#include <vector>

namespace spricka::mesh {

/// What fills a cavity of a plane host. The crack runs along element edges and is still closed: its
/// nodes are not doubled yet. With a transition nodes inside edges that the host keeps are tied.
struct PlanePatch : Patch {
  /// [crack] its nodes from the mouth, or the first tip, to the (last) tip, mid nodes too.
  std::vector<std::vector<int>> paths;
};

/// Meshes a cavity round its cracks: rosettes at the tips, graded triangles in the rest. `fineness`
/// divides the wanted sizes along the boundary of the host.
PlanePatch mesh_plane_cavity(const HostMesh& host, const std::vector<PatchCrack>& cracks,
                             const Cavity& cavity, double fineness);

} // namespace spricka::mesh
