// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "mesh/tube/solid_patch.hpp"

#include <span>
#include <vector>

namespace spricka::mesh {

/// A patch ready to be put into the host, and afterwards where its nodes and elements are.
struct SolidGraft {
  SolidPatch patch;
  SolidCavity cavity;
  std::vector<base::NodeId> node;       ///< [patch node] once grafted
  std::vector<base::ElementId> element; ///< [patch element] once grafted
};

/// The host with its cavities filled: mesh, `host`, `lost` and all sets of the result.
CrackedMesh graft_solids(const SolidHost& host, std::span<SolidGraft> grafts);

} // namespace spricka::mesh
