// SPDX-License-Identifier: GPL-3.0-or-later
#include "qp_problems.hpp"

#include "base/clock.hpp"

#include <cstdio>

namespace spricka::solve::test::test_contact_qp {
namespace {

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
      const bool none = k == 0;
      const ContactSolution warm =
          solve(p, none ? std::vector<bool>(48, false) : random_start(dice, 48));
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
  p.h(2) = 1e-9; // the moment of a meshed shape: told, and nothing of the force is lost to it
  const ContactSolution turned = solve(p);
  EXPECT_EQ(turned.status, ContactStatus::solved);
  EXPECT_NEAR(turned.left_over, 1e-7, 1e-12);
  EXPECT_NEAR(p.B.col(0).dot(turned.lambda), -0.01, 1e-15);
  EXPECT_EQ(turned.alpha(2), 0.0);
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
  // both translations are controllable, but not the one along the floor
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
                1e3 * watch.cpu_time());
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
    const double cold_cpu = cold.cpu_time();
    ASSERT_EQ(s.status, ContactStatus::solved);
    p.h(0) *= 1.05;
    const base::Stopwatch warm;
    const ContactSolution next = solve(p, s.closed);
    std::printf("gap %6.3f: cold %.1f ms, %d block steps, %d pivots, residual %.0e; load +5 %%: "
                "%.1f ms, %d block steps\n",
                gap, 1e3 * cold_cpu, s.block_iterations, s.pivots, s.residual,
                1e3 * warm.cpu_time(), next.block_iterations);
    EXPECT_LT(violation(p, next, 1e-3), 1e-11);
  }
}

} // namespace
} // namespace spricka::solve::test::test_contact_qp
