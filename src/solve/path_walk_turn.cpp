// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/path_walk.hpp"

#include "base/index.hpp"
#include "solve/contact_qp.hpp"
#include "solve/path_parts.hpp"

#include <array>
#include <cmath>

// Where many rows tie: at the beginning of a path, and where all forces vanish.
namespace spricka::solve {

using base::at;

namespace {

constexpr std::array<double, 2> look_ahead{1e-6, 1e-9}; ///< of the path

// Closed rows that press are equalities, open rows with a gap stay out, the others choose. `length`
// of the path.
ContactSolution solve_direction(const ParametricProblem& problem, const PathState& state,
                                double length, const ContactSettings& settings,
                                std::vector<int>& taking_part) {
  // An open row with a gap stays open for a while whatever the direction: it takes no part.
  for (int i = 0; i < state.rows(); ++i) {
    if (state.closed(i) || !state.is_inequality_row(i) || state.is_at_zero(i)) {
      taking_part.push_back(i);
    }
  }
  std::vector<bool> pressing;
  std::vector<bool> start;
  for (const int i : taking_part) {
    pressing.push_back(!state.is_inequality_row(i) || (state.closed(i) && !state.is_at_zero(i)));
    start.push_back(state.closed(i));
  }
  const ContactProblem rate = path_direction_problem(problem, taking_part, pressing, length);
  return solve_contact(rate, settings, start);
}

} // namespace

bool SolutionPathFollower::set_out() {
  reported_ = state_.closed();
  mark();
  return state_.count_falling_rows_at_zero() <= tied_rows || turn();
}

bool SolutionPathFollower::turn() {
  const std::vector<bool> before = state_.closed();
  std::vector<int> taking_part;
  // Rates of forces and gaps at this t obey a contact problem of their own; its closed rows are
  // those of the next segment.
  const ContactSolution direction =
      solve_direction(problem_, state_, to_ - from_, settings_.start, taking_part);
  if (direction.status == ContactStatus::solved) {
    std::vector<bool> closed(std::size_t(state_.rows()), false);
    for (const int k : direction.basis) {
      closed[at(taking_part[at(k)])] = true;
    }
    return take(closed) || begin(before);
  }
  // No direction: forces are zero here, and bodies free. The functionals as the old rows have them,
  // to compare.
  const base::Vector f = state_.functionals();
  base::Vector unheld;
  for (const double step : look_ahead) {
    const ContactSolution next = solve_at(state_.parameter() + step * (to_ - from_), before);
    unheld = next.unheld;
    if (next.status != ContactStatus::solved) {
      continue;
    }
    std::vector<bool> closed(std::size_t(state_.rows()), false);
    for (const int i : next.basis) {
      closed[at(i)] = true;
    }
    if (take(closed) && state_.is_valid_with_same_functionals(f)) {
      path_.jumps.push_back(state_.parameter());
      return true;
    }
  }
  if (unheld.size() > 0) {
    path_.unheld = unheld;
    return stop(PathStatus::unheld_mode);
  }
  return begin(before);
}

bool SolutionPathFollower::take(const std::vector<bool>& closed) {
  const PathStatus before = path_.status;
  if (begin(closed)) {
    mark();
    return true;
  }
  // A set that cannot be factorised is no end of the path: others are tried after it.
  path_.status = before;
  return false;
}

} // namespace spricka::solve
