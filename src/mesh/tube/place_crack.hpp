// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/surface_trace.hpp"
#include "mesh/tube/solid_front.hpp"
#include "mesh/tube/tube.hpp"
#include "mesh/tube/tube_room.hpp"

#include <optional>
#include <span>
#include <vector>

/// A crack placed in the frame of its patch: tubes round its fronts, or edges along them, and its
/// mouths divided.
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
  FillSizes fill;
  std::vector<CrackMouth> mouths;  ///< of open tubes, in their order
  std::vector<DividedTrace> holes; ///< mouths all round, the first corner again at the end
};

/// Places the tubes of a crack, in a frame, and divides its mouths between their ends; empty,
/// with an error, where a tube does not fit or a mouth cannot be followed.
std::optional<PatchSolidCrack> place_tubes_and_mouths(const SolidHostMesh& host,
                                                      const CrackFrame& frame,
                                                      const LocatedSolidCrack& request,
                                                      std::span<const LocatedSolidCrack> all,
                                                      base::Diagnostics& diagnostics);

} // namespace spricka::mesh
