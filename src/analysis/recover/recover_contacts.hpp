// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "results/results.hpp"

namespace spricka::analysis {

/// Pressures, arcs or areas, friction and resultants of all contacts of a solved step, with notes
/// on pressure that has no bound and on where faces of cracks part.
void recover_contacts(const Discretisation& scene, const StepState& state,
                      results::LoadStepResult& out);

} // namespace spricka::analysis
