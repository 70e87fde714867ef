// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/adjoints.hpp"
#include "analysis/adjoint/edge_changes.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "contact/held_contact.hpp"

namespace spricka::analysis {

/// How K1 and K2 of tips change when one pair is opened or closed at the end of a step (manual,
/// estimate.13): exact, one pivot each. `ends`: the largest, of pairs beside an end of a closed
/// stretch; `sharp`: the sum over closed pairs at edges of one surface (mouths). `held`: the rows
/// closed at the end of the step, or null where there is no contact.
ContactEdgeKChange active_set_K_changes(const Discretisation& scene, const StepState& state,
                                        const StressIntensityAdjoints& adjoint,
                                        const contact::FixedActiveSet* held);

} // namespace spricka::analysis
