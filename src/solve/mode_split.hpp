// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/held_problem.hpp"

#include <vector>

namespace spricka::solve {

/// The rigid modes split into directions that some row feels and directions that none does.
struct ModeSplit {
  base::Matrix felt; ///< [m, m1] alpha = felt a, columns scaled so that B felt has largest entry 1
  base::Matrix unfelt; ///< [m, m0] orthonormal, B unfelt = 0
};

/// A unit motion that opens less than this share of `opening_scale` moves no row: the centres of
/// round surfaces are no better known than their meshes (nodes of a refined bore lie on its edges).
inline constexpr double unfelt_opening = 1e-7;

/// Motions that open no row of B [n, m] by unfelt_opening of `opening_scale` (0: the largest of B)
/// a unit are unfelt. Columns of B have comparable lengths (rigid modes of unit norm).
ModeSplit split_modes(const base::Matrix& B, double opening_scale);

/// How rows hold the loads on the modes: min |h + B^T lambda| over lambda >= 0 on inequality rows,
/// free on equality rows (non-negative least squares, Lawson and Hanson 1974). What remains is
/// zero, or it is the motion that nothing stops: B remainder >= 0 and h^T remainder > 0 (Farkas).
struct Holding {
  base::Vector remainder;   ///< [m]
  std::vector<int> pressed; ///< inequality rows with lambda > 0, at most m
};
Holding hold_loads(const HeldProblem& problem);

/// Loads on modes below this share of the load scale are round-off.
inline constexpr double rest_load = 1e-9;

/// A motion that no row feels rests under loads up to this share of the load scale: the moment of a
/// load about a round shaft's axis is that of its meshed shape.
inline constexpr double resting_load = 1e-5;

/// Of the loads h [m] on the modes, the motion that no row feels and h drives, normalised; empty if
/// there is none (loads below `least`).
base::Vector unfelt_motion(const ModeSplit& split, const base::Vector& h, double least);

/// The motion [m] that opens all rows it moves and that the loads drive, normalised; empty if the
/// rows hold the loads but for `least`.
base::Vector opening_motion(const ModeSplit& split, const Holding& holding, double least);

/// Rows that hold all modes, ascending: the equality rows, the pressed ones, and as few others as
/// it takes, those first that stand most across the others.
std::vector<int> holding_rows(const HeldProblem& problem, const std::vector<int>& pressed);

} // namespace spricka::solve
