// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "solve/condensed_equations.hpp"
#include "solve/factor_report.hpp"
#include "solve/row_elimination.hpp"

#include <cstdint>
#include <memory>

namespace spricka::solve {

/// Solves the equations of K [n, n] (lower triangle), the last `externals` rows external. K is
/// given up as soon as it is copied into the order of elimination: move it in.
std::unique_ptr<CondensedEquations> condense_equations(base::SymmetricCsc K, std::int64_t externals,
                                                       const CondensationSettings& settings);

/// The symbolic phase alone: flops, fill and memory of what condense_equations would do with a
/// matrix of this pattern (values are not looked at). With `rows` [n, k] it counts what their
/// compliance takes as well.
FactorReport forecast_equations(base::SymmetricCsc pattern, std::int64_t externals,
                                const CondensationSettings& settings = {},
                                const SparseRightHandSides* rows = nullptr);

} // namespace spricka::solve
