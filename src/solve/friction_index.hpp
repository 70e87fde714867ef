// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/friction_problem.hpp"

#include <vector>

namespace spricka::solve {

/// Whether friction has turned the index of a solution, so that there are others (the indices of
/// all solutions add up; manual, solve.34): the determinant of its conditions, with its closed rows
/// and states [n], has the other sign than without friction. False where round-off hides the sign.
bool one_of_several(const FrictionProblem& problem, const std::vector<bool>& closed,
                    const std::vector<Touch>& touch);

} // namespace spricka::solve
