// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/parametric.hpp"
#include "solve/blas.hpp"
#include "solve/mode_split.hpp"
#include "solve/path_walk.hpp"

#include <algorithm>
#include <cassert>

namespace spricka::solve {

namespace {

/// The uncontrollable motion that loads on the path drive; loads that steps let rest do not count.
base::Vector uncontrollable_on_path(const ParametricProblem& problem, const ModeSplit& split,
                                    double from, double to) {
  const base::Vector first = problem.at_zero.h + from * problem.dh;
  const base::Vector last = problem.at_zero.h + to * problem.dh;
  double scale = problem.at_zero.load_scale;
  for (const base::Vector* h : {&first, &last}) {
    scale = h->size() > 0 ? std::max(scale, h->cwiseAbs().maxCoeff()) : scale;
  }
  return uncontrollable_motion(split, last, resting_load * scale);
}

} // namespace

SolutionPath follow_solution_path(const ParametricProblem& problem, double from, double to,
                                  const SolutionPathSettings& settings,
                                  const std::vector<bool>& start) {
  assert(to > from);
  blas::force_single_blas_thread();
  const ModeSplit split =
      split_controllable_modes(problem.at_zero.B, problem.at_zero.opening_scale);
  const base::Vector uncontrollable = uncontrollable_on_path(problem, split, from, to);
  if (uncontrollable.size() > 0) {
    SolutionPath path;
    path.status = PathStatus::unheld_mode;
    path.unheld = uncontrollable;
    path.end = from;
    return path;
  }
  return SolutionPathFollower(problem, split, from, to, settings).follow_path(start);
}

} // namespace spricka::solve
