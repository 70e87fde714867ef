// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/parametric.hpp"
#include "solve/blas.hpp"
#include "solve/mode_split.hpp"
#include "solve/path_parts.hpp"
#include "solve/swept_matrix.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

namespace spricka::solve {

namespace {

constexpr double no_pivot = 1e-9;    ///< a scaled diagonal below this is none
constexpr int tied_rows = 4;         ///< more rows at zero that want to move: ask for the direction
constexpr std::size_t together = 64; ///< columns made at once
constexpr std::array<double, 2> look_ahead{1e-6, 1e-9}; ///< of the path
constexpr int shortest_list = 3; ///< pivots between factorisations, when drift shows

base::Vector at(const base::Vector& v, const base::Vector& d, double t) {
  return v + t * d;
}

/// What can be returned to: the path as it was when the matrix was last factorised.
struct Mark {
  double t = 0.0;
  std::vector<bool> closed, reported;
  std::size_t segments = 0, changes = 0;
};

class Walk {
public:
  Walk(const ParametricProblem& problem, const ModeSplit& split, double from, double to,
       const PathSettings& settings)
      : problem_(problem), split_(split), settings_(settings),
        held_(held_problem(problem.at_zero, split)), dh_(split.felt.transpose() * problem.dh),
        matrix_(held_, problem.of_force, problem.of_mode * split.felt), t_(from), from_(from),
        to_(to), interval_(settings.refactor) {}

  SolutionPath run(const std::vector<bool>& start) {
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
      closed[std::size_t(i)] = true;
    }
    if (begin(closed) && set_out()) {
      walk();
    }
    path_.end = path_.segments.empty() ? from_ : path_.segments.back().to;
    return std::move(path_);
  }

private:
  [[nodiscard]] int rows() const { return held_.rows(); }
  [[nodiscard]] bool free_to_change(int i) const { return !held_.equality[std::size_t(i)]; }
  [[nodiscard]] bool closed(int i) const { return matrix_.closed()[std::size_t(i)]; }
  [[nodiscard]] double y(int i) const { return v_(i) + t_ * d_(i); }
  [[nodiscard]] bool zero(int i) const { return y(i) <= tolerance_(i); }
  /// Rates that would not leave the tolerance on the whole path are none.
  [[nodiscard]] bool falls(int i) const { return d_(i) * (to_ - from_) < -tolerance_(i); }
  bool stop(PathStatus status) {
    path_.status = status;
    return false;
  }

  ContactSolution solve_at(double t, const std::vector<bool>& start) const {
    ContactProblem problem = problem_.at_zero;
    problem.b += t * problem_.db;
    problem.h += t * problem_.dh;
    return solve_contact(problem, settings_.start, start);
  }

  /// A clean factorisation for these closed rows, at the t where the walk stands.
  bool begin(const std::vector<bool>& closed) {
    ++path_.factorisations;
    if (!matrix_.begin(closed)) {
      return stop(PathStatus::drift);
    }
    v_ = matrix_.state(held_.b, held_.h);
    d_ = matrix_.state(problem_.db, dh_);
    v_.tail(problem_.f0.size()) += problem_.f0;
    d_.tail(problem_.df.size()) += problem_.df;
    double size = 0.0;
    for (int i = 0; i < rows(); ++i) {
      if (closed[std::size_t(i)]) {
        size = std::max(size, std::abs(y(i)) + (to_ - from_) * std::abs(d_(i)));
      }
    }
    size_ = size;
    tolerance_.resize(rows());
    for (int i = 0; i < rows(); ++i) {
      const double gap = std::max(std::abs(held_.b(i) + from_ * problem_.db(i)),
                                  std::abs(held_.b(i) + to_ * problem_.db(i)));
      level_(i) = held_.d(i) > 0.0 ? gap / held_.d(i) : gap;
      tolerance_(i) = settings_.tolerance * (size + level_(i));
    }
    return true;
  }

  bool set_out() {
    reported_ = matrix_.closed();
    mark();
    return tied() <= tied_rows || turn();
  }

  /// Rows at zero that want to move.
  [[nodiscard]] int tied() const {
    int count = 0;
    for (int i = 0; i < rows(); ++i) {
      count += free_to_change(i) && zero(i) && falls(i) ? 1 : 0;
    }
    return count;
  }

  /// Many rows that tie are not exchanged one by one. They are a contact problem of their own, for
  /// the direction of the solution (all rows of a net fit, no load yet). If that has no answer,
  /// bodies are free to jump here: then the solution a little further on shows the way, provided
  /// that it reaches back to this t.
  bool turn() {
    const std::vector<bool> before = matrix_.closed();
    std::vector<int> taking_part;
    const ContactSolution direction = solve_direction(taking_part);
    if (direction.status == ContactStatus::solved) {
      std::vector<bool> closed(std::size_t(rows()), false);
      for (const int k : direction.basis) {
        closed[std::size_t(taking_part[std::size_t(k)])] = true;
      }
      return take(closed) || begin(before);
    }
    const base::Vector f = at(v_, d_, t_).tail(problem_.f0.size());
    base::Vector unheld;
    for (const double step : look_ahead) {
      const ContactSolution next = solve_at(t_ + step * (to_ - from_), before);
      unheld = next.unheld;
      if (next.status != ContactStatus::solved) {
        continue;
      }
      std::vector<bool> closed(std::size_t(rows()), false);
      for (const int i : next.basis) {
        closed[std::size_t(i)] = true;
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

  bool take(const std::vector<bool>& closed) {
    const PathStatus before = path_.status;
    if (begin(closed)) {
      mark();
      return true;
    }
    path_.status = before;
    return false;
  }

  /// Whether the closed rows are right at t already, with the same functionals f.
  [[nodiscard]] bool reaches_back(const base::Vector& f) const {
    for (int i = 0; i < rows(); ++i) {
      if (free_to_change(i) && y(i) < -1e3 * tolerance_(i)) {
        return false;
      }
    }
    const base::Vector now = at(v_, d_, t_).tail(f.size());
    const double size =
        (now.cwiseAbs() + (to_ - from_) * d_.tail(f.size()).cwiseAbs() + f.cwiseAbs()).sum();
    return f.size() == 0 || (now - f).cwiseAbs().maxCoeff() <= 1e-8 * size;
  }

  /// Closed rows that press are equalities, open rows with a gap stay out, the others choose.
  ContactSolution solve_direction(std::vector<int>& taking_part) const {
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
    const ContactProblem rate = rate_problem(problem_, taking_part, pressing, to_ - from_);
    return solve_contact(rate, settings_.start, start);
  }

  void walk() {
    int here = 0; // pivots at this t
    for (;;) {
      const int i = first_bad();
      if (i >= 0 && here == 0 && tied() > tied_rows) {
        here = 1;
        const double t = t_;
        if ((matrix_.pivots() > 0 && !refresh()) || (t_ == t && !turn())) {
          return;
        }
        continue;
      }
      if (i >= 0) {
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

  /// At the end: whether the equations hold; if not, the walk has gone back to its last mark.
  bool settled() {
    if (sound()) {
      return true;
    }
    return !go_back();
  }

  /// Least row at zero whose force or gap falls.
  [[nodiscard]] int first_bad() const {
    for (int i = 0; i < rows(); ++i) {
      if (free_to_change(i) && zero(i) && falls(i)) {
        return i;
      }
    }
    return -1;
  }

  [[nodiscard]] double time_of(int i) const { return t_ + std::max(y(i), 0.0) / -d_(i); }

  [[nodiscard]] double next_event() const {
    double t = to_;
    for (int i = 0; i < rows(); ++i) {
      if (free_to_change(i) && falls(i)) {
        t = std::min(t, time_of(i));
      }
    }
    return t;
  }

  /// Rows that will soon be exchanged, as things stand.
  [[nodiscard]] std::vector<int> likely() const {
    std::vector<std::pair<double, int>> order;
    for (int i = 0; i < rows(); ++i) {
      if (free_to_change(i) && falls(i) && time_of(i) <= to_) {
        order.emplace_back(time_of(i), i);
      }
    }
    const auto count = std::min(together, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                      order.end());
    std::vector<int> out;
    for (std::size_t k = 0; k < count; ++k) {
      out.push_back(order[k].second);
    }
    return out;
  }

  base::Vector column(int i) {
    return matrix_.column(i, matrix_.made(i) ? std::vector<int>() : likely());
  }

  /// Exchanges row i, alone if it has a pivot, else with the row that blocks it.
  bool change(int i) {
    if (matrix_.pivots() >= 2 * interval_ && !refresh()) {
      return false;
    }
    base::Vector x = column(i);
    if (x(i) < 1e3 * no_pivot && matrix_.pivots() > 0) {
      // round-off of the list must not decide
      return refresh();
    }
    const std::array<base::Vector*, 2> states{&v_, &d_};
    ++path_.pivots;
    if (x(i) > no_pivot) {
      matrix_.pivot(i, std::move(x), states);
      return true;
    }
    const int j = blocking(x, i);
    if (j < 0) {
      return no_way_on(i, x);
    }
    if (closed(i) && y(j) > 1e3 * tolerance_(j)) {
      path_.jumps.push_back(t_);
    }
    base::Vector partner = column(j);
    matrix_.pivot({i, j}, {std::move(x), std::move(partner)}, states);
    return true;
  }

  /// The first row that reaches zero when z_i grows at this t.
  [[nodiscard]] int blocking(const base::Vector& x, int i) const {
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

  /// z_i grows without end: an opening row sets a mode free, a closing one meets equality rows.
  bool no_way_on(int i, const base::Vector& x) {
    if (!closed(i)) {
      return stop(PathStatus::inconsistent);
    }
    path_.unheld = split_.felt * matrix_.modes(x);
    const double norm = path_.unheld.norm();
    if (norm > 0.0) {
      path_.unheld /= norm;
    }
    return stop(PathStatus::unheld_mode);
  }

  void emit(double t1) {
    const auto f = problem_.f0.size();
    if (t1 > t_ || path_.segments.empty()) {
      const std::vector<bool>& now = matrix_.closed();
      if (path_.segments.empty()) {
        path_.closed = now;
      } else {
        for (int i = 0; i < rows(); ++i) {
          if (now[std::size_t(i)] != reported_[std::size_t(i)]) {
            path_.changes.push_back({path_.segments.size(), i, now[std::size_t(i)]});
          }
        }
      }
      reported_ = now;
      path_.segments.push_back({t_, t1, at(v_, d_, t_).tail(f), d_.tail(f)});
    }
    t_ = t1;
  }

  /// Whether forces and gaps satisfy the equations they came from: gaps b + W lambda + B alpha and
  /// the loads on the modes, scaled.
  bool sound() {
    HeldProblem here = held_;
    here.b += t_ * problem_.db;
    here.h += t_ * dh_;
    const base::Vector ends = (held_.h + from_ * dh_).cwiseAbs() + (held_.h + to_ * dh_).cwiseAbs();
    const double worst = path_residual(here, matrix_, at(v_, d_, t_), {size_, level_, ends});
    const bool good = worst <= settings_.allowed_drift;
    if (good) {
      path_.residual = std::max(path_.residual, worst);
    }
    return good;
  }

  /// Checks the equations and factorises afresh.
  bool refresh() {
    if (!sound()) {
      return go_back();
    }
    if (!begin(std::vector<bool>(matrix_.closed()))) {
      return false;
    }
    mark();
    return true;
  }

  void mark() {
    mark_ = {t_, matrix_.closed(), reported_, path_.segments.size(), path_.changes.size()};
  }

  /// What was found since the last factorisation is walked again with fewer pivots at a time.
  bool go_back() {
    t_ = mark_.t;
    reported_ = mark_.reported;
    path_.segments.resize(mark_.segments);
    path_.changes.resize(mark_.changes);
    std::erase_if(path_.jumps, [&](double t) { return t >= t_; });
    if (interval_ <= shortest_list) {
      return stop(PathStatus::drift);
    }
    interval_ = std::max(shortest_list, interval_ / 4);
    return begin(mark_.closed);
  }

  const ParametricProblem& problem_;
  const ModeSplit& split_;
  const PathSettings& settings_;
  HeldProblem held_;
  base::Vector dh_;
  SweptMatrix matrix_;
  double t_, from_, to_;
  int interval_;
  base::Vector v_, d_;                                    ///< y(t) = v + t d
  double size_ = 0.0;                                     ///< of forces, in units of y
  base::Vector level_ = base::Vector::Zero(held_.rows()); ///< [n] of given gaps, in units of y
  base::Vector tolerance_;                                ///< [n]
  std::vector<bool> reported_;                            ///< [n] closed rows of the last segment
  Mark mark_;
  SolutionPath path_;
};

/// Modes that no row feels must not be loaded anywhere on the path.
base::Vector unfelt_on_path(const ParametricProblem& problem, const ModeSplit& split, double from,
                            double to) {
  const base::Vector first = problem.at_zero.h + from * problem.dh;
  const base::Vector last = problem.at_zero.h + to * problem.dh;
  double scale = problem.at_zero.load_scale;
  for (const base::Vector* h : {&first, &last}) {
    scale = h->size() > 0 ? std::max(scale, h->cwiseAbs().maxCoeff()) : scale;
  }
  return unfelt_motion(split, last, rest_load * scale);
}

} // namespace

SolutionPath follow_path(const ParametricProblem& problem, double from, double to,
                         const PathSettings& settings, const std::vector<bool>& start) {
  assert(to > from);
  blas::single_thread();
  const ModeSplit split = split_modes(problem.at_zero.B, problem.at_zero.opening_scale);
  const base::Vector unfelt = unfelt_on_path(problem, split, from, to);
  if (unfelt.size() > 0) {
    SolutionPath path;
    path.status = PathStatus::unheld_mode;
    path.unheld = unfelt;
    path.end = from;
    return path;
  }
  return Walk(problem, split, from, to, settings).run(start);
}

} // namespace spricka::solve
