// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/friction_cones.hpp"
#include "base/index.hpp"

namespace spricka::solve {

using base::at;

namespace {

std::vector<FrictionRow> without_mu(std::vector<FrictionRow> friction) {
  for (FrictionRow& f : friction) {
    f.mu = 0.0;
  }
  return friction;
}

/// Edges of the cones as rows [n, m].
base::Matrix cone_edges(const base::Matrix& B, const std::vector<bool>& equality,
                        const std::vector<FrictionRow>& friction) {
  std::vector<int> normal_of(equality.size(), -1); // of tangents
  for (std::size_t f = 0; f < friction.size(); ++f) {
    normal_of[at(friction[f].tangent)] = static_cast<int>(f);
  }
  base::Matrix edges = B;
  for (std::size_t i = 0; i < equality.size(); ++i) {
    if (normal_of[i] < 0) {
      continue;
    }
    const FrictionRow& f = friction[at(normal_of[i])];
    edges.row(f.normal) = B.row(f.normal) + f.mu * B.row(f.tangent);
    edges.row(f.tangent) = B.row(f.normal) - f.mu * B.row(f.tangent);
  }
  return edges;
}

} // namespace

HeldProblem cone_problem(const base::Matrix& B, const base::Vector& h,
                         const std::vector<bool>& equality,
                         const std::vector<FrictionRow>& friction) {
  static const base::Matrix none;
  return {.W = none,
          .B = cone_edges(B, equality, friction),
          .b = base::Vector::Zero(B.rows()),
          .h = h,
          .equality = equality,
          .tau = 0.0,
          .d = {}};
}

base::Vector sliding_motion(const ModeSplit& split, const HeldProblem& held,
                            const std::vector<FrictionRow>& friction, const LoadBalance& balance) {
  // what the cones leave lifts the body off the rows it slides on: they keep it there
  std::vector<bool> kept = held.equality;
  for (const FrictionRow& f : friction) {
    kept[at(f.normal)] = true;
  }
  const LoadBalance level =
      balance_loads(cone_problem(held.B, balance.remainder, kept, without_mu(friction)));
  const bool lifts = !(level.remainder.norm() > 1e-9 * balance.remainder.norm());
  return opening_motion(split, lifts ? balance : level, 0.0);
}

} // namespace spricka::solve
