// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/held_contact.hpp"
#include "estimate/adjoint.hpp"
#include "run/scene.hpp"
#include "run/step_solver.hpp"

#include <vector>

namespace spricka::run {

/// The largest changes of K1 and K2 [tip] when one pair beside an end of a closed stretch is opened
/// or closed at the end of the last step (manual, estimate.13): exact, one pivot each.
/// `held`: the rows closed then, or null where there is no contact.
std::vector<base::Vec2> contact_flips(const Scene& scene, const StepState& state,
                                      const std::vector<estimate::Adjoint>& adjoints,
                                      const contact::HeldContact* held);

} // namespace spricka::run
