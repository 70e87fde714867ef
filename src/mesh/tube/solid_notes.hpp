// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/graft.hpp"
#include "mesh/tube/solid_front.hpp"
#include "mesh/tube/solid_patch.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

/// What is said of cracks that are cut into solids.
namespace spricka::mesh {

/// Cracks that share a cavity, in the frame of the first.
struct CavityCrackGroup {
  std::vector<std::size_t> members; ///< their numbers
  CrackFrame frame{};
  std::vector<PatchSolidCrack> cracks{};
  SolidCavity cavity{};
  SolidPatch patch{};
  GraftedPatch placed{};
};

/// Warns (W425) of sets whose borders a patch moves.
void warn_of_moved_set_borders(const SolidHostMesh& host,
                               std::span<const LocatedSolidCrack> requests,
                               const CavityCrackGroup& group, base::Diagnostics& diagnostics);

/// The cracks of a group by their names, with their tubes.
std::string crack_group_title(std::span<const LocatedSolidCrack> requests,
                              const CavityCrackGroup& group);

/// What was chosen for a front; `at`: its crack in the group and its tube.
std::string front_mesh_note(const LocatedSolidCrack& request, const CavityCrackGroup& group,
                            std::pair<std::size_t, std::size_t> at, const CrackFront& front);

} // namespace spricka::mesh
