// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/held_rows.hpp"

#include "base/index.hpp"
#include "solve/blas.hpp"

#include <numeric>
#include <utility>

namespace spricka::solve {

using base::index;

ClosedRowsSolver::ClosedRowsSolver(ContactProblem rows, RowOpenings openings)
    : rows_(std::move(rows)), openings_(std::move(openings)),
      split_(split_controllable_modes(rows_.B, rows_.opening_scale)),
      held_(restrict_to_controllable_modes(rows_, split_)), factor_(held_) {
  blas::force_single_blas_thread();
  std::vector<int> all(static_cast<std::size_t>(held_.rows()));
  std::iota(all.begin(), all.end(), 0);
  ok_ = factor_.factorise(std::move(all));
  rows_.W.resize(0, 0); // as large as its factor
}

double ClosedRowsSolver::uncontrollable_load(const base::Matrix& h) const {
  return split_.uncontrollable.cols() > 0 && h.cols() > 0
             ? (split_.uncontrollable.transpose() * h).cwiseAbs().maxCoeff()
             : 0.0;
}

ClosedRowsSolver::ClosedRowsResponse
ClosedRowsSolver::response_to_gaps_and_loads(const base::Matrix& b, const base::Matrix& h) const {
  blas::force_single_blas_thread();
  ClosedRowsResponse out;
  out.lambda = base::Matrix::Zero(b.rows(), b.cols());
  out.left_over = uncontrollable_load(h);
  base::Matrix a = base::Matrix::Zero(held_.mode_count(), b.cols());
  const base::Matrix load = split_.controllable.transpose() * h;
  const std::vector<int>& A = factor_.rows();
  // once more with what the first solution leaves over
  for (int turn = 0; turn < 2; ++turn) {
    base::Matrix left = b + held_.B * a;
    if (turn > 0) {
      left += openings_(out.lambda);
    }
    base::Matrix top(index(A.size()), b.cols());
    for (std::size_t r = 0; r < A.size(); ++r) {
      top.row(index(r)) = -left.row(A[r]);
    }
    base::Matrix bottom = -(load + held_.B.transpose() * out.lambda);
    factor_.solve(top, bottom);
    for (std::size_t r = 0; r < A.size(); ++r) {
      out.lambda.row(A[r]) += top.row(index(r));
    }
    a += bottom;
  }
  out.alpha = split_.controllable * a;
  out.alpha -= split_.uncontrollable * (split_.uncontrollable.transpose() * out.alpha);
  return out;
}

} // namespace spricka::solve
