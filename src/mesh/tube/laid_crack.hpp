// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/surface_trace.hpp"
#include "mesh/tube/crack_reach.hpp"
#include "mesh/tube/tube.hpp"

#include <vector>

namespace spricka::mesh {

/// A mouth: the line on the surface from the last end of a tube to the first end of one.
struct CrackMouth {
  std::size_t from = 0, to = 0;
  DividedTrace line;
};

/// A crack of a patch: its place and its tubes, in the frame of the patch; its mouths are not.
struct PatchSolidCrack {
  CrackDistanceField reach;
  std::vector<Tube> tubes;
  double finer = 1.0;              ///< TubeMeshParameters::finer
  std::vector<CrackMouth> mouths;  ///< of open tubes, in their order
  std::vector<DividedTrace> holes; ///< mouths all round, the first corner again at the end
};

} // namespace spricka::mesh
