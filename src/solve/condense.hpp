// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "solve/condensed_equations.hpp"
#include "solve/dense_block.hpp"
#include "solve/factor_report.hpp"
#include "solve/layered_cholesky.hpp"
#include "solve/stacked.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace spricka::solve {

/// A stiffness matrix K condensed to its external rows, which stand last: the Schur complement
/// S = K_ee - K_el K_ll^-1 K_le, condensed loads, recovered locals; by one sparse factorisation, or
/// stacked where dense blocks stand on top of K. With no externals it is a plain solver.
class Condensation {
public:
  /// K [n, n] lower triangle, the last `externals` rows external. Check the report: when its status
  /// is not ok, nothing else may be asked for.
  /// K is given up as soon as it is copied into the order of elimination: move it in.
  Condensation(base::SymmetricCsc K, std::int64_t externals,
               const CondensationSettings& settings = {});
  /// The symbolic phase alone: flops, fill and memory of what the constructor would do with a
  /// matrix of this pattern (values are not looked at).
  /// With `rows` [n, k] it counts what their compliance takes as well.
  static FactorReport forecast(const base::SymmetricCsc& pattern, std::int64_t externals,
                               const CondensationSettings& settings = {},
                               const SparseRightHandSides* rows = nullptr);
  /// With dense blocks on top of K, which has a row, if an empty one, for each of theirs. With
  /// `early` S may be given as a factor: what it needs of the one block is taken from there or left
  /// there for the next matrix with the same block.
  Condensation(const base::SymmetricCsc& K, std::int64_t externals,
               std::span<const CondensedNetBlock> blocks,
               std::shared_ptr<const FirstBlockFactor>* early = nullptr,
               const CondensationSettings& settings = {});
  /// `early`: rows of the block that would be there already; those of this matrix from then on.
  static FactorReport forecast(const base::SymmetricCsc& pattern, std::int64_t externals,
                               std::span<const CondensedNetBlock> blocks,
                               EarlyLateRowPartition* early = nullptr,
                               const CondensationSettings& settings = {});

  [[nodiscard]] const FactorReport& report() const { return report_; }
  [[nodiscard]] std::int64_t size() const { return size_; } ///< unknowns, externals included
  /// S [externals, externals], symmetric to the last bit.
  [[nodiscard]] const base::Matrix& schur() const { return S_; }
  /// Hands S over to who needs it last; schur() is empty from then on.
  [[nodiscard]] base::Matrix take_schur();
  /// The factor that stands in its place, if one does.
  [[nodiscard]] std::optional<FactoredSchurComplement> take_factored_schur();
  /// Loads f [n, k] -> condensed loads f_e - K_el K_ll^-1 f_l [externals, k].
  [[nodiscard]] base::Matrix condense_load(const base::Matrix& f) const;
  /// All unknowns [n, k] from external displacements [externals, k] and the loads f [n, k].
  [[nodiscard]] base::Matrix recover(const base::Matrix& u_external, const base::Matrix& f) const;
  /// The same where the external displacements follow from the condensed loads [externals, k].
  [[nodiscard]] base::Matrix solve(const base::Matrix& f,
                                   const ExternalDisplacementSolver& displacement) const;
  /// F^T K^-1 F [k, k] of columns F [n, k] with the externals held, and F condensed to these.
  [[nodiscard]] RowCompliance compliance_with_externals_held(SparseRightHandSides F) const;

private:
  FactorReport report_;
  std::int64_t size_ = 0;
  base::Matrix S_;
  std::unique_ptr<CondensedEquations> sparse_;  ///< without dense blocks
  std::optional<TwoLevelCondensation> stacked_; ///< with dense blocks
};

} // namespace spricka::solve
