// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/dense_solve.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace spricka::base {

namespace {

Eigen::ColPivHouseholderQR<Matrix> pivoted(const Matrix& A, double threshold) {
  Eigen::ColPivHouseholderQR<Matrix> qr(A.rows(), A.cols());
  qr.setThreshold(threshold);
  qr.compute(A);
  return qr;
}

} // namespace

Vector least_squares(const Matrix& A, const Vector& b) {
  return A.colPivHouseholderQr().solve(b);
}

Matrix least_squares(const Matrix& A, const Matrix& B) {
  return A.colPivHouseholderQr().solve(B);
}

Eigen::Index column_rank(const Matrix& A, double threshold) {
  return pivoted(A, threshold).rank();
}

Matrix orthogonal_complement(const Matrix& A, double threshold) {
  const Eigen::ColPivHouseholderQR<Matrix> qr = pivoted(A, threshold);
  const Matrix Q = qr.householderQ() * Matrix::Identity(A.rows(), A.rows());
  return Q.rightCols(A.rows() - qr.rank());
}

SingularVectors left_singular_vectors(const Matrix& A) {
  const Eigen::JacobiSVD<Matrix> svd(A, Eigen::ComputeThinU);
  return {svd.matrixU(), svd.singularValues()};
}

SingularVectors right_singular_vectors(const Matrix& A) {
  const Eigen::JacobiSVD<Matrix> svd(A, Eigen::ComputeFullV);
  return {svd.matrixV(), svd.singularValues()};
}

Vector solve_square_system(const Matrix& A, const Vector& b) {
  return A.partialPivLu().solve(b);
}

Matrix solve_square_system(const Matrix& A, const Matrix& B) {
  // Eigen takes the address of the first of no columns.
  return B.size() == 0 ? Matrix::Zero(A.cols(), B.cols()) : Matrix(A.partialPivLu().solve(B));
}

Vector solve_semidefinite_system(const Matrix& A, const Vector& b) {
  return A.ldlt().solve(b);
}

} // namespace spricka::base
