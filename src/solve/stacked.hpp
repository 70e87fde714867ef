// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "solve/condensed_equations.hpp"
#include "solve/dense_block.hpp"
#include "solve/factor_report.hpp"
#include "solve/layered_cholesky.hpp"
#include "solve/stacked_rows.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace spricka::solve {

/// Condensation in two floors. Below, the sparse matrix of the elements, condensed to the rows that
/// dense blocks have too and to the externals it touches; on top, these rows and the blocks in one
/// full matrix, of which those that are not external are eliminated. What a crack leaves alone, one
/// large block, passes through no sparse matrix.
///
/// With `early` the externals that only the block has are eliminated too, first of all and once for
/// all matrices that stand on the same block: S is not formed, its factor takes its place.
class TwoLevelCondensation {
public:
  /// The symbolic phase alone, as Condensation::forecast.
  static FactorReport forecast(const base::SymmetricCsc& K, std::int64_t externals,
                               std::span<const CondensedNetBlock> blocks,
                               const CondensationSettings& settings, EarlyLateRowPartition* early);
  /// What condensation leaves of the externals: S [externals, externals], or its factor.
  struct SchurMatrixOrFactor {
    base::Matrix S;
    std::optional<FactoredSchurComplement> factor;
  };
  /// K as Condensation takes it, without the blocks; the report is written. `early`: rows
  /// eliminated before, or none yet; null: S is wanted.
  TwoLevelCondensation(const base::SymmetricCsc& K, std::int64_t externals,
                       std::span<const CondensedNetBlock> blocks,
                       std::shared_ptr<const FirstBlockFactor>* early,
                       const CondensationSettings& settings, FactorReport& report);
  [[nodiscard]] SchurMatrixOrFactor& condensed_externals() { return top_; }

  /// Loads f [n, k] condensed to the externals [externals, k], the rows below eliminated first,
  /// then the inner ones on top.
  [[nodiscard]] base::Matrix condense_load(const base::Matrix& f) const;
  /// All unknowns [n, k] from external displacements [externals, k] and the loads f [n, k].
  [[nodiscard]] base::Matrix recover(const base::Matrix& u_external, const base::Matrix& f) const;
  /// The same where the external displacements follow from the condensed loads [externals, k].
  [[nodiscard]] base::Matrix solve(const base::Matrix& f,
                                   const ExternalDisplacementSolver& displacement) const;
  /// F^T K^-1 F [k, k] of columns F [n, k] with the externals held, and F condensed to these.
  [[nodiscard]] RowCompliance compliance_with_externals_held(const SparseRightHandSides& F) const;

private:
  /// The full matrix of the top in parts: rows that are eliminated, their coupling with the
  /// externals, and the externals or, where some are early, all rows that are not.
  struct UpperLevelParts {
    base::Matrix inner, coupling, rest;
    std::vector<Eigen::Index> place; ///< by place on top: among the rest, -1: not in it
  };
  /// `touched`: Schur complement of the rows below on those that they touch.
  [[nodiscard]] UpperLevelParts assemble(const base::SymmetricCsc& K,
                                         std::span<const CondensedNetBlock> blocks,
                                         const base::Matrix& touched) const;
  /// Makes the factor of the externals on the early rows of `dense`, which are eliminated unless
  /// `early` has them already; false: the block alone is not positive definite there.
  bool eliminate_early(const CondensedNetBlock& dense, EarlyLateRowPartition lists,
                       std::shared_ptr<const FirstBlockFactor>& early, UpperLevelParts& parts);
  bool eliminate(UpperLevelParts parts, FactorReport& report);
  /// The inner rows of g [top, k] <- L^-1 or L^-T times them.
  void solve_inner(base::Matrix& g, bool transposed) const;
  [[nodiscard]] base::Matrix below(const base::Matrix& f) const;
  /// What loads on top, g [top, k], come to on the externals [externals, k].
  [[nodiscard]] base::Matrix condense_top(base::Matrix g) const;
  /// All unknowns; `displacement` gives those of the externals from the loads on top [top, k].
  [[nodiscard]] base::Matrix substitute(const base::Matrix& f,
                                        const ExternalDisplacementSolver& displacement) const;
  [[nodiscard]] base::Matrix on_top(const base::Matrix& f, const base::Matrix& condensed) const;

  TwoLevelRows rows_;
  SchurMatrixOrFactor top_;
  std::unique_ptr<CondensedEquations> below_;
  base::Matrix L_;        ///< [inner, inner] Cholesky factor of the rows eliminated on top
  base::Matrix coupling_; ///< [inner, externals] of them with the externals
};

} // namespace spricka::solve
