// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/laid_crack.hpp"
#include "mesh/tube/solid_cavity.hpp"
#include "mesh/tube/solid_net.hpp"
#include "mesh/tube/solid_shell.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// What fills a cavity, its cracks open.
struct SolidPatch {
  struct Side {
    std::size_t element = 0;
    int side = 0;
  };
  struct Crack {
    std::vector<std::pair<int, int>> twins; ///< nodes of the upper and the lower face
    std::vector<Side> upper, lower;         ///< sides of elements that make them
    std::vector<std::vector<int>> fronts;   ///< [tube][station] node
  };
  std::vector<SolidPatchNode> nodes;
  std::vector<SolidPatchElement> elements;
  std::vector<SolidTie> ties;
  std::vector<Crack> cracks;
  std::vector<FacePieces> faces; ///< of the cavity
  std::string trouble;           ///< why there is no patch
  bool folded = false;           ///< because elements are
};

/// Meshes a cavity round its cracks: tubes along their fronts, graded tetrahedra in the rest.
SolidPatch build_solid_patch(const SolidHost& host, const SolidFrame& frame,
                             std::span<const PatchSolidCrack> cracks, const SolidCavity& cavity);

} // namespace spricka::mesh
