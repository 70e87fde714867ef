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

} // namespace

bool SolutionPathFollower::set_out() {
  reported_ = matrix_.closed();
  mark();
  return tied() <= tied_rows || turn();
}

int SolutionPathFollower::tied() const {
  int count = 0;
  for (int i = 0; i < rows(); ++i) {
    count += free_to_change(i) && zero(i) && falls(i) ? 1 : 0;
  }
  return count;
}

bool SolutionPathFollower::turn() {
  const std::vector<bool> before = matrix_.closed();
  std::vector<int> taking_part;
  // Rates of forces and gaps at this t obey a contact problem of their own; its closed rows are
  // those of the next segment.
  const ContactSolution direction = solve_direction(taking_part);
  if (direction.status == ContactStatus::solved) {
    std::vector<bool> closed(std::size_t(rows()), false);
    for (const int k : direction.basis) {
      closed[at(taking_part[at(k)])] = true;
    }
    return take(closed) || begin(before);
  }
  // No direction: forces are zero here, and bodies free. The functionals as the old rows have them,
  // to compare.
  const base::Vector f = state().tail(problem_.f0.size());
  base::Vector unheld;
  for (const double step : look_ahead) {
    const ContactSolution next = solve_at(t_ + step * (to_ - from_), before);
    unheld = next.unheld;
    if (next.status != ContactStatus::solved) {
      continue;
    }
    std::vector<bool> closed(std::size_t(rows()), false);
    for (const int i : next.basis) {
      closed[at(i)] = true;
    }
    if (take(closed) && reaches_back(f)) {
      path_.jumps.push_back(t_);
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

// A thousand tolerances: the rows were found a little further on, not here, and what is off by less
// is zero to the walk, and exchanged where it falls.
bool SolutionPathFollower::reaches_back(const base::Vector& f) const {
  for (int i = 0; i < rows(); ++i) {
    if (free_to_change(i) && y(i) < -1e3 * tolerance_(i)) {
      return false;
    }
  }
  const base::Vector now = state().tail(f.size());
  const double size =
      (now.cwiseAbs() + (to_ - from_) * d_.tail(f.size()).cwiseAbs() + f.cwiseAbs()).sum();
  return f.size() == 0 || (now - f).cwiseAbs().maxCoeff() <= 1e-8 * size;
}

ContactSolution SolutionPathFollower::solve_direction(std::vector<int>& taking_part) const {
  // An open row with a gap stays open for a while whatever the direction: it takes no part.
  for (int i = 0; i < rows(); ++i) {
    if (closed(i) || !free_to_change(i) || zero(i)) {
      taking_part.push_back(i);
    }
  }
  std::vector<bool> pressing;
  std::vector<bool> start;
  for (const int i : taking_part) {
    pressing.push_back(!free_to_change(i) || (closed(i) && !zero(i)));
    start.push_back(closed(i));
  }
  const ContactProblem rate = path_direction_problem(problem_, taking_part, pressing, to_ - from_);
  return solve_contact(rate, settings_.start, start);
}

} // namespace spricka::solve
