// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/growth.hpp"

namespace spricka::results {

/// Whether a growth ended because the program could not go on: its cycles are not the life.
inline bool growth_could_not_continue(const GrowthResult& growth) {
  return growth.ended == "MESH" || growth.ended == "STATIONS";
}

} // namespace spricka::results
