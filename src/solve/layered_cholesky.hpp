// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/index.hpp"
#include "base/vec.hpp"
#include "solve/dense_cholesky.hpp"

#include <memory>
#include <vector>

namespace spricka::solve {

/// Rows of a full matrix: those eliminated early, and those that stay. Others are left out.
struct EarlyLateRowPartition {
  std::vector<Eigen::Index> early, late; ///< each row once
  bool operator==(const EarlyLateRowPartition&) const = default;
};

/// The rows of a full matrix that no other matrix will touch, eliminated once for all systems that
/// it becomes part of: A = [A_ee, A_el; A_le, A_ll], L L^T = A_ee, X = L^-1 A_el.
class FirstBlockFactor {
public:
  /// A [m, m] symmetric.
  FirstBlockFactor(const base::Matrix& A, EarlyLateRowPartition lists);

  [[nodiscard]] bool is_positive_definite() const { return L_.is_positive_definite(); }
  [[nodiscard]] const EarlyLateRowPartition& partition() const { return lists_; }
  [[nodiscard]] Eigen::Index early_row_count() const { return base::index(lists_.early.size()); }
  /// Schur complement of the late rows, A_ll - X^T X [late, late], symmetric to the last bit.
  [[nodiscard]] const base::Matrix& schur() const { return schur_; }
  /// First half of a solution: L^-1 B [early, k].
  [[nodiscard]] base::Matrix forward_substitute(base::Matrix B) const;
  /// X^T Y [late, k]: what elimination of early loads, Y = L^-1 B [early, k], takes off the late
  /// rows.
  [[nodiscard]] base::Matrix second_block_load_reduction(const base::Matrix& Y) const;
  /// The solution on the early rows, L^-T (Y - X U) [early, k], from U [late, k] on the late ones.
  [[nodiscard]] base::Matrix solve_first_block(base::Matrix Y, const base::Matrix& U) const;

private:
  EarlyLateRowPartition lists_;
  DenseCholesky L_;
  base::Matrix X_, schur_;
};

/// Cholesky factor of a full matrix of which the first rows have been eliminated before.
class TwoBlockCholesky {
public:
  /// D [n, n]: the matrix of the rows that are not early, with early->schur() added in; `place`
  /// [late]: the row of D of each late row.
  TwoBlockCholesky(std::shared_ptr<const FirstBlockFactor> early, std::vector<Eigen::Index> place,
                   base::Matrix D);

  [[nodiscard]] bool is_positive_definite() const {
    return early_->is_positive_definite() && late_.is_positive_definite();
  }
  [[nodiscard]] const std::shared_ptr<const FirstBlockFactor>& first_block() const {
    return early_;
  }
  [[nodiscard]] Eigen::Index first_block_size() const { return early_->early_row_count(); }
  /// Early and late rows.
  [[nodiscard]] Eigen::Index size() const { return first_block_size() + late_.size(); }

  /// The lower part [n, k] of L^-1 B for a B that is zero below its early rows, from their
  /// late_load [late, k].
  [[nodiscard]] base::Matrix forward_second_block(const base::Matrix& late_load) const;
  /// L^-1 B and A^-1 B [size, k], early rows first.
  [[nodiscard]] base::Matrix forward_substitute(const base::Matrix& B) const;
  /// A^-1 B [size, k] by both substitutions, early rows first.
  [[nodiscard]] base::Matrix solve(const base::Matrix& B) const;

private:
  std::shared_ptr<const FirstBlockFactor> early_;
  std::vector<Eigen::Index> place_;
  DenseCholesky late_;
};

/// A factor in the place of a condensed matrix.
struct FactoredSchurComplement {
  TwoBlockCholesky L;
  std::vector<Eigen::Index> row; ///< [externals] row of L of each; its other rows bear no load
};

} // namespace spricka::solve
