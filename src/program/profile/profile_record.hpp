// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/profile/floor.hpp"
#include "results/run_profile.hpp"

#include <cstdint>

namespace spricka::program {

/// A profile and what stands beside it.
struct ProfileRecord {
  results::RunProfile profile;
  CostFloor floor;
  std::uintmax_t bytes_read = 0;    ///< deck, what it includes and what it imports
  std::uintmax_t bytes_written = 0; ///< files of the run folder, without those of the profile
};

/// How many plain factorisations the run took; not a number where there is no floor.
double cost_over_floor(const ProfileRecord& record);

} // namespace spricka::program
