// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "contact/system.hpp"
#include "results/note.hpp"

#include <string>
#include <vector>

namespace spricka::analysis {

/// What a step did.
struct StepContactsAndMotion {
  std::vector<bool> pressed; ///< [contact] somewhere at its end
  base::Vector moved;        ///< [dim * node] by the step alone
};

/// Warns of contact rows none of whose freedoms can move, where supports or prescribed
/// displacements press surfaces into each other, or pull them along each other under pressure:
/// contact and friction cannot act there. `problem` is that of the end of the step.
void warn_of_immovable_rows(const Discretisation& scene,
                            const contact::ContactSystem::IncrementProblem& problem,
                            const StepContactsAndMotion& motion, std::vector<results::Note>& notes);

} // namespace spricka::analysis
