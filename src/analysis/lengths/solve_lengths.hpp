// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/solve_options.hpp"
#include "base/diagnostics.hpp"
#include "base/outcome.hpp"
#include "model/forward.hpp"
#include "results/results.hpp"

#include <optional>

namespace spricka::analysis {

/// The chain of processors over all crack lengths: TOPOLOGY, STIFFNESS, CONDENSE, CONTACT, VCE,
/// GROW. Deck mistakes that only the whole model shows go to `diagnostics`; a model that cannot be
/// solved fills `trouble`. In both cases the result is empty.
std::optional<results::RunResult> solve_run(const model::Model& model, const SolveOptions& options,
                                            base::Diagnostics& diagnostics,
                                            base::OptionalFailure& trouble);

} // namespace spricka::analysis
