// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/laid_crack.hpp"
#include "mesh/tube/solid_shell.hpp"

#include <array>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace spricka::mesh {

/// What takes the place of an edge of the host that a held set has: nodes of the patch, both of a
/// mouth that it ends at.
struct EdgePieces {
  std::array<base::NodeId, 3> host; ///< ends and middle, invalid in linear elements
  std::vector<int> ends;
  int mid = -1; ///< none: what lies there belongs to another piece
};

/// How far the border of a set was moved, because there was no room for it.
struct SetShift {
  std::string set; ///< may be empty
  double by = 0.0;
  base::Vec3 at = base::Vec3::Zero();
};

/// The surface of the body where cracks come out, meshed anew and put into a patch.
struct OpenSurface {
  std::vector<PatchTriangle> triangles; ///< part of a shell
  /// [crack][mouth] nodes between those of the tubes, which are not among them.
  std::vector<std::vector<std::vector<int>>> mouths;
  std::vector<std::vector<std::vector<int>>> holes; ///< [crack][hole] nodes all round
  std::vector<SetShift> shifts; ///< of the borders of used sets that are not kept
  std::vector<EdgePieces> edges;
  std::string trouble;
  bool at_border = false; ///< borders of sets may be the trouble
};

/// Where the tubes of a patch have gone.
struct LaidTube {
  std::vector<int> node;   ///< [node of the tube]
  std::size_t element = 0; ///< of the patch, its first
};

/// What comes out where, and what of the surface goes.
struct OpenRequest {
  const BodySurface& body;
  const SolidFrame& frame;
  std::span<const PatchSolidCrack> cracks;
  const std::vector<std::vector<LaidTube>>& tubes; ///< [crack][tube]
  std::vector<CavityFace> faces;                   ///< of the cavity, free ones
  Borders borders = Borders::all;                  ///< of sets that are kept
};

/// What takes the place of the faces is added to `pieces`. Nodes of mouths get a second node in
/// `lower`.
OpenSurface mesh_open_surface(const OpenRequest& request, SolidNet& net,
                              std::unordered_map<int, int>& lower, std::vector<FacePieces>& pieces);

} // namespace spricka::mesh
