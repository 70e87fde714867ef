// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "solve/condensed_equations.hpp"
#include "solve/factor_report.hpp"
#include "solve/rate.hpp"
#include "solve/row_elimination.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace spricka::solve {

/// Solves the equations of K [n, n] (lower triangle), the last `externals` rows external. K is
/// given up as soon as it is copied into the order of elimination: move it in.
/// Automatic: sparse Cholesky in core while its forecast fits into what memory can be had, then
/// MUMPS with its factor on disk, then multigrid, each if it is there and its own forecast fits;
/// the report says which, and why. If none does, the status is out_of_memory and the trouble says
/// what each would need.
std::unique_ptr<CondensedEquations> condense_equations(base::SymmetricCsc K, std::int64_t externals,
                                                       const CondensationSettings& settings);

/// The symbolic phase alone: flops, fill and memory of what condense_equations would do with a
/// matrix of this pattern (values are not looked at), and by which engine. With `rows` [n, k] it
/// counts what their compliance takes as well.
FactorReport forecast_equations(const base::SymmetricCsc& pattern, std::int64_t externals,
                                const CondensationSettings& settings = {},
                                const SparseRightHandSides* rows = nullptr);

/// The same choice where a law alone has foretold what Cholesky needs: writes into the report which
/// engine would do it, and what that takes.
void choose_engine_by_law(FactorReport& report, const CondensationSettings& settings);

/// How long the numeric phase that a report foretells will take [s of one core].
double forecast_numeric_seconds(const FactorReport& report, const FlopRate& rate);

/// What did it, or would: "Cholesky", "MUMPS out of core".
std::string engine_text(const FactorReport& report);

/// The same and why: "MUMPS out of core: in core would need 388 MB, 338 MB can be had"; empty for
/// Cholesky in core without a reason, as nearly always.
std::string explain_engine(const FactorReport& report);

} // namespace spricka::solve
