// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <vector>

namespace spricka::solve {

/// The contact problem in forces and rigid modes (mixed linear complementarity problem):
///   g = b + W lambda + B alpha,   0 = h + B^T lambda,
///   inequality rows: g >= 0, lambda >= 0, lambda g = 0;   equality rows: g = 0, lambda free.
/// W [n, n] is the compliance of the constraint rows (symmetric, positive semidefinite), B [n, m]
/// what a unit of each rigid mode opens, h [m] the generalised loads on the modes. It is the
/// optimality system of the convex QP  min 1/2 u^T S u - f^T u  subject to  G u >= -g0.
struct ContactProblem {
  base::Matrix W;
  base::Matrix B;
  base::Vector b;
  base::Vector h;
  std::vector<bool> equality; ///< [n]
  double load_scale = 0.0;    ///< a typical force of the model, to judge h; 0: from the data
  double opening_scale =
      0.0; ///< a typical opening by a unit of a mode, to judge B; 0: largest of B
};

/// Largest residual of a solution, over its scale; above it there is no answer.
inline constexpr double accepted_residual = 1e-7;

/// A value over its scale; scales are zero where nothing acts, and then only zero is right.
inline double divide_by_scale(double value, double scale) {
  return value == 0.0 ? 0.0 : value / (scale > 0.0 ? scale : 1.0);
}

enum class ContactStatus {
  solved,
  unheld_mode,  ///< a loaded rigid mode that the contact cannot hold
  inconsistent, ///< equality rows contradict each other
  max_iterations
};

struct ContactSolution {
  ContactStatus status = ContactStatus::solved;
  base::Vector lambda;      ///< [n] >= 0 on inequality rows
  base::Vector alpha;       ///< [m] rigid modes; uncontrollable ones rest (minimum norm)
  base::Vector gap;         ///< [n]
  std::vector<bool> closed; ///< [n] rows that hold; redundant ones are not among them
  std::vector<int> basis; ///< independent rows that span all controllable modes: closed, or at rest
  base::Vector unheld;    ///< [m] direction of the mode that is not held, else empty
  int resting_modes = 0;  ///< number of motions that no row stops and no load drives
  double left_over = 0.0; ///< load on them over the load scale, at most resting_load
  int redundant = 0;      ///< number of rows left out because they depend on others
  int block_iterations = 0;
  int pivots = 0;        ///< of the finite fallback
  double residual = 0.0; ///< largest violation of the conditions above, scaled
};

struct ContactSettings {
  int max_block_iterations = 60;
  int max_pivots = 100000;
  double tolerance = 1e-11; ///< scaled, on signs of gap and force
};

} // namespace spricka::solve
