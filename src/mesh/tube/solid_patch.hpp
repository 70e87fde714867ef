// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/patch_net.hpp"
#include "mesh/tube/open_surface.hpp"
#include "mesh/tube/place_crack.hpp"
#include "mesh/tube/quarter_points.hpp"
#include "mesh/tube/solid_cavity.hpp"
#include "mesh/tube/solid_shell.hpp"

#include <span>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// What fills a cavity in a solid, its cracks open.
struct SolidPatch : Patch {
  struct PatchElementSide {
    std::size_t element = 0;
    int side = 0;
  };
  struct OpenedPatchCrack {
    std::vector<std::pair<int, int>> twins;     ///< nodes of the upper and the lower face
    std::vector<PatchElementSide> upper, lower; ///< sides of elements that make them
    std::vector<std::vector<int>> fronts;       ///< [tube][station] node
  };
  std::vector<OpenedPatchCrack> cracks;
  QuarterPointCounts quarters; ///< of free fronts
  bool folded = false;         ///< there is no patch because elements are
  /// The host's nodes of such elements, ascending.
  std::vector<base::NodeId> folded_at;
  bool old_surface = false;           ///< of the body has a part in it that is not meshed anew
  bool at_border = false;             ///< borders of sets may be the trouble
  std::vector<SetBorderShift> shifts; ///< of used sets' borders, where they are not kept
};

/// How the surface of the body is treated.
struct BodySurfaceTreatment {
  SetBorderPreservation borders =
      SetBorderPreservation::all; ///< of which sets are kept; others go where triangles end
  bool renew = false; ///< the cavity's part of it is meshed anew where no tube ends, too
};

/// Meshes a cavity round its cracks: tubes along their fronts, graded tetrahedra in the rest.
SolidPatch mesh_solid_cavity(const SolidHostMesh& host, const CrackFrame& frame,
                             std::span<const PatchSolidCrack> cracks, const SolidCavity& cavity,
                             BodySurfaceTreatment request);

} // namespace spricka::mesh
