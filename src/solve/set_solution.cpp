// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/set_solution.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

/// Adds the solution for the right-hand sides [a, 1] and [m, 1] to lambda and alpha.
void add_solution(const BorderedFactor& factor, base::Matrix top, base::Matrix bottom,
                  SolutionWithRowsClosed& s) {
  factor.solve(top, bottom);
  const std::vector<int>& A = factor.rows();
  for (std::size_t r = 0; r < A.size(); ++r) {
    s.lambda(A[r]) += top(index(r), 0);
  }
  s.alpha += bottom.col(0);
}

} // namespace

SolutionWithRowsClosed solve_active_set(const ControllableProblem& problem,
                                        const BorderedFactor& factor, bool refine) {
  const int n = problem.rows();
  const std::vector<int>& A = factor.rows();
  SolutionWithRowsClosed s;
  s.lambda = base::Vector::Zero(n);
  s.alpha = base::Vector::Zero(problem.mode_count());
  s.gap = problem.b;
  base::Vector opened(n);
  for (const bool again : {false, true}) {
    if (again && !refine) {
      break;
    }
    base::Matrix top(index(A.size()), 1);
    for (std::size_t r = 0; r < A.size(); ++r) {
      top(index(r), 0) = -s.gap(A[r]);
    }
    add_solution(factor, top, -(problem.h + problem.B.transpose() * s.lambda), s);
    blas::gemm({.m = n, .n = 1, .k = n}, {problem.W.data(), n}, {s.lambda.data(), n},
               {opened.data(), n});
    s.gap = problem.b + opened + problem.B * s.alpha;
  }
  // in units of d, where forces and openings can be compared: what a force does to its own row is
  // the least that the terms of a gap amount to
  double size = 0.0;
  const base::Vector travel = opened.cwiseAbs() + (problem.B * s.alpha).cwiseAbs();
  for (int i = 0; i < n; ++i) {
    const double d = problem.d(i);
    size = std::max(size, std::abs(s.lambda(i)) * d);
    size = d > 0.0 ? std::max(size, travel(i) / d) : size;
    s.force_scale = std::max(s.force_scale, std::abs(s.lambda(i)));
  }
  // forces come out of gaps closed against compliances; a thousandth of that is round-off's measure
  // where they cancel
  for (const int i : A) {
    const double d = problem.d(i);
    s.force_scale = std::max(s.force_scale, 1e-3 * std::abs(problem.b(i)) / (d * d));
  }
  s.gap_scale = problem.b.cwiseAbs() + size * problem.d;
  return s;
}

std::vector<int> violated_rows(const ControllableProblem& problem, const BorderedFactor& factor,
                               const SolutionWithRowsClosed& solution, double tolerance) {
  std::vector<bool> closed(std::size_t(problem.rows()), false);
  for (const int i : factor.rows()) {
    closed[at(i)] = true;
  }
  std::vector<int> violated;
  for (int i = 0; i < problem.rows(); ++i) {
    const bool equality = problem.equality[at(i)];
    if (closed[at(i)]) {
      if (!equality && solution.lambda(i) < -tolerance * solution.force_scale) {
        violated.push_back(i);
      }
    } else if (solution.gap(i) < -tolerance * solution.gap_scale(i) ||
               (equality && solution.gap(i) > tolerance * solution.gap_scale(i))) {
      violated.push_back(i);
    }
  }
  return violated;
}

} // namespace spricka::solve
