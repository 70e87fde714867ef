// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/held_problem.hpp"
#include "solve/parametric_problem.hpp"
#include "solve/swept_matrix.hpp"

#include <vector>

/// Pieces of follow_solution_path.
namespace spricka::solve {

/// The contact problem for the direction of a path by t: of these rows, those that press are
/// equalities, the others may close or open. `length` of the path, to scale the loads.
ContactProblem path_direction_problem(const ParametricProblem& problem,
                                      const std::vector<int>& rows,
                                      const std::vector<bool>& pressing, double length);

/// What violations are measured by.
struct PathResidualScale {
  double size = 0.0;         ///< of forces, in units of y
  const base::Vector& level; ///< [n] of given gaps, in units of y
  const base::Vector& load;  ///< [m] on the modes
};

/// Largest violation of g = b + W lambda + B alpha, h + B^T lambda = 0 and of signs by a state of
/// the swept matrix, scaled; `problem` holds b and h of the state's t.
double path_residual(const ControllableProblem& problem, const SweptMatrix& matrix,
                     const base::Vector& state, const PathResidualScale& scale);

} // namespace spricka::solve
