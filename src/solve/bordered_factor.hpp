// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <vector>

namespace spricka::solve {

/// The contact problem without the modes that no row touches; modes scaled so that the largest
/// entry of each column of B is 1.
struct HeldProblem {
  const base::Matrix& W; ///< [n, n]
  base::Matrix B;        ///< [n, m], full column rank
  base::Vector b;        ///< [n]
  base::Vector h;        ///< [m]
  std::vector<bool> equality;
  double tau = 0.0; ///< weight of B B^T that makes it as large as W
  base::Vector d;   ///< [n] sqrt(W_ii + tau |B_i|^2): g / d and lambda d have the same unit

  [[nodiscard]] int rows() const { return static_cast<int>(b.size()); }
  [[nodiscard]] int modes() const { return static_cast<int>(h.size()); }
};

/// Rows whose pivot, over the diagonal, is below this are combinations of the rows before them.
inline constexpr double redundancy = 1e-11;

/// Cholesky factor of  M = W_AA + tau B_A B_A^T  for a set A of rows, bordered by the modes. M is
/// singular exactly when rows of A are redundant (they are left out), its border exactly when A
/// does not hold all modes (Gould 1985 on when the bordered matrix is regular).
class BorderedFactor {
public:
  explicit BorderedFactor(const HeldProblem& problem) : problem_(problem) {}

  /// Factorises for the rows of A (ascending); false when they do not hold all modes.
  bool factorise(std::vector<int> A);

  [[nodiscard]] const std::vector<int>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<int>& left_out() const { return left_out_; }

  /// Solves  W_AA X + B_A Y = top,  B_A^T X = bottom  in place: top [a, k] becomes X, bottom
  /// [m, k] becomes Y.
  void solve(base::Matrix& top, base::Matrix& bottom) const;

  /// What is left of the scaled diagonal of row i when the rows of A are closed and the modes held
  /// by the weight tau: below `redundancy` when row i depends on them.
  [[nodiscard]] double independence(int i) const;

private:
  void gather();
  bool cholesky();
  void leave_out_redundant();
  [[nodiscard]] base::Matrix scaled(const std::vector<int>& r, const std::vector<int>& c) const;
  bool factorise_border();

  const HeldProblem& problem_;
  std::vector<int> rows_;
  std::vector<int> left_out_;
  base::Matrix B_; ///< [a, m] rows of A
  base::Matrix L_; ///< [n, n], its first a rows and columns in use
  base::Matrix Y_; ///< [a, m] L^-1 B_A
  base::Matrix C_; ///< [m, m] Cholesky factor of Y^T Y
};

} // namespace spricka::solve
