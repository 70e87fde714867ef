// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/verify/problems.hpp"
#include "program/verify/verification.hpp"

#include <string>
#include <vector>

namespace spricka::program {

/// The chapter of the manual, manual/verification.md.
std::string verification_chapter(const Verification& verification,
                                 const std::vector<Problem>& problems);

} // namespace spricka::program
