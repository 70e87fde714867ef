// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/condense.hpp"
#include "base/clock.hpp"
#include "solve/blas.hpp"
#include "solve/engine_choice.hpp"
#include "solve/equation_ranks.hpp"

#include <cassert>
#include <new>
#include <utility>

namespace spricka::solve {

Condensation::Condensation(base::SymmetricCsc K, std::int64_t externals,
                           const CondensationSettings& settings)
    : size_(K.n), sparse_(condense_equations(std::move(K), externals, settings)) {
  report_ = sparse_->report();
  S_ = sparse_->take_schur();
}

Condensation::Condensation(const base::SymmetricCsc& K, std::int64_t externals,
                           std::span<const CondensedNetBlock> blocks,
                           std::shared_ptr<const FirstBlockFactor>* early,
                           const CondensationSettings& settings)
    : size_(K.n) {
  blas::force_single_blas_thread();
  // The sparse factor reports a want of memory itself; the full matrices on top of it throw.
  try {
    stacked_.emplace(K, externals, blocks, early, settings, report_);
    S_ = std::move(stacked_->condensed_externals().S);
  } catch (const std::bad_alloc&) {
    report_.status = FactorStatus::out_of_memory;
  }
}

FactorReport Condensation::forecast(const base::SymmetricCsc& pattern, std::int64_t externals,
                                    const CondensationSettings& settings,
                                    const SparseRightHandSides* rows) {
  return forecast_equations(pattern, externals, settings, rows);
}

FactorReport Condensation::forecast(const base::SymmetricCsc& pattern, std::int64_t externals,
                                    std::span<const CondensedNetBlock> blocks,
                                    EarlyLateRowPartition* early,
                                    const CondensationSettings& settings) {
  return TwoLevelCondensation::forecast(pattern, externals, blocks, settings, early);
}

base::Matrix Condensation::take_schur() {
  return std::exchange(S_, base::Matrix());
}

std::optional<FactoredSchurComplement> Condensation::take_factored_schur() {
  return stacked_ ? std::exchange(stacked_->condensed_externals().factor, std::nullopt)
                  : std::nullopt;
}

base::Matrix Condensation::condense_load(const base::Matrix& f) const {
  assert(report_.status == FactorStatus::ok);
  return stacked_ ? stacked_->condense_load(f) : sparse_->condense_load(f);
}

base::Matrix Condensation::recover(const base::Matrix& u_external, const base::Matrix& f) const {
  assert(report_.status == FactorStatus::ok);
  return stacked_ ? stacked_->recover(u_external, f) : sparse_->recover(u_external, f);
}

base::Matrix Condensation::solve(const base::Matrix& f,
                                 const ExternalDisplacementSolver& displacement) const {
  assert(report_.status == FactorStatus::ok);
  return stacked_ ? stacked_->solve(f, displacement) : sparse_->solve(f, displacement);
}

RowCompliance Condensation::compliance_with_externals_held(SparseRightHandSides F) const {
  assert(report_.status == FactorStatus::ok);
  if (stacked_) {
    return stacked_->compliance_with_externals_held(F);
  }
  EquationRanks* const ranks = equation_ranks();
  const double resident = ranks == nullptr ? 0.0 : static_cast<double>(base::resident_memory());
  RowCompliance out = sparse_->compliance_with_externals_held(std::move(F));
  if (ranks != nullptr) {
    ranks->count_own_rows(resident, sparse_->report().row_memory);
  }
  return out;
}

} // namespace spricka::solve
