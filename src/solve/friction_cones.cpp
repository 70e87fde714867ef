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

constexpr int sides = 16; // of what stands for a round cone

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

// Edges of round cones: of a many-sided cone each, about it (it holds whatever the round one holds)
// or, with `out` 1, within. The two tangents become its first two edges, the others are rows behind
// all others.
base::Matrix round_edges(const base::Matrix& B, const std::vector<FrictionRow>& friction,
                         double out) {
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

ControllableProblem problem_of_edges(base::Matrix edges, const base::Vector& h,
                                     std::vector<bool> equality) {
  static const base::Matrix none;
  equality.resize(static_cast<std::size_t>(edges.rows()), false);
  const Eigen::Index n = edges.rows();
  return {.W = none,
          .B = std::move(edges),
          .b = base::Vector::Zero(n),
          .h = h,
          .equality = std::move(equality),
          .tau = 0.0,
          .d = {}};
}

// Behind the edges those of round cones that the motion r would shorten most; false: none.
bool add_edges_against(const base::Vector& r, const base::Matrix& B,
                       const std::vector<FrictionRow>& friction, base::Matrix& edges) {
  constexpr double round_off = 1e-10;
  std::vector<base::Vector> more;
  for (const FrictionRow& f : friction) {
    if (f.second < 0) {
      continue;
    }
    const Eigen::Vector2d slip(B.row(f.tangent).dot(r), B.row(f.second).dot(r));
    const Eigen::Vector2d against = -slip.normalized();
    const base::Vector edge =
        B.row(f.normal) + f.mu * (against[0] * B.row(f.tangent) + against[1] * B.row(f.second));
    if (edge.dot(r) < -round_off * edge.norm() * r.norm()) {
      more.push_back(edge);
    }
  }
  const Eigen::Index old = edges.rows();
  edges.conservativeResize(old + index(more.size()), Eigen::NoChange);
  for (std::size_t k = 0; k < more.size(); ++k) {
    edges.row(old + index(k)) = more[k].transpose();
  }
  return !more.empty();
}

} // namespace

ControllableProblem cone_edge_balance_problem(const base::Matrix& B, const base::Vector& h,
                                              const std::vector<bool>& equality,
                                              const std::vector<FrictionRow>& friction) {
  constexpr double pi = std::numbers::pi;
  return problem_of_edges(has_round_cones(friction)
                              ? round_edges(B, friction, 1.0 / std::cos(pi / sides))
                              : cone_edges(B, equality, friction),
                          h, equality);
}

LoadBalance balance_round_cones(const ControllableProblem& held,
                                const std::vector<FrictionRow>& friction) {
  constexpr int most_rounds = 40; // each comes nearer by an order or so
  constexpr double balanced = 1e-12;
  base::Matrix edges = round_edges(held.B, friction, 1.0);
  for (int round = 0; round < most_rounds; ++round) {
    LoadBalance balance = balance_loads(problem_of_edges(edges, held.h, held.equality));
    if (balance.remainder.norm() <= balanced * held.h.norm()) {
      break;
    }
    if (!add_edges_against(balance.remainder, held.B, friction, edges)) {
      return balance;
    }
  }
  return {base::Vector::Zero(held.h.size()), {}};
}

base::Vector sliding_motion(const ModeSplit& split, const ControllableProblem& held,
                            const std::vector<FrictionRow>& friction, const LoadBalance& balance) {
  // what the cones leave lifts the body off the rows it slides on: they keep it there
  std::vector<bool> kept = held.equality;
  for (const FrictionRow& f : friction) {
    kept[at(f.normal)] = true;
  }
  const LoadBalance level = balance_loads(
      cone_edge_balance_problem(held.B, balance.remainder, kept, without_mu(friction)));
  const bool lifts = !(level.remainder.norm() > 1e-9 * balance.remainder.norm());
  return unstopped_opening_motion(split, lifts ? balance : level, 0.0);
}

} // namespace spricka::solve
