// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "growth/trajectory.hpp"
#include "model/cracks.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace spricka::growth {

/// A crack as it has grown: what differs from the deck's.
struct GrownCrack {
  model::CrackDefinitionKind kind = model::CrackDefinitionKind::path; ///< in space: its shape
  std::vector<base::Vec3> points; ///< of its line in the plane; in space of a front that is drawn
  model::PlanarCrack plane;       ///< in space
  model::FrontHistory history;    ///< in space, of a front that turns
};

/// What a tip in space moves: a point of a front, or an end of an axis of an ellipse.
struct PartMovedByTip {
  std::size_t crack = 0;  ///< not its own where that has become a part of another
  std::size_t front = 0;  ///< of a crack with several
  std::size_t number = 0; ///< of the point, along the front
  bool on_a = false;      ///< end of the axis A, else of C
  double sign = 1.0;      ///< towards `across` or `along` of the crack's plane, or away from it
  bool paired = false;    ///< the other end of the axis is a tip as well
  bool shared = false;    ///< another tip moves this end, behind a coalescence
};

/// All that growth by a law knows between two stations: with it a run goes on as if it had never
/// stopped, to the bit.
struct GrowthState {
  std::vector<SolvedStation> stations; ///< so far
  std::vector<GrownCrack> cracks;      ///< [crack] at the last station
  std::vector<PartMovedByTip> tips;    ///< [tip] there; in the plane none
  double step = 0.0;                   ///< of the next advance: logarithm of an arm's ratio
  int rejected = 0;                    ///< solutions that lay too far ahead
};

/// Arrays of a restart file by name, one for each member of the structs above: "station.s".
using NamedValueArrays = std::map<std::string, std::vector<double>>;
/// The state as named arrays. Those without values are left out.
NamedValueArrays growth_state_to_arrays(const GrowthState& state);
/// Back from there. Throws base::CorruptStoredField for an array of another length, and for a
/// number that counts or names nothing.
GrowthState growth_state_from_arrays(const NamedValueArrays& arrays);

} // namespace spricka::growth
