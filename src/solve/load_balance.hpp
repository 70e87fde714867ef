// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/held_problem.hpp"
#include "solve/mode_split.hpp"

#include <vector>

namespace spricka::solve {

/// How rows hold the loads on the modes: min |h + B^T lambda| over lambda >= 0 on inequality rows,
/// free on equality rows (non-negative least squares, Lawson and Hanson 1974). What remains is
/// zero, or it is the motion that nothing stops: B remainder >= 0 and h^T remainder > 0 (Farkas).
struct Holding {
  base::Vector remainder;   ///< [m]
  std::vector<int> pressed; ///< inequality rows with lambda > 0, at most m
};
Holding hold_loads(const HeldProblem& problem);

/// The motion [m] that opens all rows it moves and that the loads drive, normalised; empty if the
/// rows hold the loads but for `least`.
base::Vector opening_motion(const ModeSplit& split, const Holding& holding, double least);

/// Rows that hold all modes, ascending: the equality rows, the pressed ones, and as few others as
/// it takes, those first that stand most across the others.
std::vector<int> holding_rows(const HeldProblem& problem, const std::vector<int>& pressed);

} // namespace spricka::solve
