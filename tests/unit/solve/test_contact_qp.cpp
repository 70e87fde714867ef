// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/clock.hpp"
#include "solve/contact_qp.hpp"

#include <Eigen/QR>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace spricka::solve {
namespace {

using base::Matrix;
using base::Vector;

std::size_t at(Eigen::Index i) {
  return static_cast<std::size_t>(i);
}

ContactProblem problem_of(const Matrix& W, const Vector& b) {
  ContactProblem p;
  p.W = W;
  p.b = b;
  p.B = Matrix(b.size(), 0);
  p.h = Vector(0);
  p.equality.assign(at(b.size()), false);
  return p;
}

ContactSolution solve(const ContactProblem& p, const std::vector<bool>& start = {}) {
  return solve_contact(p, ContactSettings{}, start);
}

/// Largest violation of the conditions, over the size of the terms (gaps at least: `length`).
double violation(const ContactProblem& p, const ContactSolution& s, double length = 1.0) {
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

/// The answer by trying every set of closed rows; nothing when no set satisfies the conditions.
std::optional<ContactSolution> enumerate(const ContactProblem& p) {
  const Eigen::Index n = p.b.size();
  const Eigen::Index m = p.h.size();
  for (unsigned set = 0; set < (1U << n); ++set) {
    std::vector<Eigen::Index> A;
    bool possible = true;
    for (Eigen::Index i = 0; i < n; ++i) {
      const bool closed = (set >> i & 1U) != 0;
      possible = possible && (closed || !p.equality[at(i)]);
      if (closed) {
        A.push_back(i);
      }
    }
    if (!possible) {
      continue;
    }
    const Eigen::Index a = static_cast<Eigen::Index>(A.size());
    Matrix K = Matrix::Zero(a + m, a + m);
    Vector r(a + m);
    for (Eigen::Index i = 0; i < a; ++i) {
      for (Eigen::Index j = 0; j < a; ++j) {
        K(i, j) = p.W(A[at(i)], A[at(j)]);
      }
      K.block(i, a, 1, m) = p.B.row(A[at(i)]);
      K.block(a, i, m, 1) = p.B.row(A[at(i)]).transpose();
      r(i) = -p.b(A[at(i)]);
    }
    r.tail(m) = -p.h;
    ContactSolution s;
    s.lambda = Vector::Zero(n);
    s.alpha = Vector::Zero(m);
    if (a + m > 0) {
      Eigen::CompleteOrthogonalDecomposition<Matrix> qr(K.rows(), K.cols());
      qr.setThreshold(1e-11);
      const Vector x = qr.compute(K).solve(r);
      if (!((K * x - r).norm() <= 1e-9 * (r.norm() + 1e-300))) {
        continue;
      }
      for (Eigen::Index i = 0; i < a; ++i) {
        s.lambda(A[at(i)]) = x(i);
      }
      s.alpha = x.tail(m);
    }
    s.gap = (p.b + p.W * s.lambda + p.B * s.alpha).cwiseMax(0.0);
    if (violation(p, s) < 1e-9) {
      return s;
    }
  }
  return std::nullopt;
}

/// Random bodies: N elastic freedoms, m rigid modes, n constraint rows with twins, sums of rows,
/// equality rows and net fits thrown in.
class Dice {
public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }
  bool chance(double p) { return real(0.0, 1.0) < p; }
  double real(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  Matrix matrix(Eigen::Index r, Eigen::Index c) {
    return Matrix::NullaryExpr(r, c, [this] { return real(-1.0, 1.0); });
  }

private:
  std::mt19937 engine_;
};

ContactProblem random_problem(Dice& dice) {
  const Eigen::Index n = dice.whole(1, 8);
  const Eigen::Index m = dice.whole(0, 3);
  const Eigen::Index N = dice.whole(1, 9); // fewer than rows: semidefinite W
  const Matrix F = dice.matrix(N, N);      // S^+ = F F^T on the elastic freedoms
  Matrix G = dice.matrix(n, N);
  Matrix B = dice.matrix(n, m);
  Vector g0 = dice.matrix(n, 1);
  Vector f = dice.matrix(N, 1);
  Vector h = dice.matrix(m, 1);
  if (m > 0 && dice.chance(0.6)) { // loads that some rows can take
    h = -B.transpose() * dice.matrix(n, 1).cwiseAbs();
  }
  if (dice.chance(0.3)) {
    g0.setZero(); // net fit
    f *= dice.chance(0.5) ? 0.0 : 1.0;
  }
  if (dice.chance(0.1)) {
    G.setZero(); // rigid bodies
  }
  for (Eigen::Index i = 1; i < n; ++i) {
    const Eigen::Index k = dice.whole(0, static_cast<int>(i) - 1);
    if (dice.chance(0.15)) { // a twin, now and then further away
      G.row(i) = G.row(k);
      B.row(i) = B.row(k);
      g0(i) = g0(k) + (dice.chance(0.3) ? dice.real(0.0, 1.0) : 0.0);
    } else if (i > 1 && dice.chance(0.1)) { // the sum of two
      const Eigen::Index l = dice.whole(0, static_cast<int>(i) - 1);
      G.row(i) = G.row(k) + G.row(l);
      B.row(i) = B.row(k) + B.row(l);
      g0(i) = g0(k) + g0(l);
    }
  }
  ContactProblem p;
  p.W = G * F * F.transpose() * G.transpose();
  p.W = (0.5 * (p.W + p.W.transpose())).eval();
  p.B = B;
  p.b = g0 + G * F * (F.transpose() * f);
  p.h = h;
  p.equality.assign(at(n), false);
  if (dice.chance(0.3)) {
    p.equality[at(dice.whole(0, static_cast<int>(n) - 1))] = true;
    p.equality[at(dice.whole(0, static_cast<int>(n) - 1))] = true;
  }
  return p;
}

/// The same problem in other units of force and length.
ContactProblem in_units(ContactProblem p, double force, double length) {
  p.W *= length / force;
  p.b *= length;
  p.h *= force;
  return p;
}

void check_unheld(const ContactProblem& p, const Vector& d) {
  ASSERT_EQ(d.size(), p.h.size());
  EXPECT_GT(p.h.dot(d), 1e-10 * p.h.norm());
  const Vector opening = p.B * d;
  for (Eigen::Index i = 0; i < opening.size(); ++i) {
    EXPECT_GT(opening(i), -1e-9);
    if (p.equality[at(i)]) {
      EXPECT_LT(opening(i), 1e-9);
    }
  }
}

std::vector<bool> random_start(Dice& dice, Eigen::Index n) {
  std::vector<bool> start(at(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    start[at(i)] = dice.chance(0.5);
  }
  return start;
}

TEST(ContactQp, CyclingMatrixFromEveryStart) {
  // plain flipping of all violated rows cycles from six of the eight starts
  Matrix W(3, 3);
  W << 4, 5, -5, 5, 9, -5, -5, -5, 7;
  const ContactProblem p = problem_of(W, Eigen::Vector3d(-2, -1, 3));
  for (unsigned set = 0; set < 8; ++set) {
    const ContactSolution s = solve(p, {(set & 1U) != 0, (set & 2U) != 0, (set & 4U) != 0});
    EXPECT_EQ(s.status, ContactStatus::solved);
    EXPECT_NEAR(s.lambda(0), 0.5, 1e-15);
    EXPECT_EQ(s.lambda(1), 0.0);
    EXPECT_EQ(s.lambda(2), 0.0);
    EXPECT_EQ(s.closed, std::vector<bool>({true, false, false}));
    EXPECT_LE(s.block_iterations + s.pivots, 10);
  }
}

TEST(ContactQp, RandomProblemsAgreeWithEnumeration) {
  const int tries = std::getenv("SPRICKA_FULL") == nullptr ? 300 : 10000;
  int solved = 0;
  int fallbacks = 0;
  for (int seed = 0; seed < tries; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(static_cast<unsigned>(seed));
    const ContactProblem plain = random_problem(dice);
    const std::optional<ContactSolution> reference = enumerate(plain);
    const double force = std::pow(10.0, dice.whole(-6, 6));
    const double length = std::pow(10.0, dice.whole(-6, 6));
    const ContactProblem p = in_units(plain, force, length);
    const ContactSolution s = solve(p);
    if (!reference) {
      if (s.status == ContactStatus::solved) { // nearly parallel rows: forces of 1e10 can be right
        EXPECT_LT(violation(p, s, length), 1e-9);
      }
      EXPECT_NE(s.status, ContactStatus::max_iterations);
      if (s.status == ContactStatus::unheld_mode) {
        check_unheld(p, s.unheld);
      }
      continue;
    }
    ASSERT_EQ(s.status, ContactStatus::solved);
    ++solved;
    fallbacks += s.pivots > 0 ? 1 : 0;
    EXPECT_LT(violation(p, s, length), 1e-10);
    EXPECT_LT(s.residual, 1e-10);
    // what the forces do is unique, the forces of redundant rows are not
    const Vector opened = p.W * s.lambda;
    const Vector expected = length * plain.W * reference->lambda;
    const Vector terms = length * (plain.W.cwiseAbs() * reference->lambda.cwiseAbs() +
                                   plain.B.cwiseAbs() * reference->alpha.cwiseAbs());
    const double size = length + p.b.cwiseAbs().maxCoeff() + terms.maxCoeff();
    EXPECT_LT((opened - expected).cwiseAbs().maxCoeff(), 1e-10 * size);
    const ContactSolution warm = solve(p, random_start(dice, p.b.size()));
    ASSERT_EQ(warm.status, ContactStatus::solved);
    EXPECT_LT((p.W * warm.lambda - opened).cwiseAbs().maxCoeff(), 1e-12 * size);
  }
  std::printf("%d of %d solved, %d of them by pivoting\n", solved, tries, fallbacks);
}

/// A round shaft in a hole, n points on the circle: compliance of its waves like that of a disk in
/// a plane, 1/k for wave k; the motions cos and sin are rigid. `gap`: clearance, below 0
/// interference; F pushes in direction x.
ContactProblem ring(Eigen::Index n, double gap, double F) {
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

TEST(ContactQp, ShaftInHoleFromAnyStart) {
  Dice dice(3);
  for (const double gap : {-1e-3, 0.0, 1e-3}) {
    const ContactProblem p = ring(48, gap, 0.01);
    const ContactSolution s = solve(p);
    ASSERT_EQ(s.status, ContactStatus::solved);
    EXPECT_LT(violation(p, s, 1e-3), 1e-12);
    EXPECT_NEAR(s.alpha(1), 0.0, 1e-14);
    for (Eigen::Index i = 1; i < 48; ++i) { // symmetric about the load
      EXPECT_NEAR(s.lambda(i), s.lambda(48 - i), 1e-12 * s.lambda.maxCoeff());
    }
    for (int k = 0; k < 20; ++k) {
      const ContactSolution warm = solve(p, random_start(dice, 48));
      ASSERT_EQ(warm.status, ContactStatus::solved);
      EXPECT_LT((warm.lambda - s.lambda).norm(), 1e-12 * s.lambda.norm());
      EXPECT_LT((warm.alpha - s.alpha).norm(), 1e-12 * s.alpha.norm());
    }
  }
}

TEST(ContactQp, WarmStartTakesOneStep) {
  const ContactProblem p = ring(60, -1e-3, 0.01);
  const ContactSolution cold = solve(p);
  const ContactSolution warm = solve(p, cold.closed);
  EXPECT_EQ(warm.block_iterations, 1);
  EXPECT_EQ(warm.lambda, cold.lambda);
}

TEST(ContactQp, ModeThatNoRowTouchesRestsOrIsNamed) {
  ContactProblem p = ring(40, 0.0, 0.01);
  p.B.conservativeResize(Eigen::NoChange, 3);
  for (Eigen::Index i = 0; i < 40; ++i) {
    p.B(i, 2) = (i % 2 == 0 ? 1.0 : -1.0) * 3e-15; // rotation: round-off of radial normals
  }
  p.h = Eigen::Vector3d(0.01, 0.0, 1e-14);
  const ContactSolution s = solve(p);
  EXPECT_EQ(s.status, ContactStatus::solved);
  EXPECT_EQ(s.resting_modes, 1);
  EXPECT_EQ(s.alpha(2), 0.0);
  p.h(2) = 1e-6;
  const ContactSolution loaded = solve(p);
  EXPECT_EQ(loaded.status, ContactStatus::unheld_mode);
  EXPECT_NEAR(loaded.unheld(2), 1.0, 1e-12);
}

TEST(ContactQp, BodyPulledAwayIsNamed) {
  // a block on the floor, rows below it: pushed down it rests, pulled up or aside nothing holds it
  ContactProblem p = problem_of(Matrix::Identity(4, 4) * 1e-3, Vector::Zero(4));
  p.B.resize(4, 3);
  for (Eigen::Index i = 0; i < 4; ++i) {
    p.B.row(i) = Eigen::RowVector3d(0.0, 1.0, static_cast<double>(i) - 1.5);
  }
  p.h = Eigen::Vector3d(0.0, -5.0, 1.0);
  EXPECT_EQ(solve(p).status, ContactStatus::solved);
  p.h = Eigen::Vector3d(0.0, 5.0, 0.0);
  const ContactSolution up = solve(p);
  EXPECT_EQ(up.status, ContactStatus::unheld_mode);
  check_unheld(p, up.unheld);
  p.h = Eigen::Vector3d(1.0, -5.0, 0.0);
  const ContactSolution aside = solve(p);
  EXPECT_EQ(aside.status, ContactStatus::unheld_mode);
  EXPECT_NEAR(aside.unheld(0), 1.0, 1e-12);
  p.h = Eigen::Vector3d(0.0, -1.0, 2.0); // it tips over
  EXPECT_EQ(solve(p).status, ContactStatus::unheld_mode);
}

TEST(ContactQp, BlockSlidesOnAnInclinedFloorOnly) {
  // both translations are felt, but not the one along the floor
  const double c = std::cos(0.4);
  const double s = std::sin(0.4);
  ContactProblem p = problem_of(Matrix::Identity(3, 3), Vector::Zero(3));
  p.B.resize(3, 2);
  p.B.rowwise() = Eigen::RowVector2d(s, c);
  p.h = -2.0 * Eigen::Vector2d(s, c);
  const ContactSolution held = solve(p);
  ASSERT_EQ(held.status, ContactStatus::solved);
  EXPECT_EQ(held.resting_modes, 1);
  EXPECT_NEAR(held.alpha(0) * c - held.alpha(1) * s, 0.0, 1e-15);
  EXPECT_NEAR(held.lambda.sum(), 2.0, 1e-14);
  p.h = Eigen::Vector2d(0.0, -2.0);
  const ContactSolution slides = solve(p);
  EXPECT_EQ(slides.status, ContactStatus::unheld_mode);
  EXPECT_NEAR(std::abs(slides.unheld(0) * c - slides.unheld(1) * s), 1.0, 1e-12);
}

TEST(ContactQp, UnloadedShaftWithClearanceRests) {
  ContactProblem p = ring(40, 1e-3, 0.0);
  const ContactSolution loose = solve(p);
  ASSERT_EQ(loose.status, ContactStatus::solved);
  EXPECT_EQ(loose.resting_modes, 2);
  EXPECT_LT(loose.alpha.norm(), 1e-15);
  EXPECT_EQ(loose.lambda.cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(loose.closed, std::vector<bool>(40, false));
  // one point stands 0.2e-3 into the shaft: it is pushed there by just as much and no further
  p.b(0) = -2e-4;
  const ContactSolution pushed = solve(p);
  EXPECT_EQ(pushed.status, ContactStatus::solved);
  EXPECT_NEAR(pushed.alpha(0), -2e-4, 1e-15);
  EXPECT_NEAR(pushed.alpha(1), 0.0, 1e-15);
  EXPECT_LT(pushed.lambda.cwiseAbs().maxCoeff(), 1e-19);
}

TEST(ContactQp, TwinRowsChangeNoDisplacement) {
  const ContactProblem single = ring(30, -1e-3, 0.02);
  ContactProblem twin = problem_of(Matrix(60, 60), Vector(60));
  twin.B.resize(60, 2);
  twin.h = single.h;
  for (Eigen::Index i = 0; i < 60; ++i) {
    for (Eigen::Index j = 0; j < 60; ++j) {
      twin.W(i, j) = single.W(i / 2, j / 2);
    }
    twin.B.row(i) = single.B.row(i / 2);
    twin.b(i) = single.b(i / 2);
  }
  const ContactSolution one = solve(single);
  const ContactSolution two = solve(twin);
  ASSERT_EQ(two.status, ContactStatus::solved);
  EXPECT_GT(two.redundant, 0);
  EXPECT_LT((one.alpha - two.alpha).norm(), 1e-12 * one.alpha.norm());
  for (Eigen::Index i = 0; i < 30; ++i) {
    EXPECT_NEAR(one.lambda(i), two.lambda(2 * i) + two.lambda(2 * i + 1),
                1e-11 * one.lambda.maxCoeff());
  }
}

TEST(ContactQp, EqualityRowsThatContradictAreRefused) {
  ContactProblem p = problem_of(Matrix::Constant(2, 2, 1.0), Eigen::Vector2d(1.0, 1.0));
  p.equality = {true, true};
  const ContactSolution twice = solve(p);
  ASSERT_EQ(twice.status, ContactStatus::solved);
  EXPECT_EQ(twice.redundant, 1);
  EXPECT_NEAR(twice.lambda.sum(), -1.0, 1e-15);
  p.b(1) = 1.1;
  EXPECT_EQ(solve(p).status, ContactStatus::inconsistent);
}

TEST(ContactQp, NothingToDo) {
  const ContactSolution none = solve(problem_of(Matrix(0, 0), Vector(0)));
  EXPECT_EQ(none.status, ContactStatus::solved);
  ContactProblem loose = problem_of(Matrix(0, 0), Vector(0));
  loose.B.resize(0, 1);
  loose.h = Vector::Constant(1, 1.0);
  EXPECT_EQ(solve(loose).status, ContactStatus::unheld_mode);
  loose.h(0) = 0.0;
  EXPECT_EQ(solve(loose).resting_modes, 1);
}

TEST(ContactQp, FallbackAloneSolvesToo) {
  ContactSettings settings;
  settings.max_block_iterations = 0;
  for (const double gap : {-1e-3, 0.0, 1e-3}) {
    const ContactProblem p = ring(120, gap, 0.05);
    const ContactSolution s = solve(p);
    const base::Stopwatch watch;
    const ContactSolution pivoted = solve_contact(p, settings, {});
    std::printf("120 rows, gap %6.3f: %d pivots, %.1f ms\n", gap, pivoted.pivots,
                1e3 * watch.cpu());
    ASSERT_EQ(pivoted.status, ContactStatus::solved);
    EXPECT_GT(pivoted.pivots, 0);
    EXPECT_LT((pivoted.lambda - s.lambda).norm(), 1e-12 * s.lambda.norm());
    EXPECT_LT((pivoted.alpha - s.alpha).norm(), 1e-12 * s.alpha.norm());
  }
}

TEST(ContactQp, CostOfSixHundredRows) {
  for (const double gap : {-1e-3, 1e-3}) {
    ContactProblem p = ring(600, gap, 0.3);
    const base::Stopwatch cold;
    const ContactSolution s = solve(p);
    const double cold_cpu = cold.cpu();
    ASSERT_EQ(s.status, ContactStatus::solved);
    p.h(0) *= 1.05;
    const base::Stopwatch warm;
    const ContactSolution next = solve(p, s.closed);
    std::printf("gap %6.3f: cold %.1f ms, %d block steps, %d pivots, residual %.0e; load +5 %%: "
                "%.1f ms, %d block steps\n",
                gap, 1e3 * cold_cpu, s.block_iterations, s.pivots, s.residual, 1e3 * warm.cpu(),
                next.block_iterations);
    EXPECT_LT(violation(p, next, 1e-3), 1e-11);
  }
}

} // namespace
} // namespace spricka::solve
