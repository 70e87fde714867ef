// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/held_problem.hpp"
#include "solve/mode_split.hpp"

#include <vector>

namespace spricka::solve {

/// The balance of the loads on the modes by contact forces: min |h + B^T lambda| over lambda >= 0
/// on inequality rows, free on equality rows (non-negative least squares, Lawson and Hanson 1974).
/// The remainder is zero, or it is a motion that nothing stops: B remainder >= 0 and h^T remainder
/// > 0 (Farkas).
struct LoadBalance {
  base::Vector remainder;   ///< [m] h + B^T lambda
  std::vector<int> pressed; ///< inequality rows with lambda > 0, at most m
};
/// Finds contact forces that balance the loads on the modes as far as their signs allow. Equality
/// rows take up what lies in their span.
LoadBalance balance_loads(const ControllableProblem& problem);

/// The motion [m] that opens all rows it moves and that the loads drive, in units of the given
/// modes, normalised; empty if the remainder is at most `least`.
base::Vector unstopped_opening_motion(const ModeSplit& split, const LoadBalance& balance,
                                      double least);

/// Rows of B that span all modes, ascending: the equality rows, then those of `pressed` and as few
/// others as it takes, each the one farthest from the span of the rows before it.
std::vector<int> rows_spanning_modes(const ControllableProblem& problem,
                                     const std::vector<int>& pressed);

} // namespace spricka::solve
