// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/patch_net.hpp"
#include "mesh/tube/tube_room.hpp"

#include <array>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

/// The faces of a crack in its patch: triangles between its tubes and mouths, and the fill opened
/// along them.
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
                                          const std::vector<std::vector<int>>& loops,
                                          const FillSizes& fill, PatchMeshBuilder& net);

/// Divides the edges of a crack's triangles that join two nodes of free fronts across the crack:
/// with no node between them that is there twice the crack could not open there.
void divide_front_chord_edges(const PlaneBasis& plane, const std::set<int>& front,
                              PatchMeshBuilder& net, CrackTriangulation& surface);

/// A side of a tetrahedron of a fill; side s as that of TET4.
struct TetrahedronFace {
  std::size_t tetrahedron = 0;
  int side = 0;
};

struct CrackSidesInFill {
  std::vector<TetrahedronFace> upper, lower; ///< [triangle of the crack]
  std::string trouble;
};

/// Opens a crack in a fill: tetrahedra below its triangles (which run round its normal) get the
/// second nodes, `lower`, of those on it. What is below is told round each node by following the
/// tetrahedra through sides that are not the crack.
CrackSidesInFill open_crack_in_fill(const PatchMeshBuilder& net,
                                    const std::vector<PatchTriangle>& crack,
                                    const std::unordered_map<int, int>& lower,
                                    std::vector<std::array<int, 4>>& tetrahedra);

} // namespace spricka::mesh
