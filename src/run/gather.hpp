// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"
#include "run/scene.hpp"
#include "run/step_solver.hpp"

namespace spricka::run {

/// Processor VCE and RECOVER: turns the state at a step's end into records.
results::StepResult gather_step(const model::Model& model, const Scene& scene,
                                const std::vector<BodyNet>& bodies, const model::Step& step,
                                const StepState& state);

} // namespace spricka::run
