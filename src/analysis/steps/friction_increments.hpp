// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_incrementation.hpp"
#include "results/note.hpp"

#include <optional>
#include <vector>

namespace spricka::analysis {

/// An increment that has no solution, of how many.
struct FailedIncrement {
  int number = 0, increments = 0;
};

/// A step in which contacts rub, from where `state` stands: in as many increments as the card says
/// (substeps > 0), and once more in others to tell their error, or in ever more until it is small
/// (manual, contact.25). Empty: solved, with notes on the error that is left.
std::optional<FailedIncrement> refine_friction_increments(const Discretisation& scene, int substeps,
                                                          IncrementState& state,
                                                          StepIncrementation& incrementation,
                                                          std::vector<results::Note>& notes);

} // namespace spricka::analysis
