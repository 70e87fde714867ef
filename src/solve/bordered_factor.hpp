// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/held_problem.hpp"

#include <vector>

namespace spricka::solve {

/// Cholesky factor of  M = W_AA + tau B_A B_A^T  for a set A of rows, bordered by the modes. M is
/// singular exactly when rows of A are redundant (they are left out), its border exactly when A
/// does not hold all modes (Gould 1985 on when the bordered matrix is regular).
class BorderedFactor {
public:
  explicit BorderedFactor(const ControllableProblem& problem) : problem_(problem) {}

  /// Factorises for the rows of A (ascending); false when they do not hold all modes.
  bool factorise(std::vector<int> A);

  [[nodiscard]] const std::vector<int>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<int>& redundant_rows() const { return left_out_; }

  /// Solves  W_AA X + B_A Y = top,  B_A^T X = bottom  in place: top [a, k] becomes X, bottom
  /// [m, k] becomes Y.
  void solve(base::Matrix& top, base::Matrix& bottom) const;

  /// What is left of the scaled diagonal of row i when the rows of A are closed and the modes held
  /// by the weight tau: below `redundancy` when row i depends on them.
  [[nodiscard]] double row_pivot_after_closed_rows(int i) const;

private:
  void gather();
  bool cholesky();
  void leave_out_redundant();
  [[nodiscard]] base::Matrix scaled(const std::vector<int>& r, const std::vector<int>& c) const;
  bool factorise_border();

  const ControllableProblem& problem_;
  std::vector<int> rows_;
  std::vector<int> left_out_;
  base::Matrix B_; ///< [a, m] rows of A
  base::Matrix L_; ///< [n, n], its first a rows and columns in use
  base::Matrix Y_; ///< [a, m] L^-1 B_A
  base::Matrix C_; ///< [m, m] Cholesky factor of Y^T Y
};

} // namespace spricka::solve
