// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "results/results.hpp"

namespace spricka::analysis {

/// Processor VCE and RECOVER: turns the state at a step's end into records.
results::LoadStepResult collect_step_results(const model::Model& model, const Discretisation& scene,
                                             const std::vector<SubstructuredBody>& bodies,
                                             const model::Step& step, const StepState& state);

} // namespace spricka::analysis
