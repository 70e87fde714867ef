// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cavity.hpp"
#include "mesh/cut/patch_crack.hpp"
#include "mesh/cut/patch_net.hpp"

#include <string>
#include <vector>

namespace spricka::mesh {

/// What fills a cavity. The crack runs along element edges and is still closed: its nodes are not
/// doubled yet.
struct Patch {
  std::vector<PatchNode> nodes;
  std::vector<PatchElement> elements;
  /// [crack] its nodes from the mouth, or the first tip, to the (last) tip, mid nodes too.
  std::vector<std::vector<int>> paths;
  std::vector<HeldEdgePieces> edges; ///< of the cavity that belonged to its elements
  /// Nodes inside edges that the host keeps, and where on them; their ties, with a transition.
  struct TiedPatchNode {
    int node = 0;
    ElementEdge edge;
    double xi = 0.0;
  };
  std::vector<TiedPatchNode> tied;
  std::string trouble; ///< why there is no patch
};

/// Meshes a cavity round its cracks: rosettes at the tips, graded triangles in the rest. `fineness`
/// divides the wanted sizes along the boundary of the host.
Patch mesh_cavity(const HostMesh& host, const std::vector<PatchCrack>& cracks, const Cavity& cavity,
                  double fineness);

} // namespace spricka::mesh
