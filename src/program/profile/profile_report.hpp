// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/profile/floor.hpp"
#include "results/run_profile.hpp"

#include <cstdint>
#include <string>

namespace spricka::program {

/// A profile and what stands beside it.
struct ProfileWithCostFloor {
  results::RunProfile profile;
  FactorisationCostFloor floor;
  std::uintmax_t bytes_read = 0;    ///< deck, what it includes and what it imports
  std::uintmax_t bytes_written = 0; ///< files of the run folder, without those of the profile
};

/// How many plain factorisations the run took; not a number where there is no floor.
double cost_over_floor(const ProfileWithCostFloor& record);

/// The profile as it is printed on a terminal: by processor, net and length, and the floor.
std::string profile_text(const ProfileWithCostFloor& record);

/// The same as one table, a row for each processor, net of a length and length, for the sum and for
/// the floor. What is not known, and what a row does not have, is an empty cell.
std::string profile_csv(const ProfileWithCostFloor& record);

} // namespace spricka::program
