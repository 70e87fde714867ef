// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/lemke.hpp"
#include "base/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spricka::solve {

using base::at;

namespace {

/// basic = q + D nonbasic. Variables: w_i is i, z_i is n + i, the artificial one 2 n.
struct Dictionary {
  base::Matrix D;            ///< [n, n + 1]
  base::Vector q;            ///< [n]
  std::vector<int> basic;    ///< [n] variable of each row
  std::vector<int> nonbasic; ///< [n + 1] variable of each column
  std::vector<int> column;   ///< [2 n + 1] of a variable, or -1

  [[nodiscard]] int size() const { return static_cast<int>(q.size()); }
};

constexpr double least_pivot = 1e-11;

/// Entry k of the lexicographic order of a row: what a disturbance of q_k does to it.
double disturbed(const Dictionary& t, int row, int k) {
  const int c = t.column[at(k)];
  return c >= 0 ? -t.D(row, c) : (t.basic[at(row)] == k ? 1.0 : 0.0);
}

/// Whether row a leaves before row b, their ratios being alike; c is the entering column.
bool before(const Dictionary& t, int a, int b, int c) {
  for (int k = 0; k < t.size(); ++k) {
    const double x = disturbed(t, a, k) / std::abs(t.D(a, c));
    const double y = disturbed(t, b, k) / std::abs(t.D(b, c));
    if (std::abs(x - y) > 1e-12 * (std::abs(x) + std::abs(y))) {
      return x < y;
    }
  }
  return false;
}

/// The row that reaches zero first when column c grows, or -1 for a ray.
int leaving_row(const Dictionary& t, int c) {
  const double floor = least_pivot * std::max(1.0, t.D.col(c).cwiseAbs().maxCoeff());
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < t.size(); ++i) {
    if (t.D(i, c) < -floor) {
      least = std::min(least, std::max(t.q(i), 0.0) / -t.D(i, c));
    }
  }
  // Ratios that differ by round-off tie; q has been scaled to 1 by the caller. Among ties the
  // lexicographic order decides, or the method could go round in a circle.
  const double alike = least + 1e-13 * (1.0 + least);
  int best = -1;
  for (int i = 0; i < t.size(); ++i) {
    if (!(t.D(i, c) < -floor) || std::max(t.q(i), 0.0) / -t.D(i, c) > alike) {
      continue;
    }
    if (t.basic[at(i)] == 2 * t.size()) {
      return i; // the artificial variable leaves: done
    }
    if (best < 0 || before(t, i, best, c)) {
      best = i;
    }
  }
  return best;
}

void pivot(Dictionary& t, int r, int c) {
  const double p = t.D(r, c);
  const base::Vector column = t.D.col(c);
  Eigen::RowVectorXd row = t.D.row(r) / -p;
  row(c) = 1.0 / p;
  const double q = -t.q(r) / p;
  t.D.col(c).setZero();
  t.D.noalias() += column * row;
  t.q += column * q;
  t.D.row(r) = row;
  t.q(r) = q;
  std::swap(t.basic[at(r)], t.nonbasic[at(c)]);
  t.column[at(t.nonbasic[at(c)])] = c;
  t.column[at(t.basic[at(r)])] = -1;
}

Dictionary first_dictionary(const base::Matrix& M, const base::Vector& q,
                            const base::Vector& cover) {
  const int n = static_cast<int>(q.size());
  Dictionary t;
  t.D.resize(n, n + 1);
  t.D.leftCols(n) = M;
  t.D.col(n) = cover;
  t.q = q;
  t.column.assign(2 * std::size_t(n) + 1, -1);
  for (int i = 0; i < n; ++i) {
    t.basic.push_back(i);
    t.nonbasic.push_back(n + i);
    t.column[std::size_t(n) + std::size_t(i)] = i;
  }
  t.nonbasic.push_back(2 * n);
  t.column[2 * std::size_t(n)] = n;
  return t;
}

} // namespace

LemkeResult solve_by_lemke_pivoting(const base::Matrix& M, const base::Vector& q,
                                    const base::Vector& cover, int max_pivots) {
  const int n = static_cast<int>(q.size());
  LemkeResult result;
  result.basic.assign(std::size_t(n), false);
  result.solved = n == 0 || q.minCoeff() >= 0.0;
  if (result.solved) {
    return result;
  }
  Dictionary t = first_dictionary(M, q, cover);
  int entering = n;
  // The artificial variable first takes the least value by which all w are non-negative.
  int leaving = 0;
  for (int i = 1; i < n; ++i) { // of equal ones the last is disturbed least
    leaving = q(i) / cover(i) <= q(leaving) / cover(leaving) ? i : leaving;
  }
  while (result.pivots < max_pivots) {
    pivot(t, leaving, entering);
    ++result.pivots;
    const int left = t.nonbasic[at(entering)];
    if (left == 2 * n) {
      result.solved = true;
      break;
    }
    entering = t.column[at(left < n ? left + n : left - n)]; // the complement comes in
    leaving = leaving_row(t, entering);
    if (leaving < 0) {
      break;
    }
  }
  for (int i = 0; i < n; ++i) {
    result.basic[at(i)] = t.column[std::size_t(n) + std::size_t(i)] < 0;
  }
  return result;
}

} // namespace spricka::solve
