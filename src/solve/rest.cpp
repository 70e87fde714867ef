// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/rest.hpp"
#include "base/dense_solve.hpp"
#include "base/index.hpp"
#include "solve/nnls.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

/// Orthonormal directions [m, z] of the modes that leave the gaps of these rows unchanged.
base::Matrix free_directions(const ControllableProblem& problem, const std::vector<int>& rows) {
  const int m = problem.mode_count();
  if (rows.empty()) {
    return base::Matrix::Identity(m, m);
  }
  base::Matrix B_T(m, index(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    B_T.col(index(k)) = problem.B.row(rows[k]).transpose();
  }
  return base::orthogonal_complement(B_T, 1e-9);
}

} // namespace

std::vector<bool> find_pressing_rows(const ControllableProblem& problem, const ModeSplit& split,
                                     const base::Vector& lambda, double least) {
  const Eigen::RowVectorXd per_unit = split.controllable.colwise().norm().cwiseInverse();
  std::vector<bool> pressing(std::size_t(problem.rows()), false);
  for (int i = 0; i < problem.rows() && problem.mode_count() > 0; ++i) {
    // in units of h: the columns of B are those of `controllable`, whose size carries a unit of
    // its own
    const Eigen::RowVectorXd unit = problem.B.row(i).cwiseAbs().cwiseProduct(per_unit);
    pressing[at(i)] = lambda(i) * unit.maxCoeff() > least;
  }
  return pressing;
}

int minimise_free_motions(const ControllableProblem& problem, const ModeSplit& split,
                          const base::Vector& lambda, const std::vector<AllowedGapChange>& change,
                          const base::Vector& anchor, base::Vector& alpha) {
  if (problem.mode_count() == 0) {
    return 0;
  }
  std::vector<int> fixed;
  std::vector<int> others;
  for (int i = 0; i < problem.rows(); ++i) {
    if (change[at(i)] != AllowedGapChange::any) {
      (change[at(i)] == AllowedGapChange::none ? fixed : others).push_back(i);
    }
  }
  const base::Matrix Z = free_directions(problem, fixed);
  if (Z.cols() == 0) {
    return 0;
  }
  // alpha + Z y with F = C Z = Q R, C = split.controllable, v = R y + Q^T C (alpha - anchor):
  // min |v| subject to E v >= f
  const Eigen::Index z = Z.cols();
  const base::Matrix F = split.controllable * Z;
  const Eigen::HouseholderQR<base::Matrix> qr(F);
  const base::Matrix R = base::Matrix(qr.matrixQR().topRows(z)).triangularView<Eigen::Upper>();
  const base::Matrix Q = qr.householderQ() * base::Matrix::Identity(F.rows(), z);
  const base::Vector shift = Q.transpose() * (split.controllable * (alpha - anchor));
  const base::Matrix ZR =
      R.transpose().triangularView<Eigen::Lower>().solve(Z.transpose()).transpose();
  const base::Vector gap = problem.b + problem.W * lambda + problem.B * alpha;
  const Eigen::Index k = index(others.size());
  base::Matrix E(k, z);
  base::Vector f(k);
  for (Eigen::Index r = 0; r < k; ++r) {
    const int i = others[at(r)];
    E.row(r) = problem.B.row(i) * ZR;
    f(r) = E.row(r).dot(shift) - std::max(gap(i), 0.0);
  }
  base::Vector v = base::Vector::Zero(z);
  const double size = k > 0 ? f.maxCoeff() : 0.0;
  const double reach = k > 0 ? E.cwiseAbs().maxCoeff() : 0.0; // openings by a unit of v
  if (size > 0.0) { // else nothing stops the modes from resting at zero
    base::Matrix A(z + 1, k);
    A.topRows(z) = E.transpose() / reach;
    A.bottomRows(1) = f.transpose() / size;
    const base::Vector t = base::Vector::Unit(z + 1, z);
    const base::Vector r = A * non_negative_least_squares(A, t).x - t;
    if (!(r(z) < 0.0)) {
      return static_cast<int>(z);
    }
    v = -(size / (reach * r(z))) * r.head(z);
  }
  alpha += ZR * (v - shift);
  return static_cast<int>(z);
}

} // namespace spricka::solve
