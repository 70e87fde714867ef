// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

// The few BLAS and LAPACK routines of this room, by their Fortran names (reference BLAS, Dongarra
// et al. 1990; LAPACK 3). OpenBLAS serves them, always on one thread: two threads give other bits.

extern "C" {
// NOLINTBEGIN(readability-identifier-naming, bugprone-reserved-identifier)
/// C <- alpha op(A) op(B) + beta C.
void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const double* alpha, const double* A, const int* lda, const double* B, const int* ldb,
            const double* beta, double* C, const int* ldc);
/// B <- alpha op(A)^-1 B or alpha B op(A)^-1 with a triangle A.
void dtrsm_(const char* side, const char* uplo, const char* transa, const char* diag, const int* m,
            const int* n, const double* alpha, const double* A, const int* lda, double* B,
            const int* ldb);
/// y <- alpha op(A) x + beta y for a vector x.
void dgemv_(const char* trans, const int* m, const int* n, const double* alpha, const double* A,
            const int* lda, const double* x, const int* incx, const double* beta, double* y,
            const int* incy);
/// Solves one system: x <- op(A)^-1 x with a triangle A.
void dtrsv_(const char* uplo, const char* trans, const char* diag, const int* n, const double* A,
            const int* lda, double* x, const int* incx);
/// C <- alpha A A^T + beta C or alpha A^T A + beta C, one triangle of it.
void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k, const double* alpha,
            const double* A, const int* lda, const double* beta, double* C, const int* ldc);
/// A <- its Cholesky factor; info > 0: the first pivot that is not positive.
void dpotrf_(const char* uplo, const int* n, double* A, const int* lda, int* info);
/// A <- its Cholesky factor with pivoting along the diagonal; stops at pivots of `tol` or less.
void dpstrf_(const char* uplo, const int* n, double* A, const int* lda, int* piv, int* rank,
             const double* tol, double* work, int* info);
/// A <- its LU factors with partial pivoting; info > 0: a pivot that is exactly zero.
void dgetrf_(const int* m, const int* n, double* A, const int* lda, int* ipiv, int* info);
/// B <- op(A)^-1 B with the LU factors of dgetrf.
void dgetrs_(const char* trans, const int* n, const int* nrhs, const double* A, const int* lda,
             const int* ipiv, double* B, const int* ldb, int* info);
/// Threads of OpenBLAS from the next call on.
void openblas_set_num_threads(int threads);
/// Ends the threads of OpenBLAS that wait for work; null where the library does not have it.
int blas_thread_shutdown_() __attribute__((weak));
// NOLINTEND(readability-identifier-naming, bugprone-reserved-identifier)
}

namespace spricka::solve::blas {

/// A block of a column-major matrix: first entry and distance between columns.
struct MatrixBlock {
  double* data;
  int stride;
  MatrixBlock(double* d, int s) : data(d), stride(s > 1 ? s : 1) {}
};
struct ConstMatrixBlock {
  const double* data;
  int stride;
  ConstMatrixBlock(const double* d, int s) : data(d), stride(s > 1 ? s : 1) {}
  ConstMatrixBlock(const MatrixBlock& block)
      : data(block.data), stride(block.stride) {} // NOLINT: a view of it
};

/// A whole dense matrix as a block, column by column.
template <class Matrix> MatrixBlock as_matrix_block(Matrix& A) {
  return {A.data(), static_cast<int>(A.rows())};
}
/// The same of a matrix that is only read.
template <class Matrix> ConstMatrixBlock as_matrix_block(const Matrix& A) {
  return {A.data(), static_cast<int>(A.rows())};
}

enum class Transposition { plain, transposed };

/// So few columns are taken one by one: for more, routines that first copy the matrix in their own
/// order pay.
inline constexpr int few_columns = 2;

/// C [m, n] = alpha op(A) op(B) + beta C with inner size k.
struct MatrixProduct {
  int m, n, k;
  Transposition a = Transposition::plain, b = Transposition::plain;
  double alpha = 1.0, beta = 0.0;
};
/// The product by dgemm, or by dgemv column by column where C has few columns.
inline void gemm(const MatrixProduct& p, ConstMatrixBlock A, ConstMatrixBlock B, MatrixBlock C) {
  if (p.m == 0 || p.n == 0) {
    return;
  }
  const char ta = p.a == Transposition::plain ? 'N' : 'T';
  if (p.n <= few_columns && p.k > 0 && p.b == Transposition::plain) {
    const int rows = p.a == Transposition::plain ? p.m : p.k;
    const int columns = p.a == Transposition::plain ? p.k : p.m;
    const int one = 1;
    for (int j = 0; j < p.n; ++j) {
      dgemv_(&ta, &rows, &columns, &p.alpha, A.data, &A.stride,
             B.data + static_cast<std::ptrdiff_t>(j) * B.stride, &one, &p.beta,
             C.data + static_cast<std::ptrdiff_t>(j) * C.stride, &one);
    }
    return;
  }
  const char tb = p.b == Transposition::plain ? 'N' : 'T';
  dgemm_(&ta, &tb, &p.m, &p.n, &p.k, &p.alpha, A.data, &A.stride, B.data, &B.stride, &p.beta,
         C.data, &C.stride);
}

/// B [m, n] <- L^-1 B or L^-T B with the lower triangle L [m, m].
inline void solve_lower(int m, int n, Transposition form, ConstMatrixBlock L, MatrixBlock B) {
  if (m == 0 || n == 0) {
    return;
  }
  const char t = form == Transposition::plain ? 'N' : 'T';
  if (n <= few_columns) {
    const int next = 1;
    for (int j = 0; j < n; ++j) {
      dtrsv_("L", &t, "N", &m, L.data, &L.stride,
             B.data + static_cast<std::ptrdiff_t>(j) * B.stride, &next);
    }
    return;
  }
  const double one = 1.0;
  dtrsm_("L", "L", &t, "N", &m, &n, &one, L.data, &L.stride, B.data, &B.stride);
}

/// B [m, n] <- B L^-T with the lower triangle L [n, n].
inline void solve_lower_from_right(int m, int n, ConstMatrixBlock L, MatrixBlock B) {
  if (m == 0 || n == 0) {
    return;
  }
  const double one = 1.0;
  dtrsm_("R", "L", "T", "N", &m, &n, &one, L.data, &L.stride, B.data, &B.stride);
}

/// Lower triangle of C [n, n] <- alpha Y Y^T + beta C for Y [n, k].
inline void row_gram(int n, int k, double alpha, double beta, ConstMatrixBlock Y, MatrixBlock C) {
  if (n > 0) {
    dsyrk_("L", "N", &n, &k, &alpha, Y.data, &Y.stride, &beta, C.data, &C.stride);
  }
}

/// Lower triangle of C [k, k] <- Y^T Y for Y [n, k].
inline void gram_matrix(int n, int k, ConstMatrixBlock Y, MatrixBlock C) {
  if (n == 0 || k == 0) {
    return;
  }
  const double one = 1.0;
  const double zero = 0.0;
  dsyrk_("L", "T", &k, &n, &one, Y.data, &Y.stride, &zero, C.data, &C.stride);
}

/// A [n, n] (lower triangle) <- its Cholesky factor: the first pivot that is not positive, n where
/// there is none.
inline int cholesky_until(int n, MatrixBlock A) {
  int info = 0;
  dpotrf_("L", &n, A.data, &A.stride, &info);
  return info == 0 ? n : info - 1; // Fortran counts from 1
}
/// The same; false when a pivot is not positive.
inline bool cholesky(int n, MatrixBlock A) {
  return cholesky_until(n, A) == n;
}

/// Cholesky with diagonal pivoting of A [n, n] (lower triangle, destroyed) until no pivot exceeds
/// `tolerance`: the rank; order [n] lists the rows as they were taken.
inline int pivoted_cholesky(int n, MatrixBlock A, double tolerance, std::vector<int>& order) {
  double largest = 0.0;
  for (int i = 0; i < n; ++i) {
    largest = std::max(largest, A.data[static_cast<std::ptrdiff_t>(i) * (A.stride + 1)]);
  }
  if (!(largest > tolerance)) {
    return 0; // LAPACK takes the first pivot unseen
  }
  std::vector<double> work(2 * static_cast<std::size_t>(n));
  int rank = 0;
  int info = 0;
  dpstrf_("L", &n, A.data, &A.stride, order.data(), &rank, &tolerance, work.data(), &info);
  for (int& row : order) {
    --row; // Fortran counts from 1
  }
  return rank;
}

/// A [n, n] <- its LU factors with partial pivoting, order [n] of the rows; false when a pivot is
/// 0.
inline bool factorise_lu(int n, MatrixBlock A, std::vector<int>& order) {
  int info = 0;
  order.resize(static_cast<std::size_t>(n));
  dgetrf_(&n, &n, A.data, &A.stride, order.data(), &info);
  return info == 0;
}

/// B [n, k] <- A^-1 B with the factors of `lu`.
inline void solve_lu(int n, int k, ConstMatrixBlock A, const std::vector<int>& order,
                     MatrixBlock B) {
  if (n == 0 || k == 0) {
    return;
  }
  int info = 0;
  dgetrs_("N", &n, &k, A.data, &A.stride, order.data(), B.data, &B.stride, &info);
}

/// One thread from now on, for the whole process. Those that the library started when it was loaded
/// would spin for 0.06 s before they sleep.
inline void force_single_blas_thread() {
  static const bool done = [] {
    openblas_set_num_threads(1);
    if (blas_thread_shutdown_ != nullptr) { // a serial library has none
      blas_thread_shutdown_();
    }
    return true;
  }();
  static_cast<void>(done);
}

} // namespace spricka::solve::blas
