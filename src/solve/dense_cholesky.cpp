// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/dense_cholesky.hpp"

#include <utility>

#include <cblas.h>

extern "C" void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);

namespace spricka::solve {

DenseCholesky::DenseCholesky(base::Matrix A) : L_(std::move(A)) {
  const int n = static_cast<int>(L_.rows());
  int info = 0;
  if (n > 0) {
    const char lower = 'L';
    dpotrf_(&lower, &n, L_.data(), &n, &info);
  }
  ok_ = info == 0;
}

base::Matrix DenseCholesky::half_solve(base::Matrix B) const {
  if (B.size() > 0) {
    cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit,
                static_cast<int>(B.rows()), static_cast<int>(B.cols()), 1.0, L_.data(),
                static_cast<int>(L_.rows()), B.data(), static_cast<int>(B.rows()));
  }
  return B;
}

base::Matrix DenseCholesky::solve(base::Matrix B) const {
  B = half_solve(std::move(B));
  if (B.size() > 0) {
    cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasTrans, CblasNonUnit,
                static_cast<int>(B.rows()), static_cast<int>(B.cols()), 1.0, L_.data(),
                static_cast<int>(L_.rows()), B.data(), static_cast<int>(B.rows()));
  }
  return B;
}

base::Matrix gram(const base::Matrix& Y) {
  const int k = static_cast<int>(Y.cols());
  base::Matrix C = base::Matrix::Zero(k, k);
  if (Y.size() > 0) {
    cblas_dsyrk(CblasColMajor, CblasLower, CblasTrans, k, static_cast<int>(Y.rows()), 1.0, Y.data(),
                static_cast<int>(Y.rows()), 0.0, C.data(), k);
    C.triangularView<Eigen::StrictlyUpper>() = C.transpose().triangularView<Eigen::StrictlyUpper>();
  }
  return C;
}

} // namespace spricka::solve
