// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/friction_problem.hpp"
#include "solve/held_problem.hpp"

#include <array>
#include <vector>

namespace spricka::solve {

/// The friction problem with round cones, in units where a normal row's own compliance is about 1;
/// the tangents of a unit have the unit of its normal, so that cones stay round. Forces times d,
/// gaps over d, modes over sqrt(tau).
struct RoundConeFrictionProblem {
  struct RoundFrictionUnit { ///< an inequality row, with the rows of its slip if there is friction
    int normal = 0;
    int tangents = 0; ///< 0 to 2
    std::array<int, 2> tangent{};
    double mu = 0.0;
  };
  base::Matrix W;       ///< [n, n]
  base::Matrix B;       ///< [n, m]
  base::Vector b;       ///< [n]
  base::Vector h;       ///< [m]
  base::Vector inverse; ///< [n] 1 / d
  std::vector<RoundFrictionUnit> units;
  std::vector<int> fixed; ///< equality rows
  double force_floor = 0.0;

  [[nodiscard]] Eigen::Index rows() const { return b.size(); }
  [[nodiscard]] Eigen::Index mode_count() const { return h.size(); }
};
/// The problem in these units. Rows without compliance become no units; slip rows take the scale of
/// their normal rows.
RoundConeFrictionProblem scale_round_friction_problem(const ControllableProblem& held,
                                                      const std::vector<FrictionRow>& friction,
                                                      double load_scale);

/// An answer, or the last thing tried.
struct RoundFrictionState {
  base::Vector lambda;          ///< [n]
  base::Vector alpha;           ///< [m]
  base::Vector gap;             ///< [n] b + W lambda + B alpha
  std::vector<SlipState> touch; ///< [unit] open, stick, or forward where it slips, whichever way
  double residual = 0.0;        ///< largest violation of a condition, scaled
  int newton_steps = 0;
  int sweeps = 0;
};

inline constexpr double near_enough = 1e-9; ///< a residual that asks for no other attempt

/// Where an increment begins.
struct RoundFrictionStart {
  base::Vector alpha;               ///< [m]
  base::Vector expected = {};       ///< [n] forces near the answer; empty: nothing is known
  base::Vector expected_alpha = {}; ///< [m] motions that go with them
};

/// Solves an increment (solve.35): sweeps of one contact point after the other (Jean and Moreau
/// 1992) to come near, and a semi-smooth Newton method on the projection onto the cones (Alart and
/// Curnier 1991) to arrive; alone that may cycle, then it begins anew from more sweeps. Motions
/// that nothing holds stay where `alpha` has them. Expected forces are tried first: near the answer
/// Newton needs no sweeps and fewer steps.
RoundFrictionState solve_round_friction(const RoundConeFrictionProblem& problem,
                                        const RoundFrictionStart& start);

/// Newton's method of it alone, at most so many steps and until the residual is small enough; with
/// none, the gaps, states and residual of these forces and motions.
RoundFrictionState iterate_round_friction_newton(const RoundConeFrictionProblem& problem,
                                                 const PredictedContactForces& near, int most,
                                                 double enough);

} // namespace spricka::solve
