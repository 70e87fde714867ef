// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "contact/system.hpp"
#include "results/note.hpp"

#include <string>
#include <vector>

namespace spricka::analysis {

/// Warns of measured gaps between edges that are less round than the circles their nodes lie on,
/// where that changes pressures: solves the increment `solution` belongs to once more with the gaps
/// of those circles, without friction, and compares.
void warn_of_facet_gaps(const Discretisation& scene, const contact::ContactSystem& system,
                        const contact::ContactSystem::IncrementProblem& problem,
                        const contact::ContactSystem::IncrementSolution& solution,
                        std::vector<results::Note>& notes);

} // namespace spricka::analysis
