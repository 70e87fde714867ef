// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/held_problem.hpp"
#include "solve/mode_split.hpp"

#include <vector>

namespace spricka::solve {

/// How the gap of a row may change while motions come to rest.
enum class AllowedGapChange : char {
  none,             ///< the row presses, or holds
  not_through_zero, ///< it may open, and close as far as it is open
  any               ///< slip of a row that is open
};

/// Rows [n] that load some mode by more than `least`.
std::vector<bool> find_pressing_rows(const ControllableProblem& problem, const ModeSplit& split,
                                     const base::Vector& lambda, double least);

/// Brings motions to rest that no row stops and that change neither forces nor energy: among the
/// solutions that differ by them takes the one with the least |controllable (alpha - anchor)| whose
/// gaps are not negative (least distance programming, Lawson and Hanson 1974, chapter 23). Changes
/// alpha [m]; returns the number of free motions. change: [n]; anchor: [m], where bodies stay.
int minimise_free_motions(const ControllableProblem& problem, const ModeSplit& split,
                          const base::Vector& lambda, const std::vector<AllowedGapChange>& change,
                          const base::Vector& anchor, base::Vector& alpha);

} // namespace spricka::solve
