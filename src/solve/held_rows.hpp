// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/bordered_factor.hpp"
#include "solve/contact_problem.hpp"
#include "solve/held_problem.hpp"
#include "solve/mode_split.hpp"

#include <functional>

namespace spricka::solve {

/// Contact rows that are held whatever the sign of their forces, factorised once (manual,
/// sensitivity.3): W lambda + B alpha = -b, B^T lambda = -h.
class ClosedRowsSolver {
public:
  /// What forces of the rows [n, k] open them by: W lambda [n, k].
  using RowOpenings = std::function<base::Matrix(const base::Matrix&)>;
  /// W and B of `rows` for all its rows; its b and h are left aside. W is not kept, its products
  /// are those of `openings`.
  ClosedRowsSolver(ContactProblem rows, RowOpenings openings);
  ClosedRowsSolver(const ClosedRowsSolver&) = delete;
  ClosedRowsSolver& operator=(const ClosedRowsSolver&) = delete;

  /// Whether there is an answer; redundant rows are left out and have no force.
  [[nodiscard]] bool is_solvable() const { return ok_; }

  struct ClosedRowsResponse {
    base::Matrix lambda;    ///< [n, k]
    base::Matrix alpha;     ///< [m, k] modes; uncontrollable motions rest
    double left_over = 0.0; ///< largest load on uncontrollable motions
  };
  /// The response to gaps b [n, k] and loads h [m, k] on the modes; only where is_solvable().
  [[nodiscard]] ClosedRowsResponse response_to_gaps_and_loads(const base::Matrix& b,
                                                              const base::Matrix& h) const;
  /// The largest of loads h [m, k] on uncontrollable motions.
  [[nodiscard]] double uncontrollable_load(const base::Matrix& h) const;

private:
  ContactProblem rows_;
  RowOpenings openings_;
  ModeSplit split_;
  ControllableProblem held_;
  BorderedFactor factor_;
  bool ok_ = false;
};

} // namespace spricka::solve
