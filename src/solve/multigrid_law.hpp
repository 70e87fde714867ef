// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "solve/condensed_equations.hpp"

#include <cstdint>

namespace spricka::solve {

/// As forecast_equations, of the engine multigrid: memory and flops by laws that were measured
/// on cubes, a slender lug and bodies with cracks. The flops are those of an easy body: what the
/// iterations will be, only the matrix itself tells.
FactorReport estimate_multigrid(const base::SymmetricCsc& pattern, std::int64_t externals,
                                const CondensationSettings& settings,
                                const SparseRightHandSides* rows);

/// Flops of one iteration on a matrix with so many entries in its lower triangle.
double flops_of_iteration(double entries);

} // namespace spricka::solve
