// SPDX-License-Identifier: GPL-3.0-or-later
// Friction with slips that are vectors: conditions of any answer, frames, known answers.
#include "dice.hpp"
#include "solve/friction.hpp"
#include "solve/friction_index.hpp"
#include "tests/places.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace spricka::solve::test_round_friction {
namespace {

using base::Matrix;
using base::Vector;
using test::Dice;

// Contacts of three rows each: normal and two tangents, one block after the other.
FrictionProblem round_problem(const Matrix& W, const Vector& b, double mu) {
  FrictionProblem p;
  p.contact.W = W;
  p.contact.b = b;
  p.contact.B = Matrix(b.size(), 0);
  p.contact.h = Vector(0);
  p.contact.equality.assign(static_cast<std::size_t>(b.size()), false);
  for (int i = 0; i < static_cast<int>(b.size()) / 3; ++i) {
    p.friction.push_back({3 * i, 3 * i + 1, mu, 3 * i + 2});
  }
  return p;
}

FrictionSolution solve(const FrictionProblem& p) {
  return solve_friction(p, ContactSettings{}, {});
}

// Largest violation of Signorini's and Coulomb's conditions and of balance, scaled.
double violation(const FrictionProblem& p, const FrictionSolution& s) {
  const ContactProblem& c = p.contact;
  const Vector& q = s.contact.lambda;
  const Vector g = c.b + c.W * q + c.B * s.contact.alpha;
  const double size = 1e-300 + c.b.cwiseAbs().maxCoeff() + (c.W * q).cwiseAbs().maxCoeff() +
                      (c.B.cols() > 0 ? (c.B * s.contact.alpha).cwiseAbs().maxCoeff() : 0.0);
  const double force = 1e-300 + q.cwiseAbs().maxCoeff();
  double worst = 0.0;
  for (const FrictionRow& f : p.friction) {
    const double n = q[f.normal];
    worst = std::max({worst, -n / force, -g[f.normal] / size,
                      std::min(std::abs(g[f.normal]) / size, std::abs(n) / force)});
    const Eigen::Vector2d shear(q[f.tangent], q[f.second]);
    const Eigen::Vector2d slip(g[f.tangent], g[f.second]);
    worst = std::max(worst, (shear.norm() - f.mu * std::max(n, 0.0)) / force);
    if (slip.norm() > 1e-9 * size && n > 0.0) {
      worst = std::max(worst, (shear + f.mu * n * slip.normalized()).norm() / force);
    }
  }
  if (c.h.size() > 0) {
    worst = std::max(worst, (c.h + c.B.transpose() * q).cwiseAbs().maxCoeff() /
                                (force + c.h.cwiseAbs().maxCoeff()));
  }
  return worst;
}

// The compliance of a half space between contact points: normal and tangents, symmetric and
// positive definite.
Matrix half_space(Dice& dice, int points, double extent) {
  std::vector<Eigen::Vector2d> x;
  while (static_cast<int>(x.size()) < points) {
    const Eigen::Vector2d y(dice.real(-extent, extent), dice.real(-extent, extent));
    if (std::ranges::all_of(x, [&](const Eigen::Vector2d& z) { return (y - z).norm() > 0.8; })) {
      x.push_back(y);
    }
  }
  const double nu = 0.3;
  const Eigen::Index rows = 3 * static_cast<Eigen::Index>(points);
  Matrix W = Matrix::Zero(rows, rows);
  for (Eigen::Index i = 0; i < points; ++i) {
    for (Eigen::Index k = 0; k < points; ++k) {
      const Eigen::Vector2d d = x[static_cast<std::size_t>(i)] - x[static_cast<std::size_t>(k)];
      const double r = i == k ? 0.4 : d.norm();
      const Eigen::Vector2d e = i == k ? Eigen::Vector2d::Zero() : Eigen::Vector2d(d / r);
      // Boussinesq and Cerruti, without what couples normal and tangents
      W(3 * i, 3 * k) = (1.0 - nu) / r;
      for (Eigen::Index a = 0; a < 2; ++a) {
        for (Eigen::Index c = 0; c < 2; ++c) {
          W(3 * i + 1 + a, 3 * k + 1 + c) =
              ((a == c ? (i == k ? 1.0 - 0.5 * nu : 1.0 - nu) : 0.0) + nu * e[a] * e[c]) / r;
        }
      }
    }
  }
  return W;
}

TEST(RoundFriction, OnePointSlipsAgainstItsPushAndSticksBelow) {
  Matrix W = Matrix::Identity(3, 3);
  // pressed by 2, pushed along (3, 4) / 5
  for (const double push : {0.5, 5.0}) {
    const Vector b = (Vector(3) << -2.0, 0.6 * push, 0.8 * push).finished();
    const FrictionSolution s = solve(round_problem(W, b, 0.5));
    ASSERT_EQ(s.contact.status, ContactStatus::solved);
    const double shear = std::min(push, 0.5 * 2.0);
    EXPECT_NEAR(s.contact.lambda[0], 2.0, 1e-12);
    EXPECT_NEAR(s.contact.lambda[1], -0.6 * shear, 1e-12);
    EXPECT_NEAR(s.contact.lambda[2], -0.8 * shear, 1e-12);
    EXPECT_EQ(s.touch[1], push < 1.0 ? SlipState::stick : SlipState::forward);
  }
}

TEST(RoundFriction, AnswersKeepEveryCondition) {
  Dice dice(20241);
  const int tries = spricka::test::full_size() ? 4000 : 150;
  int several = 0;
  for (int t = 0; t < tries; ++t) {
    const int points = dice.whole(1, 14);
    Matrix W = half_space(dice, points, 4.0);
    // coupling of normal and tangents, weak enough to stay positive definite
    for (Eigen::Index i = 0; i < W.rows(); ++i) {
      for (Eigen::Index k = 0; k < i; ++k) {
        if (i % 3 == 0 || k % 3 == 0) {
          const double c = dice.real(-0.02, 0.02);
          W(i, k) += c;
          W(k, i) += c;
        }
      }
    }
    Vector b(W.rows());
    for (Eigen::Index i = 0; i < b.size(); ++i) {
      b[i] = i % 3 == 0 ? dice.real(-1.5, 0.5) : dice.real(-1.0, 1.0);
    }
    const FrictionProblem p = round_problem(W, b, dice.real(0.0, 0.8));
    const FrictionSolution s = solve(p);
    ASSERT_EQ(s.contact.status, ContactStatus::solved) << "try " << t;
    EXPECT_LT(violation(p, s), 1e-8) << "try " << t;
    several += has_other_solutions(p, s) ? 1 : 0;
  }
  EXPECT_EQ(several, 0); // with so weak a coupling there is one solution
}

// From forces that are near the answer Newton's method gets there alone, and to the same one; from
// others the sweeps help as before.
TEST(RoundFriction, ExpectedForcesLeadToTheSameAnswer) {
  Dice dice(11);
  for (int t = 0; t < 20; ++t) {
    const Matrix W = half_space(dice, 12, 4.0);
    Vector b(W.rows());
    for (Eigen::Index i = 0; i < b.size(); ++i) {
      b[i] = i % 3 == 0 ? dice.real(-1.5, 0.2) : dice.real(-0.5, 0.5);
    }
    FrictionProblem p = round_problem(W, b, 0.3);
    const FrictionSolution before = solve(round_problem(W, 0.999 * b, 0.3));
    const FrictionSolution plain = solve(p);
    EXPECT_GT(plain.contact.pivots, 0); // sweeps
    for (const double part : {1.0, -5.0}) {
      p.expected = {part * before.contact.lambda, before.contact.alpha};
      const FrictionSolution s = solve(p);
      ASSERT_EQ(s.contact.status, ContactStatus::solved) << "try " << t;
      EXPECT_LT(violation(p, s), 1e-8) << "try " << t;
      EXPECT_LT((s.contact.lambda - plain.contact.lambda).norm(),
                1e-9 * plain.contact.lambda.norm());
      if (part == 1.0) {
        EXPECT_EQ(s.contact.pivots, 0) << "try " << t;
      }
    }
  }
}

// No direction is favoured: turned frames, the same forces.
TEST(RoundFriction, FramesDoNotMatter) {
  Dice dice(7);
  const int points = 10;
  const Matrix W = half_space(dice, points, 4.0);
  Vector b(W.rows());
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    b[i] = i % 3 == 0 ? dice.real(-1.5, 0.2) : dice.real(-0.5, 0.5);
  }
  const FrictionSolution first = solve(round_problem(W, b, 0.3));
  Matrix R = Matrix::Identity(W.rows(), W.rows());
  for (Eigen::Index i = 0; i < points; ++i) {
    const double turn = dice.real(0.0, 6.28);
    R.block(3 * i + 1, 3 * i + 1, 2, 2) << std::cos(turn), std::sin(turn), -std::sin(turn),
        std::cos(turn);
  }
  const FrictionSolution second = solve(round_problem(R * W * R.transpose(), R * b, 0.3));
  ASSERT_EQ(second.contact.status, ContactStatus::solved);
  EXPECT_LT((R.transpose() * second.contact.lambda - first.contact.lambda).norm(),
            1e-9 * first.contact.lambda.norm());
}

// A block on three legs, held by friction alone against a push below mu p, and sliding above.
TEST(RoundFriction, ABlockOnLegsRestsUntilItSlides) {
  const std::vector<Eigen::Vector2d> legs{{0.0, 0.0}, {2.0, 0.0}, {0.5, 1.5}};
  Matrix B(9, 6); // shifts along x, y, z and turns about them
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double x = legs[static_cast<std::size_t>(i)].x() - 0.8;
    const double y = legs[static_cast<std::size_t>(i)].y() - 0.5;
    B.row(3 * i) << 0, 0, 1, y, -x, 0;
    B.row(3 * i + 1) << 1, 0, 0, 0, 0, -y;
    B.row(3 * i + 2) << 0, 1, 0, 0, 0, x;
  }
  // Between 1 and 1.02 cones of sixteen sides about the round ones would hold it.
  for (const double push : {0.5, 0.99, 1.0 - 1e-4, 1.0 + 1e-4, 1.005, 1.015, 1.2}) {
    FrictionProblem p = round_problem(0.01 * Matrix::Identity(9, 9), Vector::Zero(9), 0.1);
    p.contact.B = B;
    p.contact.h = (Vector(6) << 0.6 * push, 0.8 * push, -10.0, 0.0, 0.0, 0.0).finished();
    p.contact.load_scale = 10.0;
    const FrictionSolution s = solve(p);
    if (push > 1.0) {
      ASSERT_EQ(s.contact.status, ContactStatus::unheld_mode) << push;
      EXPECT_TRUE(s.slides);
      EXPECT_GT(s.contact.unheld.dot(p.contact.h), 0.0);
      EXPECT_LT((B * s.contact.unheld).reshaped(3, 3).row(0).norm(), 1e-9); // along the floor
      continue;
    }
    ASSERT_EQ(s.contact.status, ContactStatus::solved) << push;
    EXPECT_LT(violation(p, s), 1e-8);
  }
}

// A loose block above two legs' floor: nothing loads it, so that no friction holds it, and Newton's
// method may leave it anywhere along the floor. It stays where it has been; a floor that has risen
// lifts it by no more than that.
TEST(RoundFriction, LooseBodiesStayWhereTheyAre) {
  Matrix B(6, 3); // shifts along x, y, z
  B << 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0;
  for (const double floor : {-0.2, 0.3}) { // of the drawn height, at rest 0.1 above
    FrictionProblem p = round_problem(0.01 * Matrix::Identity(6, 6), Vector::Zero(6), 0.1);
    p.contact.b = (Vector(6) << -floor, 0.0, 0.0, -floor, 0.0, 0.0).finished();
    p.contact.B = B;
    p.contact.h = Vector::Zero(3);
    p.contact.load_scale = 1.0;
    p.alpha_start = Eigen::Vector3d(0.02, -0.01, 0.1);
    p.expected = {Vector::Zero(6), Eigen::Vector3d(1e5, 300.0, 2.0)};
    const FrictionSolution s = solve(p);
    ASSERT_EQ(s.contact.status, ContactStatus::solved);
    EXPECT_EQ(s.contact.resting_modes, 3);
    EXPECT_NEAR(s.contact.alpha[0], 0.02, 1e-9) << floor;
    EXPECT_NEAR(s.contact.alpha[1], -0.01, 1e-9) << floor;
    EXPECT_NEAR(s.contact.alpha[2], std::max(0.1, floor), 1e-9) << floor;
    EXPECT_LT(violation(p, s), 1e-8);
  }
}

// A block that supports let move across its pressure only, pressed on two points of a floor that
// has moved on by 0.003: friction takes it along without a force, and no point's pressure tells
// that it is held.
TEST(RoundFriction, BodiesThatShearAloneHoldsGoAlong) {
  Matrix B = Matrix::Zero(6, 1);
  B(1, 0) = B(4, 0) = 1.0;
  FrictionProblem p = round_problem(0.01 * Matrix::Identity(6, 6), Vector::Zero(6), 0.1);
  p.contact.b = (Vector(6) << -0.05, 0.003, 0.0, -0.05, 0.003, 0.0).finished();
  p.contact.B = B;
  p.contact.h = Vector::Zero(1);
  p.contact.load_scale = 1.0;
  p.alpha_start = Vector::Zero(1);
  const FrictionSolution s = solve(p);
  ASSERT_EQ(s.contact.status, ContactStatus::solved);
  EXPECT_EQ(s.contact.resting_modes, 0);
  EXPECT_NEAR(s.contact.alpha[0], -0.003, 1e-12);
  EXPECT_LT(violation(p, s), 1e-8);
}

// A pin in a bore, on a support so soft that its points move nearly together: forces that cancel
// each other hardly open a gap, so that a small overlap asks for large ones. Sweeps lead nowhere
// then, and about one time in eight Newton's method runs in circles in every round.
TEST(RoundFriction, ProximalPointsLeadOutOfCircles) {
  constexpr int points = 12;
  constexpr int rounds =
      150; // Newton steps of all rounds together; those of proximal points come on top
  Matrix along(3, 3 * points);
  Matrix W(along.cols(), along.cols());
  for (Eigen::Index i = 0; i < points; ++i) {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / points;
    along.middleCols(3 * i, 3) << std::cos(turn), -std::sin(turn), 0.0, std::sin(turn),
        std::cos(turn), 0.0, 0.0, 0.0, 1.0;
  }
  for (Eigen::Index i = 0; i < W.rows(); ++i) {
    for (Eigen::Index k = 0; k < W.rows(); ++k) {
      const double r = (along.col(i - i % 3) - along.col(k - k % 3)).norm() / 30.0;
      W(i, k) = (1.0 + r) * std::exp(-r) * along.col(i).dot(along.col(k));
    }
  }
  Dice dice(3);
  int by_proximal_points = 0;
  for (int t = 0; t < 60; ++t) {
    Vector b(W.rows());
    for (Eigen::Index i = 0; i < b.size(); ++i) {
      b[i] = i % 3 == 0 ? dice.real(-1.0, 0.0) : dice.real(-0.5, 0.5);
    }
    const FrictionProblem p = round_problem(W, b, 0.5);
    const FrictionSolution s = solve(p);
    ASSERT_EQ(s.contact.status, ContactStatus::solved) << "try " << t;
    if (s.contact.block_iterations > rounds) {
      ++by_proximal_points;
      EXPECT_LT(violation(p, s), 1e-8) << "try " << t;
    }
  }
  EXPECT_GT(by_proximal_points, 0);
}

} // namespace
} // namespace spricka::solve::test_round_friction
