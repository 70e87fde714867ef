// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/job/ready_deck.hpp"
#include "results/script_constant.hpp"

#include <vector>

namespace spricka::program {

/// The constants of a deck's geometry scripts, for listing and check.
std::vector<results::ReportedScriptConstant> report_script_constants(const CheckedDeck& deck);

} // namespace spricka::program
