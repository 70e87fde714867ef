// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/dependence.hpp"
#include "model/freedoms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

// Ties solved for by hand.
namespace spricka::fe::test_dependence {
namespace {

using base::Matrix;
using base::Vector;
using Cls = model::FreedomRole;

std::vector<Cls> all_local(std::size_t n) {
  return std::vector<Cls>(n, Cls::local);
}

double coefficient(const ConstraintTransformation::DependentRow& row, std::int32_t freedom) {
  for (const FreedomTerm& t : row.terms) {
    if (t.freedom == freedom) {
      return t.coefficient;
    }
  }
  return 0.0;
}

TEST(Dependence, FirstTermFollowsTheOthers) {
  // 2 u1 - 3 u0 + u3 = 5
  const ConstraintTransformation ties({{{{1, 2.0}, {0, -3.0}, {3, 1.0}}, 5.0, 7}}, all_local(4));
  ASSERT_EQ(ties.rows().size(), 1U);
  const ConstraintTransformation::DependentRow* row = ties.find_row(1);
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->mpc, 7U);
  EXPECT_EQ(row->terms.size(), 2U);
  EXPECT_DOUBLE_EQ(coefficient(*row, 0), 1.5);
  EXPECT_DOUBLE_EQ(coefficient(*row, 3), -0.5);
  EXPECT_DOUBLE_EQ(row->constant, 2.5);
  EXPECT_TRUE(ties.has_constants());
  EXPECT_EQ(ties.find_row(0), nullptr);
  EXPECT_EQ(ties.redundant_tie_count(), 0);

  Vector u(4);
  u << 4.0, 99.0, 6.0, 2.0;
  ties.set_dependent_displacements(u, 1.0);
  EXPECT_DOUBLE_EQ(u[1], 1.5 * 4.0 - 0.5 * 2.0 + 2.5);
  ties.set_dependent_displacements(u, 0.0); // the constant belongs to one vector only
  EXPECT_DOUBLE_EQ(u[1], 1.5 * 4.0 - 0.5 * 2.0);
  EXPECT_DOUBLE_EQ(u[2], 6.0);
}

// u0 = u1 + 1, u1 = 2 u2 + 3 in either order: u0 = 2 u2 + 4.
TEST(Dependence, SlaveOfOneTieIsMasterOfAnother) {
  const Tie a{{{0, 1.0}, {1, -1.0}}, 1.0, 0};
  const Tie b{{{1, 1.0}, {2, -2.0}}, 3.0, 1};
  for (const std::vector<Tie>& order : {std::vector<Tie>{a, b}, std::vector<Tie>{b, a}}) {
    const ConstraintTransformation ties(order, all_local(3));
    ASSERT_EQ(ties.rows().size(), 2U);
    const ConstraintTransformation::DependentRow* row = ties.find_row(0);
    ASSERT_NE(row, nullptr);
    ASSERT_EQ(row->terms.size(), 1U);
    EXPECT_DOUBLE_EQ(coefficient(*row, 2), 2.0);
    EXPECT_DOUBLE_EQ(row->constant, 4.0);
  }
}

// Two slaves name the same freedom: the second tie moves on to its next.
TEST(Dependence, SlaveOfTwoTies) {
  const ConstraintTransformation ties(
      {{{{0, 1.0}, {1, -1.0}}, 0.0, 0}, {{{0, 1.0}, {2, -4.0}}, 0.0, 1}}, all_local(3));
  ASSERT_EQ(ties.rows().size(), 2U);
  Vector u(3);
  u << 1.0, 1.0, 1.0;
  ties.set_dependent_displacements(u, 1.0);
  EXPECT_DOUBLE_EQ(u[0], u[1]);
  EXPECT_DOUBLE_EQ(u[0], 4.0 * u[2]);
  EXPECT_NE(u[0], 0.0);
}

TEST(Dependence, CycleClosesOnceAndIsCounted) {
  const ConstraintTransformation ties({{{{0, 1.0}, {1, -1.0}}, 0.0, 0},
                                       {{{1, 1.0}, {2, -1.0}}, 0.0, 1},
                                       {{{2, 1.0}, {0, -1.0}}, 0.0, 2}},
                                      all_local(3));
  EXPECT_EQ(ties.rows().size(), 2U);
  EXPECT_EQ(ties.redundant_tie_count(), 1);
  EXPECT_TRUE(ties.fully_given_ties().empty());
  EXPECT_FALSE(ties.has_constants());
}

// u0 = 2 u1 and u1 = u0 leave only zero: both follow nothing.
TEST(Dependence, CycleThatHoldsItself) {
  const ConstraintTransformation ties(
      {{{{0, 1.0}, {1, -2.0}}, 0.0, 0}, {{{1, 1.0}, {0, -1.0}}, 0.0, 1}}, all_local(2));
  ASSERT_EQ(ties.rows().size(), 2U);
  EXPECT_EQ(ties.redundant_tie_count(), 0);
  EXPECT_TRUE(ties.fully_given_ties().empty());
  Vector u = Vector::Constant(2, 3.0);
  ties.set_dependent_displacements(u, 1.0);
  EXPECT_DOUBLE_EQ(u.cwiseAbs().maxCoeff(), 0.0);
}

TEST(Dependence, ContradictionIsADemand) {
  const ConstraintTransformation ties(
      {{{{0, 1.0}, {1, -1.0}}, 0.0, 0}, {{{1, -3.0}, {0, 3.0}}, 6.0, 4}}, all_local(2));
  EXPECT_EQ(ties.rows().size(), 1U);
  EXPECT_EQ(ties.redundant_tie_count(), 0);
  ASSERT_EQ(ties.fully_given_ties().size(), 1U);
  const ConstraintTransformation::FullyGivenTie& demand = ties.fully_given_ties().front();
  EXPECT_TRUE(demand.terms.empty());
  EXPECT_DOUBLE_EQ(demand.rhs, 6.0);
  EXPECT_GE(demand.scale, 6.0);
  EXPECT_EQ(demand.mpc, 4U);
}

// The same with a right-hand side that agrees but for round-off is only redundant.
TEST(Dependence, RoundOffIsNoContradiction) {
  const ConstraintTransformation ties(
      {{{{0, 3.0}, {1, -1.0}}, 0.1, 0}, {{{0, 0.9}, {1, -0.3}}, 0.03, 1}}, all_local(2));
  EXPECT_EQ(ties.redundant_tie_count(), 1);
  EXPECT_TRUE(ties.fully_given_ties().empty());
}

TEST(Dependence, GivenFreedomsNeverFollow) {
  for (const Cls given : {Cls::suppressed, Cls::prescribed}) {
    std::vector<Cls> cls = all_local(3);
    cls[0] = given;
    const ConstraintTransformation one({{{{0, 2.0}, {1, -1.0}}, 0.0, 0}}, cls);
    ASSERT_EQ(one.rows().size(), 1U);
    EXPECT_EQ(one.find_row(0), nullptr);
    const ConstraintTransformation::DependentRow* row = one.find_row(1);
    ASSERT_NE(row, nullptr);
    EXPECT_DOUBLE_EQ(coefficient(*row, 0), 2.0); // kept: it carries the reaction

    cls[1] = Cls::prescribed;
    const ConstraintTransformation two({{{{0, 2.0}, {1, -1.0}}, 5.0, 3}}, cls);
    EXPECT_TRUE(two.rows().empty());
    ASSERT_EQ(two.fully_given_ties().size(), 1U);
    EXPECT_EQ(two.fully_given_ties().front().terms.size(), 2U);
    EXPECT_DOUBLE_EQ(two.fully_given_ties().front().rhs, 5.0);
    EXPECT_EQ(two.fully_given_ties().front().mpc, 3U);
  }
}

// A chain that ends at two supports asks something of them only.
TEST(Dependence, TiesBetweenSupportsByWayOfOthers) {
  std::vector<Cls> cls = all_local(3);
  cls[0] = cls[2] = Cls::prescribed;
  const ConstraintTransformation ties(
      {{{{1, 1.0}, {0, -1.0}}, 0.0, 0}, {{{1, 1.0}, {2, -3.0}}, 0.0, 1}}, cls);
  EXPECT_EQ(ties.rows().size(), 1U);
  ASSERT_EQ(ties.fully_given_ties().size(), 1U);
  double sum = 0.0; // u0 = 3, u2 = 1 is allowed
  for (const FreedomTerm& t : ties.fully_given_ties().front().terms) {
    sum += t.coefficient * (t.freedom == 0 ? 3.0 : 1.0);
  }
  EXPECT_EQ(ties.fully_given_ties().front().terms.size(), 2U);
  EXPECT_DOUBLE_EQ(sum, ties.fully_given_ties().front().rhs);
}

// 1e-9 u0 + u1 - u2 = 0 solved for u0 would multiply by 1e9.
TEST(Dependence, TinyFirstTermIsNotEliminated) {
  const ConstraintTransformation ties({{{{0, 1e-9}, {1, 1.0}, {2, -0.5}}, 0.0, 0}}, all_local(3));
  EXPECT_EQ(ties.find_row(0), nullptr);
  EXPECT_NE(ties.find_row(1), nullptr);
}

TEST(Dependence, BlocksWithoutDependentFreedomsStayAsTheyAre) {
  const ConstraintTransformation ties({{{{0, 1.0}, {1, -2.0}}, 0.0, 0}}, all_local(4));
  const std::vector<std::int32_t> apart{1, 2, 3};
  EXPECT_FALSE(ties.find_block_transformation(apart).has_value());
  const std::vector<std::int32_t> touched{0, 1, 3};
  const auto block = ties.find_block_transformation(touched);
  ASSERT_TRUE(block.has_value());
  EXPECT_EQ(block->freedom, (std::vector<std::int32_t>{1, 3}));
  Matrix T(3, 2);
  T << 2.0, 0.0, 1.0, 0.0, 0.0, 1.0;
  EXPECT_EQ((Matrix(block->T) - T).norm(), 0.0);
}

// 3000 freedoms in a ring, u_i = c_i u_(i+1) + 1e-3, ties in any order: the last is redundant, or a
// contradiction when its right-hand side is off by a millionth of the others.
TEST(Dependence, LongRing) {
  constexpr std::int32_t n = 3000;
  std::mt19937 random(5);
  Vector u(n);
  for (std::int32_t i = 0; i < n; ++i) {
    u[i] = std::sin(0.1 * i);
  }
  std::vector<Tie> ring;
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t next = (i + 1) % n;
    const double c = i % 2 == 0 ? 1.5 : 1.0 / 1.5;
    ring.push_back({{{i, 1.0}, {next, -c}}, u[i] - c * u[next], static_cast<std::size_t>(i)});
  }
  for (int trial = 0; trial < 3; ++trial) {
    std::shuffle(ring.begin(), ring.end(), random);
    const ConstraintTransformation ties(ring, all_local(n));
    EXPECT_EQ(ties.rows().size(), static_cast<std::size_t>(n - 1));
    EXPECT_EQ(ties.redundant_tie_count(), 1);
    std::vector<Tie> wrong = ring;
    wrong.back().rhs += 1e-6;
    const ConstraintTransformation off(wrong, all_local(n));
    EXPECT_EQ(off.redundant_tie_count(), 0);
    ASSERT_EQ(off.fully_given_ties().size(), 1U);
    const ConstraintTransformation::FullyGivenTie& demand = off.fully_given_ties().front();
    EXPECT_GT(std::abs(demand.rhs), 5e-7);
    EXPECT_GT(std::abs(demand.rhs), 1e-9 * demand.scale); // what a run calls a contradiction
  }
}

} // namespace
} // namespace spricka::fe::test_dependence
