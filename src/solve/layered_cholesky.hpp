// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/dense_cholesky.hpp"

#include <memory>
#include <vector>

namespace spricka::solve {

/// Rows of a full matrix: what is eliminated early, and what stays. Others are left out.
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
  [[nodiscard]] Eigen::Index count() const {
    return static_cast<Eigen::Index>(lists_.early.size());
  }
  /// What is left of the late rows: A_ll - X^T X, symmetric to the last bit.
  [[nodiscard]] const base::Matrix& left() const { return left_; }
  /// L^-1 B [early, k].
  [[nodiscard]] base::Matrix half_solve(base::Matrix B) const;
  /// What that hands down to the late rows: X^T Y [late, k].
  [[nodiscard]] base::Matrix handed(const base::Matrix& Y) const;
  /// L^-T (Y - X U) [early, k], with U [late, k].
  [[nodiscard]] base::Matrix finish(base::Matrix Y, const base::Matrix& U) const;

private:
  EarlyLists lists_;
  DenseCholesky L_;
  base::Matrix X_, left_;
};

/// Cholesky factor of a full matrix of which the first rows have been eliminated before.
class LayeredCholesky {
public:
  /// D [n, n]: the matrix of the other rows with early->left() added in; `place` [late] are the
  /// rows of D that those are.
  LayeredCholesky(std::shared_ptr<const EarlyRows> early, std::vector<Eigen::Index> place,
                  base::Matrix D);

  [[nodiscard]] bool ok() const { return early_->ok() && late_.ok(); }
  [[nodiscard]] const std::shared_ptr<const EarlyRows>& early() const { return early_; }
  [[nodiscard]] Eigen::Index early_rows() const { return early_->count(); }
  /// Early and late rows.
  [[nodiscard]] Eigen::Index size() const { return early_rows() + late_.size(); }

  /// The late part of a half solve of what is on early rows only: from `handed` there.
  [[nodiscard]] base::Matrix late_half(const base::Matrix& handed) const;
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
  std::vector<Eigen::Index> row; ///< [externals] in it; of its other rows none bears a load
};

} // namespace spricka::solve
