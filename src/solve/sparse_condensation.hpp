// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/condensed_equations.hpp"

#include <cstdint>
#include <memory>

namespace spricka::solve {

/// The equations of a net by one sparse Cholesky factorisation of K in core, the external rows
/// last; everything is read off the factor. Externals carry a shift s on their diagonal, which S
/// gives back, so that a floating body needs no support.
class SparseCondensation final : public CondensedEquations {
public:
  /// As condense_equations; the engine of the settings is not looked at.
  SparseCondensation(base::SymmetricCsc K, std::int64_t externals,
                     const CondensationSettings& settings = {});
  /// As forecast_equations.
  static FactorReport forecast(const base::SymmetricCsc& pattern, std::int64_t externals,
                               const CondensationSettings& settings = {},
                               const SparseRightHandSides* rows = nullptr);
  ~SparseCondensation() override;
  /// K, where the status is out_of_memory or engine_failed: another engine may need less.
  [[nodiscard]] base::SymmetricCsc give_back_matrix();

  [[nodiscard]] const FactorReport& report() const override;
  [[nodiscard]] base::Matrix take_schur() override;
  [[nodiscard]] base::Matrix condense_load(const base::Matrix& f) const override;
  [[nodiscard]] base::Matrix solve(const base::Matrix& f,
                                   const ExternalDisplacementSolver& displacement) const override;
  [[nodiscard]] RowCompliance compliance_with_externals_held(SparseRightHandSides F) const override;
  /// [bytes] that the compliance of these columns takes, forecast; its result included.
  [[nodiscard]] double compliance_memory(SparseRightHandSides F) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace spricka::solve
