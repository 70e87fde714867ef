// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/held_problem.hpp"

#include <vector>

namespace spricka::solve {

/// Rows that are likely to be closed [n], equality rows among them: those with a force after some
/// accelerated projected gradient steps on the augmented Lagrangian (solve.39). It costs about as
/// much as a factorisation; what it leaves is a good start for block pivoting.
std::vector<bool> predict_closed_rows(const ControllableProblem& problem);

} // namespace spricka::solve
