// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

/// Dense matrices of run-time size, factorised: compiled once here, as each of these costs a
/// compiler seconds in every source that asks Eigen for it.
namespace spricka::base {

/// x with the least |A x - b|, by a rank-revealing QR; directions that A does not see stay zero.
Vector least_squares(const Matrix& A, const Vector& b);
/// The same for each column of B.
Matrix least_squares(const Matrix& A, const Matrix& B);

/// Number of columns of A that are independent: pivots below `threshold` of the largest are none.
Eigen::Index column_rank(const Matrix& A, double threshold);

/// Orthonormal directions [m, m - rank] across all columns of A [m, n].
Matrix orthogonal_complement(const Matrix& A, double threshold);

/// Singular values, descending, and left or right singular vectors.
struct SingularVectors {
  Matrix vectors;
  Vector values;
};
/// As many left ones as the smaller side of A.
SingularVectors left_singular_vectors(const Matrix& A);
/// All right singular vectors of A [m, n] as columns [n, n], with the singular values.
SingularVectors right_singular_vectors(const Matrix& A);

/// Solves A x = b with a square A by LU factors with partial pivoting; A must be regular.
Vector solve_square_system(const Matrix& A, const Vector& b);
/// The same for all columns of B at once.
Matrix solve_square_system(const Matrix& A, const Matrix& B);

/// A x = b with a symmetric A that is not indefinite.
Vector solve_semidefinite_system(const Matrix& A, const Vector& b);

} // namespace spricka::base
