// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/friction_rest.hpp"

#include "base/index.hpp"
#include "solve/rest.hpp"

#include <cmath>

namespace spricka::solve {

using base::at;

namespace {

constexpr double touching = 1e-10; // of the largest gap

// Forces [n] that rows can hold bodies with. Where supports keep a body from what its pressure
// would move, shear alone holds the rest of its motions, even if it is zero now.
base::Vector holding_forces(const RoundConeFrictionProblem& scaled, const base::Vector& lambda) {
  base::Vector forces = lambda.cwiseAbs();
  for (const RoundConeFrictionProblem::RoundFrictionUnit& u : scaled.units) {
    for (int t = 0; t < u.tangents; ++t) {
      forces[u.tangent[at(t)]] = u.mu * std::abs(lambda[u.normal]);
    }
  }
  return forces.cwiseProduct(scaled.inverse);
}

std::vector<AllowedGapChange> gap_changes(const ControllableProblem& held, const ModeSplit& split,
                                          const RoundConeFrictionProblem& scaled,
                                          const RoundFrictionState& found, double least) {
  const std::vector<bool> pressing =
      find_pressing_rows(held, split, holding_forces(scaled, found.lambda), least);
  std::vector<AllowedGapChange> change(pressing.size(), AllowedGapChange::any);
  for (const int i : scaled.fixed) {
    change[at(i)] = AllowedGapChange::none;
  }
  for (std::size_t k = 0; k < scaled.units.size(); ++k) {
    const RoundConeFrictionProblem::RoundFrictionUnit& u = scaled.units[k];
    bool holds = pressing[at(u.normal)];
    for (int t = 0; t < u.tangents; ++t) {
      holds = holds || pressing[at(u.tangent[at(t)])];
    }
    holds = holds && found.touch[k] != SlipState::open;
    change[at(u.normal)] = holds ? AllowedGapChange::none : AllowedGapChange::not_through_zero;
    for (int t = 0; t < u.tangents; ++t) {
      change[at(u.tangent[at(t)])] = holds ? AllowedGapChange::none : AllowedGapChange::any;
    }
  }
  return change;
}

} // namespace

int move_unheld_bodies_to_anchor(const ControllableProblem& held, const ModeSplit& split,
                                 const RoundConeFrictionProblem& scaled, const base::Vector& anchor,
                                 double least, RoundFrictionState& found) {
  const double root = std::sqrt(held.tau);
  const std::vector<AllowedGapChange> change = gap_changes(held, split, scaled, found, least);
  base::Vector alpha = found.alpha * root;
  const int free = minimise_free_motions(held, split, found.lambda.cwiseProduct(scaled.inverse),
                                         change, anchor * root, alpha);
  if (free == 0) {
    return 0;
  }
  const base::Vector moved = alpha / root - found.alpha;
  found.gap += scaled.B * moved;
  found.alpha += moved;
  const double least_gap = touching * found.gap.cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < scaled.units.size(); ++k) {
    const int normal = scaled.units[k].normal;
    if (change[at(normal)] != AllowedGapChange::none && found.gap[normal] > least_gap) {
      found.touch[k] = SlipState::open;
    }
  }
  return free;
}

} // namespace spricka::solve
