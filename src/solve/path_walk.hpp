// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/index.hpp"
#include "solve/held_problem.hpp"
#include "solve/mode_split.hpp"
#include "solve/parametric_problem.hpp"
#include "solve/swept_matrix.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace spricka::solve {

/// A state to return to: the path as it was when the matrix was last factorised.
struct PathCheckpoint {
  double t = 0.0;
  std::vector<bool> closed, reported;
  std::size_t segments = 0, changes = 0;
};

/// The walk along one path: follow_solution_path on its controllable modes. Functions that return
/// bool return false when the walk is over.
class SolutionPathFollower {
public:
  SolutionPathFollower(const ParametricProblem& problem, const ModeSplit& split, double from,
                       double to, const SolutionPathSettings& settings)
      : problem_(problem), split_(split), settings_(settings),
        held_(restrict_to_controllable_modes(problem.at_zero, split)),
        dh_(split.controllable.transpose() * problem.dh),
        matrix_(held_, problem.of_force, problem.of_mode * split.controllable), t_(from),
        from_(from), to_(to), interval_(settings.refactor) {}

  /// From the solution at the first t to the end; once.
  SolutionPath run(const std::vector<bool>& start);

private:
  /// More rows than this at zero that want to move: ask for the direction.
  static constexpr int tied_rows = 4;

  [[nodiscard]] int rows() const { return held_.rows(); }
  [[nodiscard]] bool free_to_change(int i) const { return !held_.equality[base::at(i)]; }
  [[nodiscard]] bool closed(int i) const { return matrix_.closed()[base::at(i)]; }
  [[nodiscard]] double y(int i) const { return v_(i) + t_ * d_(i); }
  [[nodiscard]] base::Vector state() const { return v_ + t_ * d_; }
  [[nodiscard]] bool zero(int i) const { return y(i) <= tolerance_(i); }
  /// Rates that would not leave the tolerance on the whole path are none.
  [[nodiscard]] bool falls(int i) const { return d_(i) * (to_ - from_) < -tolerance_(i); }
  bool stop(PathStatus status);

  ContactSolution solve_at(double t, const std::vector<bool>& start) const;

  /// A clean factorisation for these closed rows, at the t where the walk stands.
  bool begin(const std::vector<bool>& closed);

  bool set_out();

  /// Rows at zero that want to move.
  [[nodiscard]] int tied() const;

  /// Many rows that tie are not exchanged one by one. They are a contact problem of their own, for
  /// the direction of the solution (all rows of a net fit, no load yet). If that has no answer,
  /// bodies are free to jump here: then the solution a little further on shows the way, provided
  /// that it reaches back to this t.
  bool turn();

  bool take(const std::vector<bool>& closed);

  /// Whether the closed rows are right at t already, with the same functionals f.
  [[nodiscard]] bool reaches_back(const base::Vector& f) const;

  /// Closed rows that press are equalities, open rows with a gap stay out, the others choose.
  ContactSolution solve_direction(std::vector<int>& taking_part) const;

  void walk();

  /// At the end: whether the walk is over, as the equations hold or there is no way back; else it
  /// has gone back to its last mark.
  bool settled();

  /// Least row at zero whose force or gap falls.
  [[nodiscard]] int first_bad() const;

  [[nodiscard]] double time_of(int i) const { return t_ + std::max(y(i), 0.0) / -d_(i); }

  /// (manual, solve.31)
  [[nodiscard]] double next_event() const;

  /// Rows that will soon be exchanged, as things stand.
  [[nodiscard]] std::vector<int> likely() const;

  base::Vector column(int i);

  /// Exchanges row i, alone if it has a pivot, else with the row that blocks it.
  bool change(int i);

  /// The first row that reaches zero when z_i grows at this t.
  [[nodiscard]] int blocking(const base::Vector& x, int i) const;

  /// z_i grows without end: an opening row sets a mode free, a closing one meets equality rows.
  bool no_way_on(int i, const base::Vector& x);

  void emit(double t1);

  /// Whether forces and gaps satisfy the equations they came from: gaps b + W lambda + B alpha and
  /// the loads on the modes, scaled.
  bool sound();

  /// Checks the equations and factorises afresh.
  bool refresh();

  void mark();

  /// What was found since the last factorisation is walked again with fewer pivots at a time.
  bool go_back();

  const ParametricProblem& problem_;
  const ModeSplit& split_;
  const SolutionPathSettings& settings_;
  ControllableProblem held_;
  base::Vector dh_;
  SweptMatrix matrix_;
  double t_, from_, to_;
  int interval_;
  base::Vector v_, d_;                                    ///< y(t) = v + t d
  double size_ = 0.0;                                     ///< of forces, in units of y
  base::Vector level_ = base::Vector::Zero(held_.rows()); ///< [n] of given gaps, in units of y
  base::Vector tolerance_;                                ///< [n]
  std::vector<bool> reported_;                            ///< [n] closed rows of the last segment
  PathCheckpoint mark_;
  SolutionPath path_;
};

} // namespace spricka::solve
