// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/held_problem.hpp"
#include "solve/mode_split.hpp"

namespace spricka::solve {

/// Brings motions to rest that no pressed row stops and that change neither forces nor energy:
/// among the solutions that differ by them takes the one with the least modes |controllable alpha|
/// whose gaps are not negative (least distance programming, Lawson and Hanson 1974, chapter 23). A
/// row presses if it loads some mode by more than `least`. Changes alpha [m]; returns the number of
/// free motions.
int minimise_free_motions(const ControllableProblem& problem, const ModeSplit& split,
                          const base::Vector& lambda, double least, base::Vector& alpha);

} // namespace spricka::solve
