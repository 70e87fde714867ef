// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "mesh/cut/patch_net.hpp"
#include "mesh/cut/placement.hpp"

#include <vector>

namespace spricka::mesh {

/// The ring mesh round a tip.
struct Rosette {
  int tip = 0;
  std::vector<int> rim; ///< outer corner nodes, anticlockwise; closed but for a half
  /// Corner nodes outward from the tip on the crack's own ray, and ahead on a half's line.
  std::vector<int> behind;
  std::vector<int> ahead;
};

/// Adds the rosette of one tip of a crack to a patch.
Rosette add_rosette(PatchMeshBuilder& net, const CrackPlacement& placement, const PlacedTip& at,
                    const TipMeshParameters& tip);

} // namespace spricka::mesh
