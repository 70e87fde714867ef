// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/job.hpp"
#include "program/job/run_options.hpp"

namespace spricka::program {

/// Everything that can be said of a deck without solving it: mesh quality, freedoms, contact pairs,
/// rigid modes, cracks of all lengths, memory and time of the run. The table goes to stdout (JSON
/// with options.json), mistakes to stderr. Every point of a sweep is read and put together, too.
/// Returns deck_error for what a card can be blamed for, not_solvable for loads that nothing holds.
base::ProgramOutcome check_deck(const RunOptions& options, const CheckedDeck& deck, const Log& log);

/// The solids and faces of the STEP files of a deck that is refused: who names faces in it needs
/// them first. Empty without such files.
std::string list_refused_geometry(const CheckedDeck& deck);

} // namespace spricka::program
