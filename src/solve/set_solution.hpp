// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/bordered_factor.hpp"

#include <vector>

namespace spricka::solve {

/// Forces, modes and gaps with the rows of a factor closed and all others without force.
struct SolutionWithRowsClosed {
  base::Vector lambda; ///< [n]
  base::Vector alpha;  ///< [m]
  base::Vector gap;    ///< [n] b + W lambda + B alpha, on closed rows the error of the solve
  double force_scale = 0.0;
  base::Vector gap_scale; ///< [n] size of the terms that a gap is made of
};

/// `refine`: one step of iterative refinement.
SolutionWithRowsClosed solve_active_set(const ControllableProblem& problem,
                                        const BorderedFactor& factor, bool refine);

/// Rows whose sign is wrong: inequality rows of the factor with lambda below -tolerance
/// force_scale, rows outside it with a gap below -tolerance gap_scale (equality rows: either sign).
std::vector<int> violated_rows(const ControllableProblem& problem, const BorderedFactor& factor,
                               const SolutionWithRowsClosed& solution, double tolerance);

} // namespace spricka::solve
