// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/path_walk.hpp"

#include "base/index.hpp"
#include "solve/contact_qp.hpp"
#include "solve/path_parts.hpp"

#include <array>
#include <cmath>

namespace spricka::solve {

using base::at;

namespace {

constexpr int shortest_list = 3; ///< pivots between factorisations, when drift shows

} // namespace

SolutionPath SolutionPathFollower::follow_path(const std::vector<bool>& start) {
  // Only here, and in turn(), is a contact problem solved; all else are exchanges of rows.
  const ContactSolution first = solve_at(from_, start);
  path_.start_status = first.status;
  if (first.status != ContactStatus::solved) {
    path_.status = PathStatus::no_start;
    path_.unheld = first.unheld;
    path_.end = from_;
    return std::move(path_);
  }
  std::vector<bool> closed(std::size_t(state_.rows()), false);
  for (const int i : first.basis) {
    closed[at(i)] = true;
  }
  if (begin(closed) && set_out()) {
    walk();
  }
  path_.end = path_.segments.empty() ? from_ : path_.segments.back().to;
  return std::move(path_);
}

bool SolutionPathFollower::stop(PathStatus status) {
  path_.status = status;
  return false;
}

ContactSolution SolutionPathFollower::solve_at(double t, const std::vector<bool>& start) const {
  ContactProblem problem = problem_.at_zero;
  problem.b += t * problem_.db;
  problem.h += t * problem_.dh;
  return solve_contact(problem, settings_.start, start);
}

bool SolutionPathFollower::begin(const std::vector<bool>& closed) {
  ++path_.factorisations;
  return state_.factorise(closed) || stop(PathStatus::drift);
}

void SolutionPathFollower::walk() {
  int here = 0; // pivots at this t
  for (;;) {
    const int i = state_.first_falling_row_at_zero();
    if (i >= 0 && here == 0 && state_.count_falling_rows_at_zero() > tied_rows) {
      here = 1;
      // Ties are judged with a fresh factorisation. It may find the equations broken and go back to
      // an earlier t, where there is nothing to turn for. Asked once at each t: here is no longer
      // 0.
      const double t = state_.parameter();
      if ((state_.pivots() > 0 && !refresh()) || (state_.parameter() == t && !turn())) {
        return;
      }
      continue;
    }
    if (i >= 0) {
      // Least index ends by itself but for round-off; this many pivots at one t are no progress.
      if (++here > 20 * state_.rows() + 200) {
        stop(PathStatus::unfinished);
        return;
      }
      if (!change(i)) {
        return;
      }
      continue;
    }
    here = 0;
    emit(state_.parameter_of_next_event());
    if (state_.parameter() >= to_) {
      if (!settled()) {
        continue;
      }
      return;
    }
    if (state_.pivots() >= interval_ && !refresh()) {
      return;
    }
  }
}

bool SolutionPathFollower::settled() {
  if (sound()) {
    return true;
  }
  // Where there is a way back the walk goes on from there; else it is over, and stop() says why.
  return !go_back();
}

bool SolutionPathFollower::change(int i) {
  // walk() refreshes between segments; this bounds the list where very many rows change at one t.
  if (state_.pivots() >= 2 * interval_ && !refresh()) {
    return false;
  }
  base::Vector x = state_.column(i);
  if (x(i) < 1e3 * no_pivot && state_.pivots() > 0) {
    // Round-off of the list must not decide whether there is a pivot: asked again when factorised.
    return refresh();
  }
  ++path_.pivots;
  if (x(i) > no_pivot) {
    state_.pivot(i, x);
    return true;
  }
  const int j = state_.first_blocking_row(x, i);
  if (j < 0) {
    return no_way_on(i, x);
  }
  // A row that opens without a pivot sets a mode free. Where the row that stops the mode is some
  // way off, the body jumps there.
  if (state_.closed(i) && state_.force_or_gap(j) > 1e3 * state_.tolerance(j)) {
    path_.jumps.push_back(state_.parameter());
  }
  base::Vector auxiliary = state_.column(j);
  state_.pivot({i, j}, {std::move(x), std::move(auxiliary)});
  return true;
}

bool SolutionPathFollower::no_way_on(int i, const base::Vector& x) {
  if (!state_.closed(i)) {
    return stop(PathStatus::inconsistent);
  }
  path_.unheld = split_.controllable * state_.mode_amplitudes(x);
  const double norm = path_.unheld.norm();
  if (norm > 0.0) {
    path_.unheld /= norm;
  }
  return stop(PathStatus::unheld_mode);
}

void SolutionPathFollower::emit(double t1) {
  // Pivots at one t make no segments between them. The first one is kept even if it has no length:
  // it says what is closed where the path begins.
  if (t1 > state_.parameter() || path_.segments.empty()) {
    const std::vector<bool>& now = state_.closed();
    if (path_.segments.empty()) {
      path_.closed = now;
    } else {
      for (int i = 0; i < state_.rows(); ++i) {
        // Against the last segment, not the last pivot: a row that left and came back at this t has
        // not changed.
        if (now[at(i)] != reported_[at(i)]) {
          path_.changes.push_back({path_.segments.size(), i, now[at(i)]});
        }
      }
    }
    reported_ = now;
    path_.segments.push_back(
        {state_.parameter(), t1, state_.functionals(), state_.functional_rates()});
  }
  state_.set_parameter(t1);
}

bool SolutionPathFollower::sound() {
  const double worst = state_.residual();
  const bool good = worst <= settings_.allowed_drift;
  if (good) {
    path_.residual = std::max(path_.residual, worst);
  }
  return good;
}

bool SolutionPathFollower::refresh() {
  if (!sound()) {
    return go_back();
  }
  if (!begin(std::vector<bool>(state_.closed()))) {
    return false;
  }
  mark();
  return true;
}

void SolutionPathFollower::mark() {
  mark_ = {state_.parameter(), state_.closed(), reported_, path_.segments.size(),
           path_.changes.size()};
}

bool SolutionPathFollower::go_back() {
  state_.set_parameter(mark_.t);
  reported_ = mark_.reported;
  path_.segments.resize(mark_.segments);
  path_.changes.resize(mark_.changes);
  std::erase_if(path_.jumps, [&](double t) { return t > state_.parameter(); });
  if (interval_ <= shortest_list) {
    return stop(PathStatus::drift);
  }
  // Round-off gathers with the pivots of a list: the same way again by shorter lists.
  interval_ = std::max(shortest_list, interval_ / 4);
  return begin(mark_.closed);
}

} // namespace spricka::solve
