// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cavity.hpp"
#include "mesh/cut/rosette.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// A crack of a cavity, in the frame that all of them share, and its mesh.
struct PatchCrack {
  CrackPlacement place;
  const TipMeshParameters* tip = nullptr;
  std::vector<Rosette> rosettes = {}; ///< [tip] once they are made
  int mouth = -1;                     ///< the patch's node there, once it is made
};

/// Where on an edge of the outline (xi in [-1, 1]) mouths are, in order, with the numbers of the
/// cracks they belong to.
std::vector<std::pair<double, std::size_t>> mouths_on_edge(const CavityOutlineEdge& edge,
                                                           const std::vector<PatchCrack>& cracks);

} // namespace spricka::mesh
