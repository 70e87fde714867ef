// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/path_walk.hpp"

#include "base/index.hpp"
#include "solve/contact_qp.hpp"
#include "solve/path_parts.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace spricka::solve {

using base::at;

namespace {

constexpr double no_pivot = 1e-9;     ///< a scaled diagonal below this is none
constexpr std::size_t together = 128; ///< columns made at once
constexpr int shortest_list = 3;      ///< pivots between factorisations, when drift shows

} // namespace

SolutionPath SolutionPathFollower::run(const std::vector<bool>& start) {
  // Only here, and in turn(), is a contact problem solved; all else are exchanges of rows.
  const ContactSolution first = solve_at(from_, start);
  path_.start_status = first.status;
  if (first.status != ContactStatus::solved) {
    path_.status = PathStatus::no_start;
    path_.unheld = first.unheld;
    path_.end = from_;
    return std::move(path_);
  }
  std::vector<bool> closed(std::size_t(rows()), false);
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
  if (!matrix_.begin(closed)) {
    return stop(PathStatus::drift);
  }
  v_ = matrix_.initial_state(held_.b, held_.h);
  d_ = matrix_.initial_state(problem_.db, dh_);
  v_.tail(problem_.f0.size()) += problem_.f0;
  d_.tail(problem_.df.size()) += problem_.df;
  // Round-off is measured by the largest force anywhere on the path, not by those at this t: all
  // may vanish here.
  double size = 0.0;
  for (int i = 0; i < rows(); ++i) {
    if (closed[at(i)]) {
      size = std::max(size, std::abs(y(i)) + (to_ - from_) * std::abs(d_(i)));
    }
  }
  size_ = size;
  tolerance_.resize(rows());
  for (int i = 0; i < rows(); ++i) {
    // The same for gaps: the given ones at both ends of the path.
    const double gap = std::max(std::abs(held_.b(i) + from_ * problem_.db(i)),
                                std::abs(held_.b(i) + to_ * problem_.db(i)));
    level_(i) = held_.d(i) > 0.0 ? gap / held_.d(i) : gap;
    tolerance_(i) = settings_.tolerance * (size + level_(i));
  }
  return true;
}

void SolutionPathFollower::walk() {
  int here = 0; // pivots at this t
  for (;;) {
    const int i = first_bad();
    if (i >= 0 && here == 0 && tied() > tied_rows) {
      here = 1;
      // Ties are judged with a fresh factorisation. It may find the equations broken and go back to
      // an earlier t, where there is nothing to turn for. Asked once at each t: here is no longer
      // 0.
      const double t = t_;
      if ((matrix_.pivots() > 0 && !refresh()) || (t_ == t && !turn())) {
        return;
      }
      continue;
    }
    if (i >= 0) {
      // Least index ends by itself but for round-off; this many pivots at one t are no progress.
      if (++here > 20 * rows() + 200) {
        stop(PathStatus::unfinished);
        return;
      }
      if (!change(i)) {
        return;
      }
      continue;
    }
    here = 0;
    emit(next_event());
    if (t_ >= to_) {
      if (!settled()) {
        continue;
      }
      return;
    }
    if (matrix_.pivots() >= interval_ && !refresh()) {
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

// The least index, not the worst row: exchanges then come to an end where several tie (Murty 1974).
int SolutionPathFollower::first_bad() const {
  for (int i = 0; i < rows(); ++i) {
    if (free_to_change(i) && zero(i) && falls(i)) {
      return i;
    }
  }
  return -1;
}

double SolutionPathFollower::next_event() const {
  double t = to_;
  for (int i = 0; i < rows(); ++i) {
    if (free_to_change(i) && falls(i)) {
      t = std::min(t, time_of(i));
    }
  }
  return t;
}

// The rows that reach zero first, soonest first: columns solved for together cost little more than
// one alone.
std::vector<int> SolutionPathFollower::likely() const {
  std::vector<std::pair<double, int>> order;
  for (int i = 0; i < rows(); ++i) {
    if (free_to_change(i) && falls(i) && time_of(i) <= to_) {
      order.emplace_back(time_of(i), i);
    }
  }
  const auto count = std::min(together, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
  std::vector<int> out;
  for (std::size_t k = 0; k < count; ++k) {
    out.push_back(order[k].second);
  }
  return out;
}

base::Vector SolutionPathFollower::column(int i) {
  // Others are made along only where a solution with the factor is due anyway.
  return matrix_.column(i, matrix_.has_column(i) ? std::vector<int>() : likely());
}

bool SolutionPathFollower::change(int i) {
  // walk() refreshes between segments; this bounds the list where very many rows change at one t.
  if (matrix_.pivots() >= 2 * interval_ && !refresh()) {
    return false;
  }
  base::Vector x = column(i);
  if (x(i) < 1e3 * no_pivot && matrix_.pivots() > 0) {
    // Round-off of the list must not decide whether there is a pivot: asked again when factorised.
    return refresh();
  }
  const std::array<base::Vector*, 2> states{&v_, &d_};
  ++path_.pivots;
  if (x(i) > no_pivot) {
    matrix_.pivot(i, x, states);
    return true;
  }
  const int j = blocking(x, i);
  if (j < 0) {
    return no_way_on(i, x);
  }
  // A row that opens without a pivot sets a mode free. Where the row that stops the mode is some
  // way off, the body jumps there.
  if (closed(i) && y(j) > 1e3 * tolerance_(j)) {
    path_.jumps.push_back(t_);
  }
  base::Vector auxiliary = column(j);
  matrix_.pivot({i, j}, {std::move(x), std::move(auxiliary)}, states);
  return true;
}

int SolutionPathFollower::blocking(const base::Vector& x, int i) const {
  // Of rows that fall as z_i grows the one with the smallest ratio: none goes below zero.
  double least = std::numeric_limits<double>::infinity();
  int found = -1;
  for (int j = 0; j < rows(); ++j) {
    if (j != i && free_to_change(j) && x(j) < -no_pivot) {
      const double z = std::max(y(j), 0.0) / -x(j);
      if (z < least) {
        least = z;
        found = j;
      }
    }
  }
  return found;
}

bool SolutionPathFollower::no_way_on(int i, const base::Vector& x) {
  if (!closed(i)) {
    return stop(PathStatus::inconsistent);
  }
  path_.unheld = split_.controllable * matrix_.modes(x);
  const double norm = path_.unheld.norm();
  if (norm > 0.0) {
    path_.unheld /= norm;
  }
  return stop(PathStatus::unheld_mode);
}

void SolutionPathFollower::emit(double t1) {
  const auto f = problem_.f0.size();
  // Pivots at one t make no segments between them. The first one is kept even if it has no length:
  // it says what is closed where the path begins.
  if (t1 > t_ || path_.segments.empty()) {
    const std::vector<bool>& now = matrix_.closed();
    if (path_.segments.empty()) {
      path_.closed = now;
    } else {
      for (int i = 0; i < rows(); ++i) {
        // Against the last segment, not the last pivot: a row that left and came back at this t has
        // not changed.
        if (now[at(i)] != reported_[at(i)]) {
          path_.changes.push_back({path_.segments.size(), i, now[at(i)]});
        }
      }
    }
    reported_ = now;
    path_.segments.push_back({t_, t1, state().tail(f), d_.tail(f)});
  }
  t_ = t1;
}

bool SolutionPathFollower::sound() {
  ControllableProblem here = held_;
  here.b += t_ * problem_.db;
  here.h += t_ * dh_;
  // Loads at both ends of the path: their sum may vanish at this t.
  const base::Vector ends = (held_.h + from_ * dh_).cwiseAbs() + (held_.h + to_ * dh_).cwiseAbs();
  const double worst = path_residual(here, matrix_, state(), {size_, level_, ends});
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
  if (!begin(std::vector<bool>(matrix_.closed()))) {
    return false;
  }
  mark();
  return true;
}

void SolutionPathFollower::mark() {
  mark_ = {t_, matrix_.closed(), reported_, path_.segments.size(), path_.changes.size()};
}

bool SolutionPathFollower::go_back() {
  t_ = mark_.t;
  reported_ = mark_.reported;
  path_.segments.resize(mark_.segments);
  path_.changes.resize(mark_.changes);
  std::erase_if(path_.jumps, [&](double t) { return t > t_; });
  if (interval_ <= shortest_list) {
    return stop(PathStatus::drift);
  }
  // Round-off gathers with the pivots of a list: the same way again by shorter lists.
  interval_ = std::max(shortest_list, interval_ / 4);
  return begin(mark_.closed);
}

} // namespace spricka::solve
