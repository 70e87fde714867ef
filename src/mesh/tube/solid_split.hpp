// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/patch_net.hpp"

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

namespace spricka::mesh {

/// A side of a tetrahedron of a fill; side s as that of TET4.
struct FillTetrahedronSide {
  std::size_t tetrahedron = 0;
  int side = 0;
};

struct OpenedFill {
  std::vector<FillTetrahedronSide> upper, lower; ///< [triangle of the crack]
  std::string trouble;
};

/// Opens a crack in a fill: tetrahedra below its triangles (which run round its normal) get the
/// second nodes, `lower`, of those on it. What is below is told round each node by following the
/// tetrahedra through sides that are not the crack.
OpenedFill open_crack_in_fill(const PatchMeshBuilder& net, const std::vector<PatchTriangle>& crack,
                              const std::unordered_map<int, int>& lower,
                              std::vector<std::array<int, 4>>& tetrahedra);

} // namespace spricka::mesh
