// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "solve/factor_report.hpp"
#include "solve/ordering.hpp"
#include "solve/row_elimination.hpp"

#include <cstdint>
#include <functional>
#include <memory>

namespace spricka::solve {

/// One sparse Cholesky factorisation of K with the external rows last, and everything that is read
/// off it: the Schur complement S = K_ee - K_el K_ll^-1 K_le, condensed loads, recovered locals.
/// Externals carry a shift s on their diagonal, which S gives back, so that a floating body needs
/// no support.
class SparseCondensation {
public:
  /// K [n, n] lower triangle, the last `externals` rows external. Check the report: when its status
  /// is not ok, nothing else may be asked for.
  /// K is given up as soon as it is copied into the order of elimination: move it in. `besides`
  /// [bytes]: what others will need at the same time.
  SparseCondensation(base::SymmetricCsc K, std::int64_t externals,
                     OrderingMethod ordering = OrderingMethod::automatic, double besides = 0.0);
  /// The symbolic phase alone: flops, fill and memory of what the constructor would do with a
  /// matrix of this pattern (values are not looked at).
  /// With `rows` [n, k] it counts what their compliance takes as well.
  static FactorReport forecast(base::SymmetricCsc pattern, std::int64_t externals,
                               OrderingMethod ordering = OrderingMethod::automatic,
                               const SparseRightHandSides* rows = nullptr);
  ~SparseCondensation();
  SparseCondensation(SparseCondensation&&) noexcept;
  SparseCondensation& operator=(SparseCondensation&&) noexcept;

  [[nodiscard]] const FactorReport& report() const;
  /// S [externals, externals], symmetric to the last bit; once.
  [[nodiscard]] base::Matrix take_schur();
  /// Loads f [n, k] -> condensed loads f_e - K_el K_ll^-1 f_l [externals, k].
  [[nodiscard]] base::Matrix condense_load(const base::Matrix& f) const;
  /// All unknowns [n, k] from external displacements [externals, k] and the loads f [n, k].
  [[nodiscard]] base::Matrix recover(const base::Matrix& u_external, const base::Matrix& f) const;
  /// The same where the external displacements follow from the condensed loads [externals, k].
  using ExternalDisplacementSolver = std::function<base::Matrix(const base::Matrix&)>;
  /// All unknowns [n, k] of loads f [n, k] in one pass: `displacement` is called between the
  /// forward and the backward half, with the condensed loads.
  [[nodiscard]] base::Matrix solve(const base::Matrix& f,
                                   const ExternalDisplacementSolver& displacement) const;
  /// F^T K^-1 F [k, k] of columns F [n, k] with the externals held, and F condensed to these.
  [[nodiscard]] RowCompliance compliance_with_externals_held(SparseRightHandSides F) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace spricka::solve
