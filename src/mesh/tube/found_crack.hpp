// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"

#include <string>
#include <vector>

namespace spricka::mesh {

/// A crack that the deck's own mesh has already: the nodes of its faces are there twice, at the
/// same places, those of its front once.
struct ExistingCrack {
  base::CrackId crack;
  std::string name;
  std::vector<base::NodeId> front; ///< in any order; nodes between corners count for nothing
};

/// Faces and fronts of a crack that is in `cracked.mesh` (PATCH=NO): from the front's nodes over
/// sides of elements that lie on one another. The crack's normal is the one with a positive largest
/// component. Adds a front for each line of nodes and fills `faces` of the crack; what is wrong, in
/// words, or nothing.
std::string find_existing_crack(const ExistingCrack& crack, CrackedMesh& cracked);

} // namespace spricka::mesh
