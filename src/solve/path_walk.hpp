// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/mode_split.hpp"
#include "solve/parametric_problem.hpp"
#include "solve/path_state.hpp"

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
        state_(problem, split, from, to, settings.tolerance), from_(from), to_(to),
        interval_(settings.refactor) {}

  /// From the solution at the first t to the end; once.
  SolutionPath follow_path(const std::vector<bool>& start);

private:
  /// More rows than this at zero that want to move: ask for the direction.
  static constexpr int tied_rows = 4;

  bool stop(PathStatus status);

  ContactSolution solve_at(double t, const std::vector<bool>& start) const;

  /// A clean factorisation for these closed rows, at the t where the walk stands.
  bool begin(const std::vector<bool>& closed);

  bool set_out();

  /// Many rows that tie are not exchanged one by one. They are a contact problem of their own, for
  /// the direction of the solution (all rows of a net fit, no load yet). If that has no answer,
  /// bodies are free to jump here: then the solution a little further on shows the way, provided
  /// that it reaches back to this t.
  bool turn();

  bool take(const std::vector<bool>& closed);

  void walk();

  /// At the end: whether the walk is over, as the equations hold or there is no way back; else it
  /// has gone back to its last mark.
  bool settled();

  /// Exchanges row i, alone if it has a pivot, else with the row that blocks it.
  bool change(int i);

  /// z_i grows without end: an opening row sets a mode free, a closing one meets equality rows.
  bool no_way_on(int i, const base::Vector& x);

  void emit(double t1);

  /// Whether forces and gaps satisfy the equations they came from.
  bool sound();

  /// Checks the equations and factorises afresh.
  bool refresh();

  void mark();

  /// What was found since the last factorisation is walked again with fewer pivots at a time.
  bool go_back();

  const ParametricProblem& problem_;
  const ModeSplit& split_;
  const SolutionPathSettings& settings_;
  PathState state_;
  double from_, to_;
  int interval_;
  std::vector<bool> reported_; ///< [n] closed rows of the last segment
  PathCheckpoint mark_;
  SolutionPath path_;
};

} // namespace spricka::solve
