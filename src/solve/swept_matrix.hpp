// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/index.hpp"
#include "base/vec.hpp"
#include "solve/bordered_factor.hpp"
#include "solve/held_problem.hpp"
#include "solve/pivot_sequence.hpp"

#include <array>
#include <span>
#include <vector>

namespace spricka::solve {

/// The matrix [W B; B^T 0] of a contact problem swept on its closed rows and all modes (manual,
/// solve.29 and 30):
///   y = c + T z,
/// y_i the force of a closed row or the gap of an open one, z_i the other of the two; rows are in
/// units of d, so that all y have one unit. Below the n rows stand the modes [m] and further linear
/// functionals [f] of forces and modes. T is never formed: a column comes from one factorisation of
/// the closed rows and the list of pivots since then, each a column of its own (product form;
/// Murty 1988, chapter 2, on principal pivots).
class SweptMatrix {
public:
  /// of_force [f, n] and of_mode [f, m]: the functionals. `problem` must outlive the matrix.
  SweptMatrix(const ControllableProblem& problem, base::Matrix of_force, base::Matrix of_mode);

  /// Factorises for these closed rows and forgets all pivots. False: they do not hold all modes,
  /// or some are redundant.
  bool factorise_closed_rows(const std::vector<bool>& closed);
  [[nodiscard]] const std::vector<bool>& closed() const { return closed_; } ///< [n] at present
  /// How many pivots were made since the factorisation.
  [[nodiscard]] int pivots() const { return static_cast<int>(list_.size()); }
  [[nodiscard]] Eigen::Index size() const { return n_ + m_ + of_force_.rows(); }

  /// c [size] for gaps b [n] and loads h [m], right after the factorisation: no pivots must have
  /// been made.
  [[nodiscard]] base::Vector initial_state(const base::Vector& b, const base::Vector& h) const;
  /// Column i of T [size]. Columns of `likely` rows are made along with it.
  [[nodiscard]] base::Vector column(int i, std::span<const int> likely);
  /// Whether column i needs no solution with the factor any more.
  [[nodiscard]] bool has_column(int i) const { return made_[base::at(i)].size() > 0; }
  /// Exchanges y and z of row i, whose column is given, in the matrix and in states.
  void pivot(int i, const base::Vector& column, std::span<base::Vector* const> states);
  /// The same for two rows at once, of which neither need have a pivot alone.
  void pivot(std::array<int, 2> rows, std::array<base::Vector, 2> columns,
             std::span<base::Vector* const> states);

  /// Forces [n] and modes [m] of a state, in the problem's own units.
  [[nodiscard]] base::Vector forces(const base::Vector& state) const;
  /// The modes [m] of a state, in the problem's own units.
  [[nodiscard]] base::Vector mode_amplitudes(const base::Vector& state) const;
  /// Gaps [n] of open rows; zero for closed ones.
  [[nodiscard]] base::Vector open_gaps(const base::Vector& state) const;

private:
  void exchange(std::vector<int> rows, base::Matrix columns, std::span<base::Vector* const> states);
  void make_columns(const std::vector<int>& rows);
  [[nodiscard]] double unit(int i, bool closed) const;

  const ControllableProblem& problem_;
  Eigen::Index n_, m_;
  base::Matrix of_force_, of_mode_;
  BorderedFactor factor_;
  std::vector<bool> closed_, first_closed_; ///< now; when factorised
  std::vector<int> open_;                   ///< rows open when factorised
  base::Matrix W_open_;                     ///< [open, n]
  std::vector<base::Vector> made_;          ///< [n] columns, or empty
  std::vector<std::size_t> age_;            ///< [n] how many pivots a column has been through
  PivotSequence list_;
};

} // namespace spricka::solve
