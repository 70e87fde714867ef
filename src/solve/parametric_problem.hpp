// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/contact_problem.hpp"

#include <vector>

namespace spricka::solve {

/// A contact problem whose gaps and loads are linear in t (manual, solve.28): b(t) = b + t db, h(t)
/// = h + t dh; and linear functionals of its solution, f(t) = f0 + t df + of_force lambda(t) +
/// of_mode alpha(t).
struct ParametricProblem {
  ContactProblem at_zero;
  base::Vector db;       ///< [n]
  base::Vector dh;       ///< [m]
  base::Matrix of_force; ///< [f, n]
  base::Matrix of_mode;  ///< [f, m]
  base::Vector f0, df;   ///< [f]
};

enum class PathStatus {
  complete,
  no_start,     ///< no solution at the first t: see `start_status`
  unheld_mode,  ///< from `end` on a loaded rigid mode is not held: nothing is extrapolated
  inconsistent, ///< from `end` on equality rows contradict each other
  unfinished,   ///< pivots came to no end
  drift         ///< round-off that a fresh factorisation did not cure
};

/// Between two breakpoints the closed rows stay, and everything is linear in t.
struct SolutionPathSegment {
  double from = 0.0, to = 0.0;
  base::Vector value; ///< [f] functionals at `from`
  base::Vector slope; ///< [f] by t
};

/// A row that closes or opens where a segment begins.
struct ActiveRowChange {
  std::size_t segment = 0;
  int row = 0;
  bool closes = false;
};

struct SolutionPath {
  PathStatus status = PathStatus::complete;
  ContactStatus start_status = ContactStatus::solved;
  double end = 0.0;         ///< how far the path is known
  std::vector<bool> closed; ///< [n] on the first segment
  std::vector<SolutionPathSegment> segments;
  std::vector<ActiveRowChange> changes; ///< by segment, then by row; none for the first segment
  base::Vector unheld;                  ///< [m] direction of the mode that is not held, else empty
  std::vector<double> jumps; ///< t at which a body that nothing held moved until it was stopped
  int pivots = 0;
  int factorisations = 0;
  double residual = 0.0; ///< largest violation of equations (scaled) wherever they were checked
};

struct SolutionPathSettings {
  ContactSettings start;
  int refactor = 250;       ///< pivots after which the closed rows are factorised afresh
  double tolerance = 1e-11; ///< of zero, over the scale of forces and gaps
  double allowed_drift = 1e-9;
};

} // namespace spricka::solve
