// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/solve_options.hpp"
#include "base/diagnostics.hpp"
#include "base/outcome.hpp"
#include "model/forward.hpp"
#include "results/results.hpp"

#include <optional>

namespace spricka::analysis {

/// Whether $GROW has a law that gives the lengths.
bool grows_by_law(const model::Model& model);

/// Processor GROW: solves the cracks of one state, measures, advances, until the growth ends; fills
/// increments, log, warnings and `growth` of a run. False: a mistake of the deck (in the
/// diagnostics), or a first state that cannot be solved (in `trouble`). A later state that cannot
/// be meshed or solved ends the growth with the word MESH.
bool run_growth_by_law(const model::Model& model, const SolveOptions& options,
                       base::Diagnostics& diagnostics, base::OptionalFailure& trouble,
                       results::RunResult& run);

} // namespace spricka::analysis
