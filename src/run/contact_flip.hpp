// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/adjoint.hpp"
#include "run/scene.hpp"
#include "run/step_solver.hpp"

#include <vector>

namespace spricka::run {

/// The largest changes of K1 and K2 [tip] when one pair beside an end of a closed stretch is opened
/// or closed at the end of the last step (manual, estimate.13): exact, one pivot each.
std::vector<base::Vec2> contact_flips(const Scene& scene, const StepSolver& solver,
                                      const StepState& state,
                                      const std::vector<estimate::Adjoint>& adjoints);

} // namespace spricka::run
