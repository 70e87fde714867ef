// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "results/results.hpp"

namespace spricka::analysis {

/// Warns where bodies have moved farther along each other than contact bears that pairs them as
/// drawn: part of its force acts where nothing stands opposite any more, they slide by more than an
/// element, or they turn until gaps change that the rows know nothing of.
void tell_slides(const Scene& scene, const StepState& state, results::StepResult& out);

} // namespace spricka::analysis
