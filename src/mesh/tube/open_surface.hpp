// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/place_crack.hpp"
#include "mesh/tube/solid_shell.hpp"

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace spricka::mesh {

/// How far the border of a set was moved, because there was no room for it.
struct SetBorderShift {
  std::string set; ///< may be empty
  double by = 0.0;
  base::Vec3 at = base::Vec3::Zero();
};

/// The surface of the body where cracks come out, meshed anew and put into a patch.
struct RemeshedMouthSurface {
  std::vector<PatchTriangle> triangles; ///< part of a shell
  /// [crack][mouth] nodes between those of the tubes, which are not among them.
  std::vector<std::vector<std::vector<int>>> mouths;
  std::vector<std::vector<std::vector<int>>> holes; ///< [crack][hole] nodes all round
  std::vector<SetBorderShift> shifts; ///< of the borders of used sets that are not kept
  std::vector<HeldSetEdgeReplacement> edges;
  std::string trouble;
  bool at_border = false; ///< borders of sets may be the trouble
};

/// Where the tubes of a patch have gone.
struct TubeNodesInPatch {
  std::vector<int> node;   ///< [node of the tube]
  std::size_t element = 0; ///< of the patch, its first
};

/// What comes out where, and what of the surface goes.
struct MouthSurfaceRequest {
  const BodySurface& body;
  const CrackFrame& frame;
  std::span<const PatchSolidCrack> cracks;
  const std::vector<std::vector<TubeNodesInPatch>>& tubes;    ///< [crack][tube]
  std::vector<CavityFace> faces;                              ///< of the cavity, free ones
  SetBorderPreservation borders = SetBorderPreservation::all; ///< of sets that are kept
};

/// What takes the place of the faces is added to `pieces`. Nodes of mouths get a second node in
/// `lower`.
RemeshedMouthSurface mesh_mouth_surface(const MouthSurfaceRequest& request, PatchMeshBuilder& net,
                                        std::unordered_map<int, int>& lower,
                                        std::vector<HostFaceReplacement>& pieces);

/// Of two nodes at a mouth an edge keeps that of its side: the one that an element at the edge's
/// middle has.
void choose_edge_ends_by_crack_side(std::span<const PatchElement> elements,
                                    std::vector<HeldSetEdgeReplacement>& edges);

} // namespace spricka::mesh
