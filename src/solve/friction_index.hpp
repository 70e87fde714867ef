// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/friction_problem.hpp"

namespace spricka::solve {

/// Whether friction has turned the index of a solution, so that there are others (the indices of
/// all solutions add up; manual, solve.34): the determinant of its conditions, with its closed rows
/// and states, has the other sign than without friction. False where round-off hides the sign.
bool has_other_solutions(const FrictionProblem& problem, const FrictionSolution& solution);

} // namespace spricka::solve
