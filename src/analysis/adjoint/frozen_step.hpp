// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/frozen_change.hpp"
#include "analysis/scene/front_functionals.hpp"

namespace spricka::analysis {

/// One solved step and what its answer is when something is changed.
struct FrozenContactStep {
  const StepSolver& solver;
  const StepState& state;
  const ClosedContactRows& contact;
  const FrozenContactSystem& system;
};

} // namespace spricka::analysis
