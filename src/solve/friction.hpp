// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/friction_problem.hpp"

#include <vector>

namespace spricka::solve {

/// Solves an increment from the states `start` (empty: all stick): a semi-smooth Newton method on
/// the four states, and where that does not settle Lemke's pivoting with lexicographic ties
/// (Lemke 1965; Cottle, Pang and Stone 1992, section 4.9) on the condensed problem. The answer's
/// residual is that of all conditions; without one the status says why.
FrictionSolution solve_friction(const FrictionProblem& problem, const ContactSettings& settings,
                                const std::vector<SlipState>& start);

} // namespace spricka::solve
