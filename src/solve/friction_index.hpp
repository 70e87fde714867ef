// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/friction_problem.hpp"

#include <vector>

namespace spricka::solve {

/// Whether an answer, with its closed rows and states [n], is one that friction has turned over:
/// the determinant of its conditions has the other sign than without friction. Indices of solutions
/// add up, so that there are others (manual, solve.34). False where round-off hides the sign.
bool one_of_several(const FrictionProblem& problem, const std::vector<bool>& closed,
                    const std::vector<Touch>& touch);

} // namespace spricka::solve
