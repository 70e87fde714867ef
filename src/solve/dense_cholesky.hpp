// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

namespace spricka::solve {

/// Cholesky factor of a dense symmetric positive definite matrix, by LAPACK on one thread.
class DenseCholesky {
public:
  /// Takes the lower triangle of A [n, n].
  explicit DenseCholesky(base::Matrix A);

  [[nodiscard]] bool is_positive_definite() const { return ok_; }
  [[nodiscard]] Eigen::Index size() const { return L_.rows(); }
  /// L^-1 B [n, k], the first half of a solution.
  [[nodiscard]] base::Matrix forward_substitute(base::Matrix B) const;
  /// L^-T B [n, k], the second half of a solution.
  [[nodiscard]] base::Matrix backward_substitute(base::Matrix B) const;
  /// A^-1 B [n, k]; only where A is positive definite.
  [[nodiscard]] base::Matrix solve(base::Matrix B) const;

private:
  base::Matrix L_;
  bool ok_ = false;
};

/// Y^T Y [k, k], symmetric to the last bit.
base::Matrix gram_matrix(const base::Matrix& Y);
/// X^T Y [k, l] for X [n, k] and Y [n, l], by one call of gemm.
base::Matrix transposed_product(const base::Matrix& X, const base::Matrix& Y);

} // namespace spricka::solve
