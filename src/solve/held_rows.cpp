// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/held_rows.hpp"

#include "solve/blas.hpp"
#include "solve/bordered_factor.hpp"
#include "solve/mode_split.hpp"

#include <numeric>
#include <utility>

namespace spricka::solve {

HeldRows hold_rows(const ContactProblem& rows, const base::Matrix& b, const base::Matrix& h) {
  blas::single_thread();
  HeldRows out;
  const Eigen::Index n = b.rows();
  out.lambda = base::Matrix::Zero(n, b.cols());
  const ModeSplit split = split_modes(rows.B, rows.opening_scale);
  if (split.unfelt.cols() > 0 && h.cols() > 0) {
    out.left_over = (split.unfelt.transpose() * h).cwiseAbs().maxCoeff();
  }
  const HeldProblem held = held_problem(rows, split);
  BorderedFactor factor(held);
  std::vector<int> all(static_cast<std::size_t>(n));
  std::iota(all.begin(), all.end(), 0);
  out.ok = factor.factorise(std::move(all));
  if (!out.ok) {
    return out;
  }
  base::Matrix felt = base::Matrix::Zero(held.modes(), b.cols());
  const base::Matrix load = split.felt.transpose() * h;
  const std::vector<int>& A = factor.rows();
  // once more with what the first solution leaves over
  for (int turn = 0; turn < 2; ++turn) {
    const base::Matrix left = b + rows.W * out.lambda + held.B * felt;
    base::Matrix top(static_cast<Eigen::Index>(A.size()), b.cols());
    for (std::size_t r = 0; r < A.size(); ++r) {
      top.row(static_cast<Eigen::Index>(r)) = -left.row(A[r]);
    }
    base::Matrix bottom = -(load + held.B.transpose() * out.lambda);
    factor.solve(top, bottom);
    for (std::size_t r = 0; r < A.size(); ++r) {
      out.lambda.row(A[r]) += top.row(static_cast<Eigen::Index>(r));
    }
    felt += bottom;
  }
  out.alpha = split.felt * felt;
  out.alpha -= split.unfelt * (split.unfelt.transpose() * out.alpha);
  return out;
}

} // namespace spricka::solve
