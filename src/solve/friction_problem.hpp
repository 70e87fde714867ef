// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/contact_problem.hpp"

#include <vector>

namespace spricka::solve {

/// A normal row of a contact problem, the row of its slip, and Coulomb's coefficient between them.
struct FrictionRow {
  int normal = 0;
  int tangent = 0;
  double mu = 0.0;
};

/// One increment with Coulomb friction: the contact problem, where the rows named by `friction`
/// obey
///   |lambda_t| <= mu lambda_n,   v = 0 where it is less,   v lambda_t <= 0,
/// and v = b_t + (W lambda + B alpha)_t is the slip since the last increment. Friction rows are
/// inequality rows, their tangents are not among the equality rows (manual, solve.21).
struct FrictionProblem {
  ContactProblem contact;
  std::vector<FrictionRow> friction;
  base::Vector alpha_start; ///< [m] where bodies that nothing holds or loads stay; empty: zero
};

/// What a row does: forward slip is positive, against a negative force.
enum class Touch : char { open, stick, forward, backward };

struct FrictionSolution {
  ContactSolution contact;  ///< `closed` of tangents is that of their normals
  std::vector<Touch> touch; ///< [n] open or stick on rows without friction
  bool slides = false;      ///< the unheld mode is held by friction until it is overcome
};

} // namespace spricka::solve
