// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"
#include "run/condense_bodies.hpp"
#include "run/scene.hpp"
#include "run/step_solver.hpp"

namespace spricka::run {

/// Warns where bodies in the plane run into each other at the end of a step though nothing holds
/// them apart there: no contact stands between them, or its pairs see nothing at that place. Bodies
/// that lie upon each other as drawn are meant to.
void tell_overlaps(const model::Model& model, const Scene& scene,
                   const std::vector<BodyNet>& bodies, const StepState& state,
                   results::StepResult& out);

} // namespace spricka::run
