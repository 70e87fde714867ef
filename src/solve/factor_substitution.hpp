// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/blas.hpp"
#include "solve/factor_panels.hpp"

#include <cstddef>
#include <vector>

namespace spricka::solve {

/// Both halves of a solution with the factor of the locals, on several threads: subtrees beside
/// each other, panels above them by runs of rows. Every sum is taken in one order, so that no bit
/// depends on the threads.
class FactorSubstitution {
public:
  /// `values`: of the factor that was cut up; both must outlive this.
  FactorSubstitution(const FactorPanels& cut, const double* values, int threads);

  /// X [n, k]: X_l <- L11^-1 X_l, then X_e <- X_e - L21 X_l (the condensed load).
  void forward(base::Matrix& X) const;
  /// X [n, k]: X_l <- L11^-T (X_l - L21^T X_e) (the recovered locals); X_e stays.
  void backward(base::Matrix& X) const;

private:
  void forward_subtrees(base::Matrix& X) const;
  void forward_subtree(const FactorPanels::Piece& piece, base::Matrix& X,
                       base::Matrix& beyond) const;
  void forward_panel(const FactorPanel& p, base::Matrix& X) const;
  void backward_panel(const FactorPanel& p, base::Matrix& X) const;
  void subtract_known(const FactorPanel& p, int begin, int end, base::Matrix& known,
                      const base::Matrix& X, blas::MatrixBlock C, double beta) const;
  void solve_transposed(const FactorPanel& p, base::Matrix& X) const;
  /// Calls use(run, begin, end) for runs of the rows below the columns of a panel, beside each
  /// other where they are worth it.
  template <class Use>
  void for_row_runs(const FactorPanel& p, Eigen::Index columns, const Use& use) const;

  const FactorPanels& cut_;
  const double* values_;
  int threads_;
  std::vector<std::size_t> subtrees_; ///< pieces, in their order
};

} // namespace spricka::solve
