// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "results/results.hpp"

namespace spricka::analysis {

/// Tells where bodies have moved farther along each other than contact bears that pairs them as
/// drawn: part of its force acts where nothing stands opposite any more, they slide by more than an
/// element, or they turn until gaps change that the rows know nothing of. By the part of the step's
/// largest contact force that is out of place a note, less exact or no answer.
void warn_of_large_slip(const model::Model& model, const Discretisation& scene,
                        const std::vector<SubstructuredBody>& bodies, const StepState& state,
                        results::LoadStepResult& out);

} // namespace spricka::analysis
