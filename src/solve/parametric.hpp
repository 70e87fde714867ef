// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/parametric_problem.hpp"

#include <vector>

namespace spricka::solve {

/// Follows the solution from t = from to t = to > from by principal pivots (manual, solve.28 to 31;
/// parametric linear complementarity: Cottle 1972; Cottle, Pang, Stone 1992, section 4.5), exactly:
/// a row whose force or gap reaches zero is exchanged, ties by least index (Murty 1974), where a
/// row has no pivot of its own together with the one that blocks it. `start` [n] or empty: a guess
/// of the closed rows.
SolutionPath follow_solution_path(const ParametricProblem& problem, double from, double to,
                                  const SolutionPathSettings& settings,
                                  const std::vector<bool>& start);

} // namespace spricka::solve
