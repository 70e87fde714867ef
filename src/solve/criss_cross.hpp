// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/bordered_factor.hpp"

#include <vector>

namespace spricka::solve {

enum class PivotStatus { optimal, infeasible, max_pivots, unheld };

struct PivotResult {
  PivotStatus status = PivotStatus::optimal;
  std::vector<int> closed; ///< ascending, equality rows among them
  int pivots = 0;
};

/// Criss-cross pivoting with least index (Klafszky and Terlaky 1992; den Hertog, Roos and Terlaky
/// 1993: finite for sufficient, so for positive semidefinite matrices) on the dense tableau of the
/// inequality rows, from the closed rows A; before it, for some pivots a row, of the worst row,
/// which is faster and has no proof. Modes and equality rows are pivoted in first and never leave.
/// A row that depends on closed ones has no pivot of its own: it enters by an exchange with one of
/// them or not at all. A tableau entry below `redundancy` is none.
PivotResult pivot_criss_cross(const ControllableProblem& problem, const std::vector<int>& A,
                              double tolerance, int max_pivots);

} // namespace spricka::solve
