// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/friction_problem.hpp"
#include "solve/held_problem.hpp"

#include <vector>

namespace spricka::solve {

/// The friction problem in units where every row's own compliance is about 1: forces times d, gaps
/// over d. Modes over sqrt(tau).
struct ScaledFrictionProblem {
  struct FrictionUnit { ///< an inequality row, with the row of its slip if there is friction
    int normal = 0;
    int tangent = -1;
    double mu = 0.0; ///< in these units
  };
  base::Matrix W; ///< [n, n]
  base::Matrix B; ///< [n, m]
  base::Vector b; ///< [n]
  base::Vector h; ///< [m]
  std::vector<FrictionUnit> units;
  std::vector<int> fixed; ///< equality rows
  double force_floor = 0.0;

  [[nodiscard]] int rows() const { return static_cast<int>(b.size()); }
  [[nodiscard]] int mode_count() const { return static_cast<int>(h.size()); }
};

/// The problem in these units. Rows without compliance and modes are left out; a slip without them
/// has no force.
ScaledFrictionProblem scale_friction_problem(const ControllableProblem& held,
                                             const std::vector<FrictionRow>& friction,
                                             double load_scale);

/// Share of a row's own compliance that keeps redundant rows apart, and share of the bodies' that
/// anchors what no row holds; refinement takes both out of the answer again where it can.
inline constexpr double row_spring = 1e-12;
inline constexpr double mode_spring = 1e-8;

/// Forces, modes and gaps when the states of all rows are given.
struct SlipStateSolution {
  base::Vector lambda;  ///< [n]
  base::Vector alpha;   ///< [m]
  base::Vector gap;     ///< [n]
  bool regular = false; ///< the equations could be solved
  bool held = false;    ///< they hold without the anchoring springs
  double force_scale = 0.0;
  base::Vector gap_scale; ///< [n]
};

/// Solves the equations of the states `touch` [n]. Modes that these do not hold are anchored at
/// `anchor` [m] by weak springs.
SlipStateSolution solve_slip_states(const ScaledFrictionProblem& problem,
                                    const std::vector<SlipState>& touch,
                                    const base::Vector& anchor);

/// The states that follow from a solution: every row whose condition is violated by more than
/// `tolerance` changes. Returns how many did.
int update_slip_states(const ScaledFrictionProblem& problem, const SlipStateSolution& s,
                       double tolerance, std::vector<SlipState>& touch);

/// Largest violation of all conditions of the problem (springs do not count), scaled.
double friction_residual(const ScaledFrictionProblem& problem, const SlipStateSolution& s,
                         const std::vector<SlipState>& touch);

/// The interface in stiffness form, lambda = q + A x with the openings and slips x of all rows in
/// `rows` (those of the units, normals first), equality rows held, modes anchored.
struct InterfaceStiffness {
  std::vector<int> rows;
  base::Matrix A; ///< [k, k]
  base::Vector q; ///< [k]
  bool regular = false;
};
/// Eliminates forces and modes, so that openings and slips are what remains. `anchor` [m]: where
/// the modes' springs are at rest. Not regular where the equations are singular.
InterfaceStiffness interface_stiffness(const ScaledFrictionProblem& problem,
                                       const base::Vector& anchor);

} // namespace spricka::solve
