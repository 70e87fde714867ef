// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/run_options.hpp"

namespace spricka::program {

/// Reads, checks and (unless check_only) solves a deck and writes its run folder; messages go to
/// stderr, the table of results to stdout. Returns how it ended.
base::ProgramOutcome run_deck(const RunOptions& given);

} // namespace spricka::program
