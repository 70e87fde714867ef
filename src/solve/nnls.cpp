// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/nnls.hpp"
#include "base/dense_solve.hpp"
#include "base/index.hpp"

#include <algorithm>

namespace spricka::solve {

using base::index;

namespace {

/// Least squares for the chosen columns of A [m, n]: A_P x = t.
base::Vector least_squares(const base::Matrix& A, const std::vector<int>& P,
                           const base::Vector& t) {
  base::Matrix A_P(A.rows(), index(P.size()));
  for (std::size_t k = 0; k < P.size(); ++k) {
    A_P.col(index(k)) = A.col(P[k]);
  }
  return base::least_squares(A_P, t);
}

/// Lawson and Hanson's inner loop: moves x towards the least squares solution as far as it stays
/// non-negative and drops the columns that arrive at zero.
void settle(const base::Matrix& A, const base::Vector& t, std::vector<int>& P, base::Vector& x) {
  while (!P.empty()) {
    const base::Vector s = least_squares(A, P, t);
    double step = 1.0;
    for (std::size_t k = 0; k < P.size(); ++k) {
      const double s_k = s(index(k));
      if (s_k <= 0.0) {
        step = std::min(step, x(P[k]) / (x(P[k]) - s_k));
      }
    }
    for (std::size_t k = 0; k < P.size(); ++k) {
      x(P[k]) += step * (s(index(k)) - x(P[k]));
    }
    if (step >= 1.0) {
      return;
    }
    // The column that set the step arrives at zero but for round-off: without this it might stay.
    const double floor = 1e-14 * x.maxCoeff();
    std::erase_if(P, [&](int j) {
      const bool gone = x(j) <= floor;
      x(j) = gone ? 0.0 : x(j);
      return gone;
    });
  }
}

} // namespace

NonNegativeSolution non_negative_least_squares(const base::Matrix& A, const base::Vector& t) {
  const int n = static_cast<int>(A.cols());
  const base::Vector length = A.colwise().norm();
  base::Vector x = base::Vector::Zero(n);
  std::vector<int> P;
  base::Vector rest = t;
  for (int turn = 0; turn < 3 * n + 50; ++turn) {
    const double size = rest.norm();
    if (size <= 1e-14 * t.norm()) {
      break;
    }
    const base::Vector w = A.transpose() * rest;
    int best = -1;
    double steepest = 1e-11 * size; // as a sine of the angle to the face
    for (int i = 0; i < n; ++i) {
      const bool inside = std::find(P.begin(), P.end(), i) != P.end();
      if (!inside && length(i) > 0.0 && w(i) / length(i) > steepest) {
        steepest = w(i) / length(i);
        best = i;
      }
    }
    if (best < 0) {
      break;
    }
    P.push_back(best);
    settle(A, t, P, x);
    rest = t - A * x;
  }
  std::sort(P.begin(), P.end());
  return {x, P};
}

} // namespace spricka::solve
