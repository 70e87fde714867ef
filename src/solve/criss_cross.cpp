// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/criss_cross.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"
#include "solve/set_solution.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

/// Pivots for each row in which the worst one is exchanged: seldom more than one or two are needed,
/// where the least index alone may take a number that doubles with each row.
constexpr int greedy = 8;

/// y = q + T z on the inequality rows, in units of d: y the force of closed rows and the gap of
/// open ones, z the others. Principal pivots keep T positive semidefinite.
struct Tableau {
  std::vector<int> row; ///< [k] of the problem
  std::vector<bool> closed;
  base::Matrix T;     ///< [k, k]
  base::Vector q;     ///< [k]
  base::Vector level; ///< [k] scaled |b|

  [[nodiscard]] int size() const { return static_cast<int>(row.size()); }
};

/// The columns of z in the problem's own units: what a gap of a closed row or a force on an open
/// one does to the forces [a], the modes [m] and then to all gaps [n].
struct TableauColumns {
  base::Matrix top;
  base::Matrix bottom;
};

TableauColumns columns_of(const ControllableProblem& problem, const BorderedFactor& factor,
                          const Tableau& t) {
  const std::vector<int>& A = factor.rows();
  const Eigen::Index a = index(A.size());
  std::vector<int> place(std::size_t(problem.rows()), -1);
  for (std::size_t r = 0; r < A.size(); ++r) {
    place[at(A[r])] = static_cast<int>(r);
  }
  TableauColumns columns{base::Matrix::Zero(a, t.size()),
                         base::Matrix::Zero(problem.mode_count(), t.size())};
  for (int j = 0; j < t.size(); ++j) {
    const int i = t.row[at(j)];
    if (t.closed[at(j)]) {
      // A gap of one on a closed row: the forces that hold it open by that much.
      columns.top(place[at(i)], j) = 1.0;
      continue;
    }
    for (Eigen::Index r = 0; r < a; ++r) {
      columns.top(r, j) = -problem.W(A[at(r)], i);
    }
    columns.bottom.col(j) = -problem.B.row(i).transpose();
  }
  factor.solve(columns.top, columns.bottom);
  return columns;
}

Tableau tableau_of(const ControllableProblem& problem, const BorderedFactor& factor) {
  const int n = problem.rows();
  const std::vector<int>& A = factor.rows();
  std::vector<int> place(std::size_t(n), -1);
  for (std::size_t r = 0; r < A.size(); ++r) {
    place[at(A[r])] = static_cast<int>(r);
  }
  Tableau t;
  for (int i = 0; i < n; ++i) {
    if (!problem.equality[at(i)]) {
      t.row.push_back(i);
      t.closed.push_back(place[at(i)] >= 0);
    }
  }
  // (solve.19): T from the columns, q from the solution with z = 0.
  const TableauColumns z = columns_of(problem, factor, t);
  const SolutionWithRowsClosed s = solve_active_set(problem, factor, false);
  const int k = t.size();
  const int a = static_cast<int>(A.size());
  base::Matrix W_kA(k, a);
  base::Matrix B_k(k, problem.mode_count());
  for (int j = 0; j < k; ++j) {
    const int i = t.row[at(j)];
    for (int r = 0; r < a; ++r) {
      W_kA(j, r) = problem.W(i, A[at(r)]);
    }
    B_k.row(j) = problem.B.row(i);
  }
  t.T = B_k * z.bottom;
  if (a > 0) {
    blas::gemm({.m = k, .n = k, .k = a, .beta = 1.0}, {W_kA.data(), k}, {z.top.data(), a},
               {t.T.data(), k});
  }
  t.q.resize(k);
  t.level.resize(k);
  base::Vector unit(k); // from the problem's units to those of d
  for (int j = 0; j < k; ++j) {
    const int i = t.row[at(j)];
    const double d = problem.d(i) > 0.0 ? problem.d(i) : 1.0;
    unit(j) = t.closed[at(j)] ? d : 1.0 / d;
    t.level(j) = std::abs(problem.b(i)) / d;
    t.q(j) = t.closed[at(j)] ? s.lambda(i) : s.gap(i);
  }
  for (int j = 0; j < k; ++j) {
    const int i = t.row[at(j)];
    if (t.closed[at(j)]) {
      t.T.row(j) = z.top.row(place[at(i)]);
      continue;
    }
    for (int c = 0; c < k; ++c) {
      // A force on an open row also opens the others, and itself, by W directly.
      t.T(j, c) += t.closed[at(c)] ? 0.0 : problem.W(i, t.row[at(c)]);
    }
  }
  t.T = unit.asDiagonal() * t.T * unit.asDiagonal();
  t.q.array() *= unit.array();
  return t;
}

/// Exchanges y and z of one row or of two.
void pivot(Tableau& t, const std::vector<int>& P) {
  const int p = static_cast<int>(P.size());
  const int k = t.size();
  base::Matrix column(k, p);
  base::Matrix row(p, k);
  base::Matrix core(p, p);
  base::Vector q_P(p);
  for (int c = 0; c < p; ++c) {
    column.col(c) = t.T.col(P[at(c)]);
    row.row(c) = t.T.row(P[at(c)]);
    q_P(c) = t.q(P[at(c)]);
    for (int r = 0; r < p; ++r) {
      core(r, c) = t.T(P[at(r)], P[at(c)]);
    }
  }
  // (solve.30) for one row or two: y_P and z_P change places, the rest follows.
  const base::Matrix inverse = core.inverse();
  const base::Matrix column_inverse = column * inverse;
  const base::Matrix inverse_row = inverse * row;
  blas::gemm({.m = k, .n = k, .k = p, .alpha = -1.0, .beta = 1.0}, {column_inverse.data(), k},
             {row.data(), p}, {t.T.data(), k});
  t.q -= column_inverse * q_P;
  const base::Vector q_new = -(inverse * q_P);
  for (int c = 0; c < p; ++c) {
    const int j = P[at(c)];
    t.T.col(j) = column_inverse.col(c);
    t.q(j) = q_new(c);
  }
  for (int c = 0; c < p; ++c) {
    const int j = P[at(c)];
    t.T.row(j) = -inverse_row.row(c);
    for (int e = 0; e < p; ++e) {
      t.T(j, P[at(e)]) = inverse(c, e);
    }
    t.closed[at(j)] = !t.closed[at(j)];
  }
}

/// The row with the most negative y, or the first one below zero; -1: none is.
int violated_row(const Tableau& t, double tolerance, bool first) {
  double force = 0.0;
  for (int j = 0; j < t.size(); ++j) {
    // The measure of y = 0: the largest force, and for a row its own given gap.
    force = t.closed[at(j)] ? std::max(force, std::abs(t.q(j))) : force;
  }
  int worst = -1;
  for (int j = 0; j < t.size(); ++j) {
    if (t.q(j) < -tolerance * (force + t.level(j)) && (worst < 0 || t.q(j) < t.q(worst))) {
      worst = j;
      if (first) {
        break;
      }
    }
  }
  return worst;
}

/// What to exchange so that y_i can become zero: i alone, or with the least partner; empty when
/// y_i < 0 for every z >= 0.
std::vector<int> choose_pivot(const Tableau& t, int i) {
  if (t.T(i, i) > redundancy) {
    return {i};
  }
  // T_ii = 0 and T semidefinite: row and column are opposite, and zero between rows of one kind
  for (int j = 0; j < t.size(); ++j) {
    if (t.closed[at(j)] != t.closed[at(i)] && t.T(i, j) > 1e-9) {
      return {i, j};
    }
  }
  return {};
}

} // namespace

PivotResult pivot_criss_cross(const ControllableProblem& problem, const std::vector<int>& A,
                              double tolerance, int max_pivots) {
  PivotResult result;
  BorderedFactor factor(problem);
  if (!factor.factorise(A)) {
    result.status = PivotStatus::unheld;
    return result;
  }
  Tableau t = tableau_of(problem, factor);
  for (;;) {
    // The worst row while that is likely to be quick; then the least index, which is finite.
    const int i = violated_row(t, tolerance, result.pivots >= greedy * t.size());
    if (i < 0) {
      break;
    }
    const std::vector<int> P = choose_pivot(t, i);
    if (P.empty()) {
      result.status = PivotStatus::infeasible;
      break;
    }
    if (result.pivots >= max_pivots) {
      result.status = PivotStatus::max_pivots;
      break;
    }
    pivot(t, P);
    ++result.pivots;
  }
  for (int i = 0; i < problem.rows(); ++i) {
    if (problem.equality[at(i)]) {
      result.closed.push_back(i);
    }
  }
  for (int j = 0; j < t.size(); ++j) {
    if (t.closed[at(j)]) {
      result.closed.push_back(t.row[at(j)]);
    }
  }
  std::sort(result.closed.begin(), result.closed.end());
  return result;
}

} // namespace spricka::solve
