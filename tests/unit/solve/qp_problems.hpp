// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "dice.hpp"
#include "solve/contact_qp.hpp"

#include <Eigen/QR>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

/// Small contact problems, how well an answer fulfils their conditions, and dice.
namespace spricka::solve::test {

using base::Matrix;
using base::Vector;

inline std::size_t at(Eigen::Index i) {
  return static_cast<std::size_t>(i);
}

inline ContactProblem problem_of(const Matrix& W, const Vector& b) {
  ContactProblem p;
  p.W = W;
  p.b = b;
  p.B = Matrix(b.size(), 0);
  p.h = Vector(0);
  p.equality.assign(at(b.size()), false);
  return p;
}

inline ContactSolution solve(const ContactProblem& p, const std::vector<bool>& start = {}) {
  return solve_contact(p, ContactSettings{}, start);
}

/// Largest violation of the conditions, over the size of the terms (gaps at least: `length`).
inline double violation(const ContactProblem& p, const ContactSolution& s, double length = 1.0) {
  const Vector opened = p.W * s.lambda;
  const Vector moved = p.B * s.alpha;
  const Vector g = p.b + opened + moved;
  const double size = length + p.b.cwiseAbs().maxCoeff() + opened.cwiseAbs().maxCoeff() +
                      (moved.size() > 0 ? moved.cwiseAbs().maxCoeff() : 0.0);
  const double force = 1e-300 + s.lambda.cwiseAbs().maxCoeff();
  double worst = 0.0;
  for (Eigen::Index i = 0; i < g.size(); ++i) {
    if (p.equality[at(i)]) {
      worst = std::max(worst, std::abs(g(i)) / size);
      continue;
    }
    worst = std::max({worst, -g(i) / size, -s.lambda(i) / force,
                      std::min(std::abs(g(i)) / size, s.lambda(i) / force),
                      std::abs(std::max(g(i), 0.0) - s.gap(i)) / size});
  }
  const Vector balance = p.h + p.B.transpose() * s.lambda;
  const Vector terms = p.h.cwiseAbs() + p.B.cwiseAbs().transpose() * s.lambda.cwiseAbs();
  for (Eigen::Index j = 0; j < balance.size(); ++j) {
    worst = std::max(worst, std::abs(balance(j)) / (1e-300 + terms(j)));
  }
  return worst;
}

inline void check_unheld(const ContactProblem& p, const Vector& d) {
  ASSERT_EQ(d.size(), p.h.size());
  EXPECT_GT(p.h.dot(d), 1e-10 * p.h.norm());
  const Vector opening = p.B * d / (p.B.size() > 0 ? p.B.cwiseAbs().maxCoeff() : 1.0);
  for (Eigen::Index i = 0; i < opening.size(); ++i) {
    EXPECT_GT(opening(i), -1e-9);
    if (p.equality[at(i)]) {
      EXPECT_LT(opening(i), 1e-9);
    }
  }
}

inline std::vector<bool> random_start(Dice& dice, Eigen::Index n) {
  std::vector<bool> start(at(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    start[at(i)] = dice.chance(0.5);
  }
  return start;
}

/// A round shaft in a hole, n points on the circle: compliance of its waves like that of a disk in
/// a plane, 1/k for wave k; the motions cos and sin are rigid. `gap`: clearance, below 0
/// interference; F pushes in direction x.
inline ContactProblem ring(Eigen::Index n, double gap, double F) {
  ContactProblem p = problem_of(Matrix::Zero(n, n), Vector::Constant(n, gap));
  p.B.resize(n, 2);
  Vector wave = Vector::Zero(n); // compliance against the distance of two points
  for (Eigen::Index d = 0; d < n; ++d) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(d) / static_cast<double>(n);
    wave(d) = 0.5 + 0.3 * std::cos(angle); // the hole is elastic in every wave
    for (Eigen::Index k = 2; k <= n / 2; ++k) {
      wave(d) += std::cos(static_cast<double>(k) * angle) / static_cast<double>(k);
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      p.W(i, j) = wave(std::abs(i - j));
    }
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    p.B.row(i) = Eigen::RowVector2d(-std::cos(angle), -std::sin(angle));
  }
  p.h = Eigen::Vector2d(F, 0.0);
  return p;
}

} // namespace spricka::solve::test
