// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/index.hpp"
#include "solve/held_problem.hpp"
#include "solve/mode_split.hpp"
#include "solve/parametric_problem.hpp"
#include "solve/swept_matrix.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace spricka::solve {

/// A scaled diagonal below this is no pivot.
inline constexpr double no_pivot = 1e-9;

/// Forces, gaps and functionals of a path, y(t) = v + t d, by a swept matrix, at the t where the
/// path stands; on controllable modes.
class PathState {
public:
  /// `problem` must outlive it. `tolerance`: of y, relative.
  PathState(const ParametricProblem& problem, const ModeSplit& split, double from, double to,
            double tolerance)
      : problem_(problem), held_(restrict_to_controllable_modes(problem.at_zero, split)),
        dh_(split.controllable.transpose() * problem.dh),
        matrix_(held_, problem.of_force, problem.of_mode * split.controllable), t_(from),
        from_(from), to_(to), relative_tolerance_(tolerance) {}

  /// For these closed rows, at t; false: they do not hold all modes, or some are redundant.
  bool factorise(const std::vector<bool>& closed);
  [[nodiscard]] int pivots() const { return matrix_.pivots(); } ///< since then
  [[nodiscard]] double parameter() const { return t_; }
  void set_parameter(double t) { t_ = t; }

  [[nodiscard]] int rows() const { return held_.rows(); }
  [[nodiscard]] bool is_inequality_row(int i) const { return !held_.equality[base::at(i)]; }
  [[nodiscard]] const std::vector<bool>& closed() const { return matrix_.closed(); } ///< [row]
  [[nodiscard]] bool closed(int i) const { return closed()[base::at(i)]; }
  [[nodiscard]] double force_or_gap(int i) const { return v_(i) + t_ * d_(i); }
  [[nodiscard]] double tolerance(int i) const { return tolerance_(i); }
  [[nodiscard]] bool is_at_zero(int i) const { return force_or_gap(i) <= tolerance_(i); }
  [[nodiscard]] base::Vector functionals() const { return state().tail(problem_.f0.size()); }
  [[nodiscard]] base::Vector functional_rates() const { return d_.tail(problem_.f0.size()); }

  /// How many rows at zero want to move.
  [[nodiscard]] int count_falling_rows_at_zero() const;
  /// Least row at zero whose force or gap falls; -1: none.
  [[nodiscard]] int first_falling_row_at_zero() const;
  /// The t at which the first row reaches zero, the end of the path at most (manual, solve.31).
  [[nodiscard]] double parameter_of_next_event() const;
  /// Whether the closed rows are right at t already, with the same functionals f.
  [[nodiscard]] bool is_valid_with_same_functionals(const base::Vector& f) const;
  /// Largest violation of the equations that forces and gaps came from, scaled: gaps
  /// b + W lambda + B alpha and the loads on the modes.
  [[nodiscard]] double residual() const;

  /// Column of the matrix at row i.
  base::Vector column(int i);
  /// The modes of a column, in the problem's own units.
  [[nodiscard]] base::Vector mode_amplitudes(const base::Vector& x) const {
    return matrix_.mode_amplitudes(x);
  }
  /// The first row that reaches zero when z_i grows at this t; -1: none. `x`: column i.
  [[nodiscard]] int first_blocking_row(const base::Vector& x, int i) const;
  /// Exchanges a row, or two at once, by their columns.
  void pivot(int i, const base::Vector& x);
  void pivot(std::array<int, 2> rows, std::array<base::Vector, 2> columns);

private:
  [[nodiscard]] base::Vector state() const { return v_ + t_ * d_; }
  /// Rates that would not leave the tolerance on the whole path are none.
  [[nodiscard]] bool falls(int i) const { return d_(i) * (to_ - from_) < -tolerance_(i); }
  [[nodiscard]] double time_of(int i) const { return t_ + std::max(force_or_gap(i), 0.0) / -d_(i); }
  /// Rows that will soon be exchanged, as things stand.
  [[nodiscard]] std::vector<int> likely() const;

  const ParametricProblem& problem_;
  ControllableProblem held_;
  base::Vector dh_;
  SweptMatrix matrix_;
  double t_, from_, to_, relative_tolerance_;
  base::Vector v_, d_;                                    ///< y(t) = v + t d
  double size_ = 0.0;                                     ///< of forces, in units of y
  base::Vector level_ = base::Vector::Zero(held_.rows()); ///< [n] of given gaps, in units of y
  base::Vector tolerance_;                                ///< [n]
};

} // namespace spricka::solve
