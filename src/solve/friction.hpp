// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/contact_qp.hpp"

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

/// Solves an increment from the states `start` (empty: all stick): a semi-smooth Newton method on
/// the four states, and where that does not settle Lemke's pivoting with lexicographic ties
/// (Lemke 1965; Cottle, Pang and Stone 1992, section 4.9) on the condensed problem. The answer's
/// residual is that of all conditions; without one the status says why.
FrictionSolution solve_friction(const FrictionProblem& problem, const ContactSettings& settings,
                                const std::vector<Touch>& start);

/// The cones of all forces that rows can give, by their edges: rows with friction become
/// normal +- mu tangent, so that any force is a sum of edges with coefficients >= 0 (equality rows:
/// of any sign).
struct FrictionCones {
  base::Matrix B; ///< [n, m] what a unit of each edge gives the modes
  std::vector<bool> equality;
};
FrictionCones friction_cones(const base::Matrix& B, const std::vector<bool>& equality,
                             const std::vector<FrictionRow>& friction);

struct HeldProblem;
struct ModeSplit;
struct Holding;

/// The motion [m] in which bodies slide, from what the cones cannot hold (`holding`): along rows,
/// not off them.
base::Vector sliding_motion(const ModeSplit& split, const HeldProblem& held,
                            const std::vector<FrictionRow>& friction, const Holding& holding);

/// Whether a sufficient test finds that an increment has one solution whatever its loads and gaps
/// (manual, solve.27).
struct Uniqueness {
  bool certain = false;
  bool apart_from_motions = false; ///< rigid motions of bodies were left out of the test
};
Uniqueness unique_increment(const FrictionProblem& problem);

} // namespace spricka::solve
