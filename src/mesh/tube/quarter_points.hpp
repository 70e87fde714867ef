// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/patch_net.hpp"

#include <set>
#include <utility>
#include <vector>

namespace spricka::mesh {

struct QuarterPointCounts {
  std::size_t moved = 0; ///< edges that leave a front, those of both faces of the crack as one
  std::size_t left = 0;  ///< of them, whose mid nodes would fold an element: these stay
};

/// Moves the mid nodes of the edges of tetrahedra that leave free fronts to a quarter of their way,
/// on edges that are curved along these. Nodes that lie on one another on the two faces of a crack
/// (`twins`) stay so.
QuarterPointCounts move_mid_nodes_to_quarters(PatchMeshBuilder& net, const std::set<int>& front,
                                              const std::vector<std::pair<int, int>>& twins);

} // namespace spricka::mesh
