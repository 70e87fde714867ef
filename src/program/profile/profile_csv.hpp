// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/profile/profile_record.hpp"

#include <string>

namespace spricka::program {

/// The same as one table, a row for each processor, net of a length and length, for the sum and for
/// the floor. What is not known, and what a row does not have, is an empty cell.
std::string profile_csv(const ProfileRecord& record);

} // namespace spricka::program
