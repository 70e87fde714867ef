// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/friction_cones.hpp"
#include "base/index.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace spricka::solve {

using base::at;
using base::index;

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

// Edges of round cones: of a many-sided cone about each, which holds whatever the round one holds.
// The two tangents become its first two edges, the others are rows behind all others.
base::Matrix round_edges(const base::Matrix& B, const std::vector<FrictionRow>& friction) {
  constexpr int sides = 16;
  const double out = 1.0 / std::cos(std::numbers::pi / sides);
  base::Matrix edges(B.rows() + (sides - 3) * index(friction.size()), B.cols());
  edges.topRows(B.rows()) = B;
  Eigen::Index more = B.rows();
  for (const FrictionRow& f : friction) {
    if (f.second < 0) {
      edges.row(f.normal) = B.row(f.normal) + f.mu * B.row(f.tangent);
      edges.row(f.tangent) = B.row(f.normal) - f.mu * B.row(f.tangent);
      continue;
    }
    for (int k = 0; k < sides; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / sides;
      const Eigen::Index r = k == 0 ? f.normal : k == 1 ? f.tangent : k == 2 ? f.second : more++;
      edges.row(r) =
          B.row(f.normal) +
          out * f.mu * (std::cos(angle) * B.row(f.tangent) + std::sin(angle) * B.row(f.second));
    }
  }
  return edges.topRows(more);
}

} // namespace

HeldProblem cone_problem(const base::Matrix& B, const base::Vector& h,
                         const std::vector<bool>& equality,
                         const std::vector<FrictionRow>& friction) {
  static const base::Matrix none;
  if (has_round_cones(friction)) {
    base::Matrix edges = round_edges(B, friction);
    std::vector<bool> free = equality;
    free.resize(static_cast<std::size_t>(edges.rows()), false);
    const Eigen::Index n = edges.rows();
    return {.W = none,
            .B = std::move(edges),
            .b = base::Vector::Zero(n),
            .h = h,
            .equality = std::move(free),
            .tau = 0.0,
            .d = {}};
  }
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
