// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/dense_cholesky.hpp"
#include "solve/blas.hpp"

#include <utility>

namespace spricka::solve {

namespace {

int count(Eigen::Index n) {
  return static_cast<int>(n);
}

} // namespace

DenseCholesky::DenseCholesky(base::Matrix A) : L_(std::move(A)) {
  blas::force_single_blas_thread();
  const int n = count(L_.rows());
  ok_ = n == 0 || blas::cholesky(n, {L_.data(), n});
}

base::Matrix DenseCholesky::forward_substitute(base::Matrix B) const {
  const int n = count(L_.rows());
  blas::solve_lower(n, count(B.cols()), blas::Transposition::plain, {L_.data(), n}, {B.data(), n});
  return B;
}

base::Matrix DenseCholesky::backward_substitute(base::Matrix B) const {
  const int n = count(L_.rows());
  blas::solve_lower(n, count(B.cols()), blas::Transposition::transposed, {L_.data(), n},
                    {B.data(), n});
  return B;
}

base::Matrix DenseCholesky::solve(base::Matrix B) const {
  return backward_substitute(forward_substitute(std::move(B)));
}

base::Matrix gram_matrix(const base::Matrix& Y) {
  const int n = count(Y.rows());
  const int k = count(Y.cols());
  base::Matrix C = base::Matrix::Zero(k, k);
  blas::gram_matrix(n, k, {Y.data(), n}, {C.data(), k});
  C.triangularView<Eigen::StrictlyUpper>() = C.transpose();
  return C;
}

base::Matrix transposed_product(const base::Matrix& X, const base::Matrix& Y) {
  const int n = count(X.rows());
  base::Matrix C(X.cols(), Y.cols());
  blas::gemm(
      {.m = count(X.cols()), .n = count(Y.cols()), .k = n, .a = blas::Transposition::transposed},
      {X.data(), n}, {Y.data(), n}, {C.data(), count(X.cols())});
  return C;
}

} // namespace spricka::solve
