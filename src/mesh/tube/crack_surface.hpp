// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/patch_net.hpp"
#include "mesh/tube/crack_reach.hpp"

#include <string>
#include <vector>

namespace spricka::mesh {

/// A crack between its tubes (and mouths), as triangles round its normal.
struct CrackTriangulation {
  std::vector<PatchTriangle> triangles;
  std::vector<int> nodes; ///< corners, those of the loops first
  std::string trouble;    ///< what the mesher said
};

/// Fills the first of some loops, closed polygons of nodes of the patch in the plane of the crack,
/// but for the others, which are holes in it.
CrackTriangulation triangulate_crack_area(const CrackDistanceField& reach,
                                          const std::vector<std::vector<int>>& loops, double finer,
                                          PatchMeshBuilder& net);

} // namespace spricka::mesh
