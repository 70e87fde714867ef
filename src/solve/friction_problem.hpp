// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/contact_problem.hpp"

#include <algorithm>
#include <vector>

namespace spricka::solve {

/// A normal row of a contact problem, the row of its slip, and Coulomb's coefficient between them.
/// In space there may be a second row across the first: then the two are a vector.
struct FrictionRow {
  int normal = 0;
  int tangent = 0;
  double mu = 0.0;
  int second = -1; ///< -1: none
};

/// Whether slips are vectors somewhere: cones are round then (solve.35).
inline bool has_round_cones(const std::vector<FrictionRow>& friction) {
  return std::ranges::any_of(friction, [](const FrictionRow& f) { return f.second >= 0; });
}

/// Near the answer of an increment, as those before it tell; empty: nothing is known.
struct PredictedContactForces {
  base::Vector lambda; ///< [n]
  base::Vector alpha;  ///< [m]
};

/// One increment with Coulomb friction: the contact problem, where the rows named by `friction`
/// obey
///   |lambda_t| <= mu lambda_n,   v = 0 where it is less,   v lambda_t <= 0,
/// and v = b_t + (W lambda + B alpha)_t is the slip since the last increment; two tangents make
/// vectors of lambda_t and v, of which |lambda_t| counts, and lambda_t points against v. Friction
/// rows are inequality rows, their tangents are not among the equality rows (manual, solve.21).
struct FrictionProblem {
  ContactProblem contact;
  std::vector<FrictionRow> friction;
  base::Vector alpha_start; ///< [m] where bodies that nothing holds or loads stay; empty: zero
  PredictedContactForces expected = {}; ///< round cones alone ask for them
};

/// What a row does: forward slip is positive, against a negative force; a vector slips forward.
enum class SlipState : char { open, stick, forward, backward };

struct FrictionSolution {
  ContactSolution contact;      ///< `closed` of tangents is that of their normals
  std::vector<SlipState> touch; ///< [n] open or stick on rows without friction
  bool slides = false;          ///< the unheld mode is held by friction until it is overcome
};

} // namespace spricka::solve
