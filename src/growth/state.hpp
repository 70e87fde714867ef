// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "growth/trajectory.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace spricka::growth {

/// All that growth by a law knows between two stations: with it a run goes on as if it had never
/// stopped, to the bit.
struct GrowthState {
  std::vector<SolvedStation> stations;        ///< so far
  std::vector<std::vector<base::Vec3>> lines; ///< [crack] at the last station
  double step = 0.0;                          ///< of the next advance: logarithm of an arm's ratio
  int rejected = 0;                           ///< solutions that lay too far ahead
};

/// As named arrays for a restart file, and back; empty if they are not those of a state.
using Arrays = std::map<std::string, std::vector<double>>;
/// The stations, the lines and the step control as flat arrays of numbers, each under its name.
Arrays to_arrays(const GrowthState& state);
/// Back from there. Empty where an array is missing or its length does not fit.
std::optional<GrowthState> from_arrays(const Arrays& arrays);

/// A number among those that a crack kept in State::lines which is an index below `count`. Throws
/// std::out_of_range for any other: files may be damaged.
std::size_t checked_index(double number, std::size_t count);

} // namespace spricka::growth
