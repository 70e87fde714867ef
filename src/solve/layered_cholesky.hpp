// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/index.hpp"
#include "base/vec.hpp"
#include "solve/dense_cholesky.hpp"

#include <memory>
#include <vector>

namespace spricka::solve {

/// Rows of a full matrix: those eliminated early, and those that stay. Others are left out.
struct EarlyLists {
  std::vector<Eigen::Index> early, late; ///< each row once
  bool operator==(const EarlyLists&) const = default;
};

/// The rows of a full matrix that no other matrix will touch, eliminated once for all systems that
/// it becomes part of: A = [A_ee, A_el; A_le, A_ll], L L^T = A_ee, X = L^-1 A_el.
class EarlyRows {
public:
  /// A [m, m] symmetric.
  EarlyRows(const base::Matrix& A, EarlyLists lists);

  [[nodiscard]] bool ok() const { return L_.ok(); }
  [[nodiscard]] const EarlyLists& lists() const { return lists_; }
  [[nodiscard]] Eigen::Index count() const { return base::index(lists_.early.size()); }
  /// Schur complement of the late rows, A_ll - X^T X [late, late], symmetric to the last bit.
  [[nodiscard]] const base::Matrix& schur() const { return schur_; }
  /// L^-1 B [early, k].
  [[nodiscard]] base::Matrix half_solve(base::Matrix B) const;
  /// X^T Y [late, k]: what elimination of early loads, Y = L^-1 B [early, k], takes off the late
  /// rows.
  [[nodiscard]] base::Matrix late_load(const base::Matrix& Y) const;
  /// The solution on the early rows, L^-T (Y - X U) [early, k], from U [late, k] on the late ones.
  [[nodiscard]] base::Matrix finish(base::Matrix Y, const base::Matrix& U) const;

private:
  EarlyLists lists_;
  DenseCholesky L_;
  base::Matrix X_, schur_;
};

/// Cholesky factor of a full matrix of which the first rows have been eliminated before.
class LayeredCholesky {
public:
  /// D [n, n]: the matrix of the rows that are not early, with early->schur() added in; `place`
  /// [late]: the row of D of each late row.
  LayeredCholesky(std::shared_ptr<const EarlyRows> early, std::vector<Eigen::Index> place,
                  base::Matrix D);

  [[nodiscard]] bool ok() const { return early_->ok() && late_.ok(); }
  [[nodiscard]] const std::shared_ptr<const EarlyRows>& early() const { return early_; }
  [[nodiscard]] Eigen::Index early_rows() const { return early_->count(); }
  /// Early and late rows.
  [[nodiscard]] Eigen::Index size() const { return early_rows() + late_.size(); }

  /// The lower part [n, k] of L^-1 B for a B that is zero below its early rows, from their
  /// late_load [late, k].
  [[nodiscard]] base::Matrix late_half(const base::Matrix& late_load) const;
  /// L^-1 B and A^-1 B [size, k], early rows first.
  [[nodiscard]] base::Matrix half_solve(const base::Matrix& B) const;
  [[nodiscard]] base::Matrix solve(const base::Matrix& B) const;

private:
  std::shared_ptr<const EarlyRows> early_;
  std::vector<Eigen::Index> place_;
  DenseCholesky late_;
};

/// A factor in the place of a condensed matrix.
struct FactoredExternals {
  LayeredCholesky L;
  std::vector<Eigen::Index> row; ///< [externals] row of L of each; its other rows bear no load
};

} // namespace spricka::solve
