// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/bordered_factor.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spricka::solve {

using base::at;

namespace {

int count(const std::vector<int>& list) {
  return static_cast<int>(list.size());
}

/// Smallest pivot over its diagonal entry that still counts for the border [m, m].
constexpr double border_rank = 1e-12;

/// Those of the rows whose pivots in M (destroyed) are more than round-off.
std::vector<int> independent_of(base::Matrix& M, const std::vector<int>& rows) {
  if (rows.empty()) {
    return rows;
  }
  std::vector<int> order(rows.size(), 0);
  const int rank = blas::pivoted_cholesky(count(rows), blas::as_matrix_block(M), redundancy, order);
  std::vector<int> kept;
  kept.reserve(rows.size());
  for (int k = 0; k < rank; ++k) {
    kept.push_back(rows[at(order[at(k)])]);
  }
  return kept;
}

} // namespace

bool BorderedFactor::factorise(std::vector<int> A) {
  rows_ = std::move(A);
  left_out_.clear();
  gather();
  if (!cholesky()) {
    leave_out_redundant();
    gather();
    if (!cholesky()) {
      return false;
    }
  }
  return factorise_border();
}

void BorderedFactor::gather() {
  const int a = count(rows_);
  const int n = problem_.rows();
  const int m = problem_.mode_count();
  // For the largest set at once: sets change at every iteration, and memory is not asked for anew.
  if (L_.rows() != n) {
    L_.resize(n, n);
  }
  B_.resize(a, m);
  for (int c = 0; c < a; ++c) {
    const double* W = problem_.W.data() + static_cast<std::ptrdiff_t>(rows_[at(c)]) * n;
    double* L = L_.data() + static_cast<std::ptrdiff_t>(c) * n;
    for (int r = c; r < a; ++r) {
      L[r] = W[rows_[at(r)]];
    }
    B_.row(c) = problem_.B.row(rows_[at(c)]);
  }
  if (m > 0 && a > 0) {
    // panels below the diagonal only
    constexpr int panel = 64;
    for (int first = 0; first < a; first += panel) {
      const int width = std::min(panel, a - first);
      blas::gemm({.m = a - first,
                  .n = width,
                  .k = m,
                  .b = blas::Transposition::transposed,
                  .alpha = problem_.tau,
                  .beta = 1.0},
                 {B_.data() + first, a}, {B_.data() + first, a},
                 {L_.data() + first + static_cast<std::ptrdiff_t>(first) * n, n});
    }
  }
}

bool BorderedFactor::cholesky() {
  const int a = count(rows_);
  if (a == 0) {
    return true;
  }
  if (!blas::cholesky(a, blas::as_matrix_block(L_))) {
    return false;
  }
  for (int i = 0; i < a; ++i) {
    // d^2 is the diagonal entry of M, so this squared is the pivot over it.
    const double ratio = L_(i, i) / problem_.d(rows_[at(i)]);
    if (!(ratio * ratio > redundancy)) {
      return false;
    }
  }
  return true;
}

/// The scaled matrix of the rows, lower triangle of L_ over d d^T, for those at `r` and `c`.
base::Matrix BorderedFactor::scaled(const std::vector<int>& r, const std::vector<int>& c) const {
  base::Matrix M(count(r), count(c));
  for (int j = 0; j < count(c); ++j) {
    for (int i = 0; i < count(r); ++i) {
      const int a = r[at(i)];
      const int b = c[at(j)];
      const double scale = problem_.d(rows_[at(a)]) * problem_.d(rows_[at(b)]);
      M(i, j) = scale > 0.0 ? L_(std::max(a, b), std::min(a, b)) / scale : 0.0;
    }
  }
  return M;
}

/// Cholesky with diagonal pivoting: what is left at the end depends on the rows taken before.
/// Equality rows are taken first; an inequality may not stand in for one of them.
void BorderedFactor::leave_out_redundant() {
  // The factorisation that failed has overwritten L_.
  gather();
  std::vector<int> fixed;
  std::vector<int> others;
  for (int i = 0; i < count(rows_); ++i) {
    (problem_.equality[at(rows_[at(i)])] ? fixed : others).push_back(i);
  }
  base::Matrix M = scaled(fixed, fixed);
  fixed = independent_of(M, fixed);
  M = scaled(others, others);
  if (!fixed.empty()) {
    base::Matrix E = scaled(fixed, fixed);
    base::Matrix Z = scaled(fixed, others);
    // M of the others becomes what is left of it once the equality rows are eliminated, so that a
    // row that depends on these is found to be redundant.
    blas::cholesky(count(fixed), blas::as_matrix_block(E));
    blas::solve_lower(count(fixed), count(others), blas::Transposition::plain,
                      blas::as_matrix_block(E), blas::as_matrix_block(Z));
    blas::gemm({.m = count(others),
                .n = count(others),
                .k = count(fixed),
                .a = blas::Transposition::transposed,
                .alpha = -1.0,
                .beta = 1.0},
               blas::as_matrix_block(Z), blas::as_matrix_block(Z), blas::as_matrix_block(M));
  }
  others = independent_of(M, others);
  std::vector<bool> kept(rows_.size(), false);
  for (const std::vector<int>* list : {&fixed, &others}) {
    for (const int i : *list) {
      kept[at(i)] = true;
    }
  }
  std::vector<int> rows;
  for (int i = 0; i < count(rows_); ++i) {
    (kept[at(i)] ? rows : left_out_).push_back(rows_[at(i)]);
  }
  rows_ = std::move(rows);
}

bool BorderedFactor::factorise_border() {
  const int a = count(rows_);
  const int m = problem_.mode_count();
  Y_ = B_;
  C_.setZero(m, m);
  if (m == 0) {
    return true;
  }
  if (a < m) {
    return false;
  }
  blas::solve_lower(a, m, blas::Transposition::plain, blas::as_matrix_block(std::as_const(L_)),
                    blas::as_matrix_block(Y_));
  blas::gemm({.m = m, .n = m, .k = a, .a = blas::Transposition::transposed},
             blas::as_matrix_block(std::as_const(Y_)), blas::as_matrix_block(std::as_const(Y_)),
             blas::as_matrix_block(C_));
  const base::Vector diagonal = C_.diagonal();
  if (!blas::cholesky(m, blas::as_matrix_block(C_))) {
    return false;
  }
  return (C_.diagonal().array().square() > border_rank * diagonal.array()).all();
}

void BorderedFactor::solve(base::Matrix& top, base::Matrix& bottom) const {
  const int a = count(rows_);
  const int m = problem_.mode_count();
  const int k = static_cast<int>(top.cols());
  if (a == 0 || k == 0) {
    return;
  }
  const blas::MatrixBlock x = blas::as_matrix_block(top);
  if (m == 0) {
    blas::solve_lower(a, k, blas::Transposition::plain, blas::as_matrix_block(L_), x);
    blas::solve_lower(a, k, blas::Transposition::transposed, blas::as_matrix_block(L_), x);
    return;
  }
  // M X + B Y = top + tau B bottom,  B^T X = bottom
  const blas::MatrixBlock y = blas::as_matrix_block(bottom);
  blas::gemm({.m = a, .n = k, .k = m, .alpha = problem_.tau, .beta = 1.0},
             blas::as_matrix_block(B_), y, x);
  blas::solve_lower(a, k, blas::Transposition::plain, blas::as_matrix_block(L_), x);
  blas::gemm({.m = m, .n = k, .k = a, .a = blas::Transposition::transposed, .beta = -1.0},
             blas::as_matrix_block(Y_), x, y);
  // C C^T Y = B^T M^-1 top - bottom, the border eliminated.
  blas::solve_lower(m, k, blas::Transposition::plain, blas::as_matrix_block(C_), y);
  blas::solve_lower(m, k, blas::Transposition::transposed, blas::as_matrix_block(C_), y);
  blas::gemm({.m = a, .n = k, .k = m, .alpha = -1.0, .beta = 1.0}, blas::as_matrix_block(Y_), y, x);
  blas::solve_lower(a, k, blas::Transposition::transposed, blas::as_matrix_block(L_), x);
}

double BorderedFactor::row_pivot_after_closed_rows(int i) const {
  const int a = count(rows_);
  const double d = problem_.d(i);
  if (!(d > 0.0)) {
    return 0.0;
  }
  base::Matrix column(a, 1);
  for (int r = 0; r < a; ++r) {
    column(r, 0) = problem_.W(rows_[at(r)], i);
  }
  column += problem_.tau * (B_ * problem_.B.row(i).transpose());
  if (a > 0) {
    blas::solve_lower(a, 1, blas::Transposition::plain, blas::as_matrix_block(L_),
                      blas::as_matrix_block(column));
  }
  return 1.0 - column.squaredNorm() / (d * d);
}

} // namespace spricka::solve
