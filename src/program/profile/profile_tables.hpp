// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/profile/profile_record.hpp"

#include <string>

namespace spricka::program {

/// The profile as it is printed on a terminal: by processor, net and length, and the floor.
std::string profile_text(const ProfileRecord& record);

} // namespace spricka::program
