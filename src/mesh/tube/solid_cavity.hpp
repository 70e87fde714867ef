// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/patch_net.hpp"
#include "mesh/link/grading.hpp"
#include "mesh/tube/place_crack.hpp"
#include "mesh/tube/solid_host.hpp"

#include <span>
#include <string>
#include <vector>

/// What a patch replaces of a host of solids, and the sizes of what fills it.
namespace spricka::mesh {

/// A side of an element inside a cavity that the cavity ends at.
struct CavityFace {
  model::Face face;
  bool free = false; ///< on the host's boundary; else an element that stays lies beyond
};

/// The host elements that a patch replaces, of one part of the host.
struct SolidCavity {
  std::vector<base::ElementId> elements;       ///< ascending
  std::vector<std::vector<CavityFace>> shells; ///< closed surfaces, the outermost first
  std::string trouble;                         ///< why there is none
};

/// Elements that cracks and tubes touch or come near, and those longer than the grading of the fill
/// would have them: an edge longer than the tube's radius and the distance from it. What hangs
/// together by faces with the elements at `seeds`, and as many more that every edge and node of the
/// cavity's surface has one sheet of it.
SolidCavity find_solid_cavity(const SolidHostMesh& host, const CrackFrame& frame,
                              std::span<const CrackDistanceField> cracks,
                              std::span<const base::ElementId> seeds);

/// An element set whose border runs through a cavity.
struct SetCutByCavity {
  std::size_t index = 0; ///< of the mesh
  std::string name;
  base::Vec3 at = base::Vec3::Zero(); ///< on the border
};

/// Sets that have some of a cavity's elements and not others.
std::vector<SetCutByCavity> find_sets_cut_by_cavity(const SolidHostMesh& host,
                                                    const SolidCavity& cavity);

/// Sizes of the tetrahedra of a patch: those of the fronts, growing with the distance, and of the
/// faces of a finer host at its rim.
SolidGrading solid_patch_grading(std::span<const PatchSolidCrack> cracks,
                                 const std::vector<std::vector<PatchTriangle>>& rims,
                                 const PatchMeshBuilder& net);

} // namespace spricka::mesh
