// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "results/results.hpp"

namespace spricka::analysis {

/// Warns where bodies in the plane run into each other at the end of a step though nothing holds
/// them apart there: no contact stands between them, or its pairs see nothing at that place. Bodies
/// that lie upon each other as drawn are meant to.
void warn_of_body_overlaps(const model::Model& model, const Discretisation& scene,
                           const std::vector<SubstructuredBody>& bodies, const StepState& state,
                           results::LoadStepResult& out);

} // namespace spricka::analysis
