// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/load_balance.hpp"
#include "base/index.hpp"
#include "solve/nnls.hpp"

#include <algorithm>

namespace spricka::solve {

using base::at;

namespace {

constexpr double along = 1e-9; ///< share of a row across the equality rows that is round-off

/// The rows that are in the cone's face so far, orthonormal [m, r], grown one row at a time.
class SpannedSubspace {
public:
  explicit SpannedSubspace(Eigen::Index m) : Q_(m, 0) {}

  [[nodiscard]] base::Vector across(const base::Vector& v) const {
    const base::Vector once = v - Q_ * (Q_.transpose() * v);
    return once - Q_ * (Q_.transpose() * once); // twice is enough (Parlett 1980)
  }
  bool add(const base::Vector& v) {
    const base::Vector part = across(v);
    if (!(part.norm() > 1e-7 * v.norm())) {
      return false;
    }
    Q_.conservativeResize(Eigen::NoChange, Q_.cols() + 1);
    Q_.rightCols(1) = part.normalized();
    return true;
  }
  [[nodiscard]] bool full() const { return Q_.cols() == Q_.rows(); }

private:
  base::Matrix Q_;
};

} // namespace

LoadBalance balance_loads(const ControllableProblem& problem) {
  const int n = problem.rows();
  SpannedSubspace fixed(problem.mode_count());
  for (int i = 0; i < n; ++i) {
    if (problem.equality[at(i)] && !fixed.full()) {
      fixed.add(problem.B.row(i).transpose());
    }
  }
  // A x = t: what inequality rows give and what they must carry, seen across the equality rows;
  // a row that stands along them gives nothing, whatever direction its round-off has
  base::Matrix A = base::Matrix::Zero(problem.mode_count(), n);
  for (int i = 0; i < n; ++i) {
    if (!problem.equality[at(i)]) {
      const base::Vector across = fixed.across(problem.B.row(i).transpose());
      if (across.norm() > along * problem.B.row(i).norm()) {
        A.col(i) = across;
      }
    }
  }
  const base::Vector t = -fixed.across(problem.h);
  const NonNegativeSolution best = non_negative_least_squares(A, t);
  return {A * best.x - t, best.positive};
}

base::Vector unstopped_opening_motion(const ModeSplit& split, const LoadBalance& balance,
                                      double least) {
  if (balance.remainder.size() == 0) {
    return {};
  }
  // in units of h: the columns of controllable have a unit of their own
  const base::Vector per_unit = split.controllable.colwise().norm().cwiseInverse().transpose();
  if (!(balance.remainder.cwiseProduct(per_unit).norm() > least)) {
    return {};
  }
  return (split.controllable * balance.remainder).normalized();
}

std::vector<int> rows_spanning_modes(const ControllableProblem& problem,
                                     const std::vector<int>& pressed) {
  SpannedSubspace span(problem.mode_count());
  std::vector<int> rows;
  for (int i = 0; i < problem.rows(); ++i) {
    if (problem.equality[at(i)]) {
      rows.push_back(i);
      if (!span.full()) {
        span.add(problem.B.row(i).transpose());
      }
    }
  }
  for (const int i : pressed) {
    if (!span.full() && span.add(problem.B.row(i).transpose())) {
      rows.push_back(i);
    }
  }
  while (!span.full()) {
    int best = -1;
    double most = 0.0;
    for (int i = 0; i < problem.rows(); ++i) {
      const double across = span.across(problem.B.row(i).transpose()).norm();
      if (!problem.equality[at(i)] && across > most * (1.0 + 1e-9)) {
        most = across;
        best = i;
      }
    }
    if (best < 0 || !span.add(problem.B.row(best).transpose())) {
      break;
    }
    rows.push_back(best);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

} // namespace spricka::solve
