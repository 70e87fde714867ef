// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/contact_qp.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"
#include "solve/criss_cross.hpp"
#include "solve/held_problem.hpp"
#include "solve/likely_set.hpp"
#include "solve/load_balance.hpp"
#include "solve/mode_split.hpp"
#include "solve/rest.hpp"
#include "solve/set_solution.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

namespace spricka::solve {

using base::at;

namespace {

/// Block steps in all, and without progress (Judice and Pires 1994), from any start; without
/// progress from a likely set.
constexpr int first_steps = 10;
constexpr int first_patience = 4;
constexpr int patience = 10;
constexpr double pivot_tolerance = 1e-9; ///< of signs while the tableau gathers round-off
constexpr int repeats = 5;               ///< of the tableau, each from a clean start

struct BlockSearch {
  bool settled = false;
  std::vector<int> best; ///< closed rows of the best regular set met
  int iterations = 0;
};

struct BlockStart {
  std::vector<bool> closed;
  int steps = 0;    ///< at most
  int patience = 0; ///< without progress
};

/// Closes and opens all violated rows at once (primal-dual active set; Hintermueller, Ito and
/// Kunisch 2003) until none is left, a set comes back or progress ends.
BlockSearch block_pivoting(const ControllableProblem& problem, const ContactSettings& settings,
                           const std::vector<int>& spanning, BlockStart start,
                           BorderedFactor& factor) {
  std::vector<bool>& closed = start.closed;
  BlockSearch search;
  search.best = spanning;
  std::size_t least = closed.size() + 1;
  int stalled = 0;
  std::set<std::vector<bool>> met;
  // A set that comes back would come back for ever: the method has no memory but the set.
  while (search.iterations < start.steps && met.insert(closed).second) {
    std::vector<int> A;
    for (int i = 0; i < problem.rows(); ++i) {
      if (closed[at(i)]) {
        A.push_back(i);
      }
    }
    ++search.iterations;
    if (!factor.factorise(A)) {
      for (const int i : spanning) {
        closed[at(i)] = true; // too few rows left to hold the modes
      }
      continue;
    }
    const SolutionWithRowsClosed solution = solve_active_set(problem, factor, false);
    const std::vector<int> violated = violated_rows(problem, factor, solution, settings.tolerance);
    if (violated.empty()) {
      search.settled = true;
      search.best = factor.rows();
      return search;
    }
    stalled = violated.size() < least ? 0 : stalled + 1;
    if (violated.size() < least) {
      least = violated.size();
      search.best = factor.rows();
    }
    if (stalled > start.patience) {
      return search;
    }
    // Redundant rows start from open, so that they close again only if their gap says so.
    for (const int i : factor.redundant_rows()) {
      closed[at(i)] = problem.equality[at(i)];
    }
    for (const int i : violated) {
      if (!problem.equality[at(i)]) {
        closed[at(i)] = !closed[at(i)];
      }
    }
  }
  return search;
}

/// The finite fallback, begun again from its own answer while round-off still shows.
ContactStatus pivot_to_the_end(const ControllableProblem& problem, const ContactSettings& settings,
                               std::vector<int> A, BorderedFactor& factor,
                               ContactSolution& answer) {
  for (int turn = 0; turn < repeats; ++turn) {
    // Loose first, as the tableau gathers round-off; from a clean start few pivots are left.
    const double tolerance = turn == 0 ? pivot_tolerance : settings.tolerance;
    const PivotResult result = pivot_criss_cross(
        problem, A, std::max(tolerance, settings.tolerance), settings.max_pivots - answer.pivots);
    answer.pivots += result.pivots;
    if (result.status == PivotStatus::infeasible && turn > 0) {
      break; // a force of round-off that no row can take, on a set that was settled before
    }
    if (result.status == PivotStatus::infeasible) {
      return ContactStatus::inconsistent;
    }
    if (result.status != PivotStatus::optimal || !factor.factorise(result.closed)) {
      return ContactStatus::max_iterations;
    }
    const SolutionWithRowsClosed solution = solve_active_set(problem, factor, true);
    if (violated_rows(problem, factor, solution, settings.tolerance).empty()) {
      return ContactStatus::solved;
    }
    A = factor.rows();
  }
  if (!factor.redundant_rows().empty()) {
    return ContactStatus::inconsistent; // an equality row that the others contradict
  }
  return ContactStatus::solved; // the residual decides
}

/// Largest violation of the conditions over its scale.
double residual_of(const ControllableProblem& problem, const SolutionWithRowsClosed& s,
                   const std::vector<bool>& closed) {
  const base::Vector balance = problem.h + problem.B.transpose() * s.lambda;
  const base::Vector size =
      problem.h.cwiseAbs() + problem.B.cwiseAbs().transpose() * s.lambda.cwiseAbs();
  double residual = 0.0;
  for (int j = 0; j < problem.mode_count(); ++j) {
    residual = std::max(residual, divide_by_scale(std::abs(balance(j)), size(j) + s.force_scale));
  }
  for (int i = 0; i < problem.rows(); ++i) {
    const bool equality = problem.equality[at(i)];
    const bool zero = closed[at(i)] || equality;
    const double wrong_gap = zero ? std::abs(s.gap(i)) : std::max(-s.gap(i), 0.0);
    const double wrong_force = equality ? 0.0 : std::max(-s.lambda(i), 0.0);
    residual = std::max({residual, divide_by_scale(wrong_gap, s.gap_scale(i)),
                         divide_by_scale(wrong_force, s.force_scale)});
  }
  return std::isfinite(s.gap.sum() + s.lambda.sum()) ? residual : INFINITY;
}

/// The answer from a clean solve on the final set. Motions that nothing presses come to rest.
void take_solution(const ControllableProblem& problem, const ModeSplit& split,
                   const BorderedFactor& factor, double scale, ContactSolution& answer) {
  SolutionWithRowsClosed s = solve_active_set(problem, factor, true);
  answer.basis = factor.rows();
  for (const int i : factor.rows()) {
    answer.closed[at(i)] = true;
  }
  answer.residual = residual_of(problem, s, answer.closed);
  const base::Vector settled = s.alpha;
  const std::vector<bool> pressing =
      find_pressing_rows(problem, split, s.lambda, rest_load * scale);
  std::vector<AllowedGapChange> change;
  for (int i = 0; i < problem.rows(); ++i) {
    const bool holds = problem.equality[at(i)] || pressing[at(i)];
    change.push_back(holds ? AllowedGapChange::none : AllowedGapChange::not_through_zero);
  }
  const int free = minimise_free_motions(problem, split, s.lambda, change,
                                         base::Vector::Zero(problem.mode_count()), s.alpha);
  answer.resting_modes += free;
  // Motions to rest move no pressing row, but the gaps of the others.
  s.gap += problem.B * (s.alpha - settled);
  for (int i = 0; i < problem.rows(); ++i) {
    const double touching = 1e-10 * s.gap_scale(i);
    const bool closed = answer.closed[at(i)];
    if (!closed && s.gap(i) <= touching &&
        factor.row_pivot_after_closed_rows(i) < 10.0 * redundancy) {
      ++answer.redundant;
    }
    if (!problem.equality[at(i)]) {
      answer.closed[at(i)] = closed && (free == 0 || s.gap(i) <= touching);
      s.lambda(i) = answer.closed[at(i)] ? std::max(s.lambda(i), 0.0) : 0.0;
      s.gap(i) = answer.closed[at(i)] ? 0.0 : std::max(s.gap(i), 0.0);
    }
  }
  answer.lambda = s.lambda;
  answer.gap = s.gap;
  const base::Vector alpha = split.controllable * s.alpha;
  answer.alpha = alpha - split.uncontrollable * (split.uncontrollable.transpose() * alpha);
}

} // namespace

ContactSolution solve_contact(const ContactProblem& problem, const ContactSettings& settings,
                              const std::vector<bool>& start) {
  const Eigen::Index n = problem.b.size();
  assert(problem.W.rows() == n && problem.W.cols() == n);
  assert(problem.B.rows() == n && problem.B.cols() == problem.h.size());
  blas::force_single_blas_thread();
  ContactSolution answer;
  answer.lambda = base::Vector::Zero(n);
  answer.alpha = base::Vector::Zero(problem.h.size());
  answer.gap = problem.b;
  answer.closed.assign(static_cast<std::size_t>(n), false);
  const double scale = load_scale(problem);

  // 1. modes that no row touches rest, or nothing holds them
  const ModeSplit split = split_controllable_modes(problem.B, problem.opening_scale);
  answer.resting_modes = static_cast<int>(split.uncontrollable.cols());
  answer.unheld = uncontrollable_motion(split, problem.h, resting_load * scale);
  if (answer.unheld.size() > 0) {
    answer.status = ContactStatus::unheld_mode;
    return answer;
  }

  if (split.uncontrollable.cols() > 0 && scale > 0.0) {
    answer.left_over = (split.uncontrollable.transpose() * problem.h).cwiseAbs().maxCoeff() / scale;
  }

  // 2. loads that the rows cannot take: the motion that opens them all
  ControllableProblem held = restrict_to_controllable_modes(problem, split);
  const LoadBalance balance = balance_loads(held);
  answer.unheld =
      unstopped_opening_motion(split, balance, rest_load * std::max(scale, problem.h.norm()));
  if (answer.unheld.size() > 0) {
    answer.status = ContactStatus::unheld_mode;
    return answer;
  }
  if (balance.remainder.size() > 0) {
    held.h -= balance.remainder;
  }

  // 3. block pivoting, and the finite fallback where it does not settle
  std::vector<bool> closed = start;
  closed.resize(static_cast<std::size_t>(n), start.empty());
  for (int i = 0; i < held.rows(); ++i) {
    closed[at(i)] = closed[at(i)] || held.equality[at(i)];
  }
  BorderedFactor factor(held);
  const std::vector<int> spanning = rows_spanning_modes(held, balance.pressed);
  BlockSearch search = block_pivoting(
      held, settings, spanning,
      {std::move(closed), std::min(first_steps, settings.max_block_iterations), first_patience},
      factor);
  answer.block_iterations = search.iterations;
  if (!search.settled) {
    // Where bodies are held by contact alone a set that is much too large loses but its rim in each
    // step: it is told from afar what is left of it.
    search = block_pivoting(held, settings, spanning,
                            {predict_closed_rows(held), settings.max_block_iterations, patience},
                            factor);
    answer.block_iterations += search.iterations;
  }
  if (!search.settled) {
    answer.status = pivot_to_the_end(held, settings, search.best, factor, answer);
    if (answer.status != ContactStatus::solved) {
      return answer;
    }
  }

  // 4. one clean solve on the final set
  take_solution(held, split, factor, scale, answer);
  if (!(answer.residual < accepted_residual)) {
    answer.status = ContactStatus::max_iterations;
  }
  return answer;
}

} // namespace spricka::solve
