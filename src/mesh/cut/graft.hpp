// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "mesh/cut/patch_mesh.hpp"

#include <span>
#include <vector>

namespace spricka::mesh {

/// A patch ready to be put into the host, and afterwards where its nodes are.
struct PatchGraft {
  Patch patch;
  Cavity cavity;
  PlanarCrackFrame frame;
  std::vector<base::NodeId> node; ///< [patch node] once grafted
};

/// The host with its cavities filled: mesh, `host` and all sets of the result, still uncracked.
CrackedMesh graft_patches(const model::Mesh& host, std::span<PatchGraft> grafts);

} // namespace spricka::mesh
