// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "results/results.hpp"

namespace spricka::analysis {

/// VCE: K, G and T of all fronts at the end of a step, into `out`.
void evaluate_fronts(const model::Model& model, const Discretisation& scene, const StepState& state,
                     results::LoadStepResult& out);

} // namespace spricka::analysis
