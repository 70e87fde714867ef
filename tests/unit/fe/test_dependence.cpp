// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/dependence.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

// Ties solved for by hand in small cases, and by a dense null space in random ones.
namespace spricka::fe {
namespace {

using base::Matrix;
using base::Vector;
using Cls = model::FreedomClass;

std::vector<Cls> all_local(std::size_t n) {
  return std::vector<Cls>(n, Cls::local);
}

double coefficient(const Dependence::Row& row, std::int32_t freedom) {
  for (const Term& t : row.terms) {
    if (t.freedom == freedom) {
      return t.coefficient;
    }
  }
  return 0.0;
}

TEST(Dependence, FirstTermFollowsTheOthers) {
  // 2 u1 - 3 u0 + u3 = 5
  const Dependence ties({{{{1, 2.0}, {0, -3.0}, {3, 1.0}}, 5.0, 7}}, all_local(4));
  ASSERT_EQ(ties.rows().size(), 1U);
  const Dependence::Row* row = ties.row_of(1);
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->mpc, 7U);
  EXPECT_EQ(row->terms.size(), 2U);
  EXPECT_DOUBLE_EQ(coefficient(*row, 0), 1.5);
  EXPECT_DOUBLE_EQ(coefficient(*row, 3), -0.5);
  EXPECT_DOUBLE_EQ(row->constant, 2.5);
  EXPECT_TRUE(ties.has_constants());
  EXPECT_EQ(ties.row_of(0), nullptr);
  EXPECT_EQ(ties.redundant(), 0);

  Vector u(4);
  u << 4.0, 99.0, 6.0, 2.0;
  ties.follow(u, 1.0);
  EXPECT_DOUBLE_EQ(u[1], 1.5 * 4.0 - 0.5 * 2.0 + 2.5);
  ties.follow(u, 0.0); // the constant belongs to one vector only
  EXPECT_DOUBLE_EQ(u[1], 1.5 * 4.0 - 0.5 * 2.0);
  EXPECT_DOUBLE_EQ(u[2], 6.0);
}

// u0 = u1 + 1, u1 = 2 u2 + 3 in either order: u0 = 2 u2 + 4.
TEST(Dependence, SlaveOfOneTieIsMasterOfAnother) {
  const Tie a{{{0, 1.0}, {1, -1.0}}, 1.0, 0};
  const Tie b{{{1, 1.0}, {2, -2.0}}, 3.0, 1};
  for (const std::vector<Tie>& order : {std::vector<Tie>{a, b}, std::vector<Tie>{b, a}}) {
    const Dependence ties(order, all_local(3));
    ASSERT_EQ(ties.rows().size(), 2U);
    const Dependence::Row* row = ties.row_of(0);
    ASSERT_NE(row, nullptr);
    ASSERT_EQ(row->terms.size(), 1U);
    EXPECT_DOUBLE_EQ(coefficient(*row, 2), 2.0);
    EXPECT_DOUBLE_EQ(row->constant, 4.0);
  }
}

// Two slaves name the same freedom: the second tie moves on to its next.
TEST(Dependence, SlaveOfTwoTies) {
  const Dependence ties({{{{0, 1.0}, {1, -1.0}}, 0.0, 0}, {{{0, 1.0}, {2, -4.0}}, 0.0, 1}},
                        all_local(3));
  ASSERT_EQ(ties.rows().size(), 2U);
  Vector u(3);
  u << 1.0, 1.0, 1.0;
  ties.follow(u, 1.0);
  EXPECT_DOUBLE_EQ(u[0], u[1]);
  EXPECT_DOUBLE_EQ(u[0], 4.0 * u[2]);
  EXPECT_NE(u[0], 0.0);
}

TEST(Dependence, CycleClosesOnceAndIsCounted) {
  const Dependence ties({{{{0, 1.0}, {1, -1.0}}, 0.0, 0},
                         {{{1, 1.0}, {2, -1.0}}, 0.0, 1},
                         {{{2, 1.0}, {0, -1.0}}, 0.0, 2}},
                        all_local(3));
  EXPECT_EQ(ties.rows().size(), 2U);
  EXPECT_EQ(ties.redundant(), 1);
  EXPECT_TRUE(ties.demands().empty());
  EXPECT_FALSE(ties.has_constants());
}

// u0 = 2 u1 and u1 = u0 leave only zero: both follow nothing.
TEST(Dependence, CycleThatHoldsItself) {
  const Dependence ties({{{{0, 1.0}, {1, -2.0}}, 0.0, 0}, {{{1, 1.0}, {0, -1.0}}, 0.0, 1}},
                        all_local(2));
  ASSERT_EQ(ties.rows().size(), 2U);
  EXPECT_EQ(ties.redundant(), 0);
  EXPECT_TRUE(ties.demands().empty());
  Vector u = Vector::Constant(2, 3.0);
  ties.follow(u, 1.0);
  EXPECT_DOUBLE_EQ(u.cwiseAbs().maxCoeff(), 0.0);
}

TEST(Dependence, ContradictionIsADemand) {
  const Dependence ties({{{{0, 1.0}, {1, -1.0}}, 0.0, 0}, {{{1, -3.0}, {0, 3.0}}, 6.0, 4}},
                        all_local(2));
  EXPECT_EQ(ties.rows().size(), 1U);
  EXPECT_EQ(ties.redundant(), 0);
  ASSERT_EQ(ties.demands().size(), 1U);
  const Dependence::Demand& demand = ties.demands().front();
  EXPECT_TRUE(demand.terms.empty());
  EXPECT_DOUBLE_EQ(demand.rhs, 6.0);
  EXPECT_GE(demand.scale, 6.0);
  EXPECT_EQ(demand.mpc, 4U);
}

// The same with a right-hand side that agrees but for round-off is only redundant.
TEST(Dependence, RoundOffIsNoContradiction) {
  const Dependence ties({{{{0, 3.0}, {1, -1.0}}, 0.1, 0}, {{{0, 0.9}, {1, -0.3}}, 0.03, 1}},
                        all_local(2));
  EXPECT_EQ(ties.redundant(), 1);
  EXPECT_TRUE(ties.demands().empty());
}

TEST(Dependence, GivenFreedomsNeverFollow) {
  for (const Cls given : {Cls::suppressed, Cls::prescribed}) {
    std::vector<Cls> cls = all_local(3);
    cls[0] = given;
    const Dependence one({{{{0, 2.0}, {1, -1.0}}, 0.0, 0}}, cls);
    ASSERT_EQ(one.rows().size(), 1U);
    EXPECT_EQ(one.row_of(0), nullptr);
    const Dependence::Row* row = one.row_of(1);
    ASSERT_NE(row, nullptr);
    EXPECT_DOUBLE_EQ(coefficient(*row, 0), 2.0); // kept: it carries the reaction

    cls[1] = Cls::prescribed;
    const Dependence two({{{{0, 2.0}, {1, -1.0}}, 5.0, 3}}, cls);
    EXPECT_TRUE(two.rows().empty());
    ASSERT_EQ(two.demands().size(), 1U);
    EXPECT_EQ(two.demands().front().terms.size(), 2U);
    EXPECT_DOUBLE_EQ(two.demands().front().rhs, 5.0);
    EXPECT_EQ(two.demands().front().mpc, 3U);
  }
}

// A chain that ends at two supports asks something of them only.
TEST(Dependence, TiesBetweenSupportsByWayOfOthers) {
  std::vector<Cls> cls = all_local(3);
  cls[0] = cls[2] = Cls::prescribed;
  const Dependence ties({{{{1, 1.0}, {0, -1.0}}, 0.0, 0}, {{{1, 1.0}, {2, -3.0}}, 0.0, 1}}, cls);
  EXPECT_EQ(ties.rows().size(), 1U);
  ASSERT_EQ(ties.demands().size(), 1U);
  double sum = 0.0; // u0 = 3, u2 = 1 is allowed
  for (const Term& t : ties.demands().front().terms) {
    sum += t.coefficient * (t.freedom == 0 ? 3.0 : 1.0);
  }
  EXPECT_EQ(ties.demands().front().terms.size(), 2U);
  EXPECT_DOUBLE_EQ(sum, ties.demands().front().rhs);
}

// 1e-9 u0 + u1 - u2 = 0 solved for u0 would multiply by 1e9.
TEST(Dependence, TinyFirstTermIsNotEliminated) {
  const Dependence ties({{{{0, 1e-9}, {1, 1.0}, {2, -0.5}}, 0.0, 0}}, all_local(3));
  EXPECT_EQ(ties.row_of(0), nullptr);
  EXPECT_NE(ties.row_of(1), nullptr);
}

TEST(Dependence, BlocksWithoutDependentFreedomsStayAsTheyAre) {
  const Dependence ties({{{{0, 1.0}, {1, -2.0}}, 0.0, 0}}, all_local(4));
  const std::vector<std::int32_t> apart{1, 2, 3};
  EXPECT_FALSE(ties.block_of(apart).has_value());
  const std::vector<std::int32_t> touched{0, 1, 3};
  const auto block = ties.block_of(touched);
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
    const Dependence ties(ring, all_local(n));
    EXPECT_EQ(ties.rows().size(), static_cast<std::size_t>(n - 1));
    EXPECT_EQ(ties.redundant(), 1);
    std::vector<Tie> wrong = ring;
    wrong.back().rhs += 1e-6;
    const Dependence off(wrong, all_local(n));
    EXPECT_EQ(off.redundant(), 0);
    ASSERT_EQ(off.demands().size(), 1U);
    const Dependence::Demand& demand = off.demands().front();
    EXPECT_GT(std::abs(demand.rhs), 5e-7);
    EXPECT_GT(std::abs(demand.rhs), 1e-9 * demand.scale); // what a run calls a contradiction
  }
}

/// Ties that a hidden vector `u` satisfies, some of them combinations of others.
struct System {
  std::vector<Tie> ties;
  std::vector<Cls> cls;
  Vector u;

  [[nodiscard]] std::size_t size() const { return cls.size(); }
  [[nodiscard]] Matrix matrix() const {
    Matrix A = Matrix::Zero(static_cast<Eigen::Index>(ties.size()), u.size());
    for (std::size_t i = 0; i < ties.size(); ++i) {
      for (const Term& t : ties[i].terms) {
        A(static_cast<Eigen::Index>(i), t.freedom) += t.coefficient;
      }
    }
    return A;
  }
};

class RandomTies {
public:
  explicit RandomTies(unsigned seed) : random_(seed) {}

  System make(double share_given) {
    System system;
    const std::size_t n = 4 + pick(30);
    const std::size_t m = 1 + pick(n);
    system.u = Vector::NullaryExpr(static_cast<Eigen::Index>(n), [&] { return number(); });
    for (std::size_t i = 0; i < n; ++i) {
      const bool given = 0.5 * (number() + 1.0) < share_given;
      system.cls.push_back(given ? (pick(2) == 0 ? Cls::suppressed : Cls::prescribed)
                                 : (pick(3) == 0 ? Cls::external : Cls::local));
    }
    for (std::size_t i = 0; i < m; ++i) {
      add(system, i >= 2 && pick(4) == 0);
    }
    return system;
  }

  double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  std::size_t pick(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
  }

private:
  void add(System& system, bool combined) {
    Vector c = Vector::Zero(static_cast<Eigen::Index>(system.size()));
    if (combined) {
      const double factor = number();
      for (const auto& [which, times] :
           {std::pair{pick(system.ties.size()), 1.0}, {pick(system.ties.size()), factor}}) {
        for (const Term& t : system.ties[which].terms) {
          c[t.freedom] += times * t.coefficient;
        }
      }
    } else {
      for (std::size_t k = 0; k < 2 + pick(3); ++k) {
        c[static_cast<Eigen::Index>(pick(system.size()))] = pick(2) == 0 ? 1.0 : number();
      }
    }
    Tie tie;
    tie.mpc = system.ties.size();
    tie.rhs = c.dot(system.u);
    for (Eigen::Index i = 0; i < c.size(); ++i) {
      if (c[i] != 0.0) {
        tie.terms.push_back({static_cast<std::int32_t>(i), c[i]});
      }
    }
    if (tie.terms.empty()) {
      return;
    }
    std::shuffle(tie.terms.begin(), tie.terms.end(), random_);
    system.ties.push_back(std::move(tie));
  }

  std::mt19937 random_;
};

Matrix free_columns(const System& system) {
  Matrix A = system.matrix();
  for (std::size_t i = 0; i < system.size(); ++i) {
    if (system.cls[i] == Cls::suppressed || system.cls[i] == Cls::prescribed) {
      A.col(static_cast<Eigen::Index>(i)).setZero();
    }
  }
  return A;
}

// Given freedoms as in the hidden vector, the others at random, dependent ones following.
Vector some_motion(const System& system, const Dependence& ties, RandomTies& random) {
  Vector u = system.u;
  for (std::size_t i = 0; i < system.size(); ++i) {
    if (system.cls[i] == Cls::local || system.cls[i] == Cls::external) {
      u[static_cast<Eigen::Index>(i)] = random.number();
    }
  }
  ties.follow(u, 1.0);
  return u;
}

void expect_solved(const System& system, const Dependence& ties, RandomTies& random) {
  Eigen::FullPivLU<Matrix> lu(free_columns(system));
  lu.setThreshold(1e-9);
  EXPECT_EQ(static_cast<Eigen::Index>(ties.rows().size()), lu.rank());
  EXPECT_EQ(ties.rows().size() + ties.demands().size() + static_cast<std::size_t>(ties.redundant()),
            system.ties.size());
  for (const Dependence::Row& row : ties.rows()) {
    for (const Term& t : row.terms) {
      EXPECT_EQ(ties.row_of(t.freedom), nullptr);
    }
  }
  for (const Dependence::Demand& demand : ties.demands()) {
    double sum = -demand.rhs;
    for (const Term& t : demand.terms) {
      sum += t.coefficient * system.u[t.freedom];
    }
    EXPECT_NEAR(sum, 0.0, 1e-10);
  }
  const Matrix A = system.matrix();
  for (int trial = 0; trial < 3; ++trial) {
    const Vector u = some_motion(system, ties, random);
    const double size = std::max(1.0, u.lpNorm<Eigen::Infinity>());
    EXPECT_LT((A * (u - system.u)).lpNorm<Eigen::Infinity>(), 1e-10 * size);
  }
}

TEST(Dependence, RandomSystemsHaveTheWholeNullSpace) {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    RandomTies random(seed);
    const System system = random.make(0.0);
    const Dependence ties(system.ties, system.cls);
    expect_solved(system, ties, random);
    EXPECT_TRUE(ties.demands().empty());
    if (HasFailure()) {
      return;
    }
  }
}

TEST(Dependence, RandomSystemsWithSupports) {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    RandomTies random(seed);
    const System system = random.make(0.25);
    const Dependence ties(system.ties, system.cls);
    expect_solved(system, ties, random);
    for (const Dependence::Row& row : ties.rows()) {
      const Cls cls = system.cls[static_cast<std::size_t>(row.freedom)];
      EXPECT_TRUE(cls == Cls::local || cls == Cls::external);
    }
    if (HasFailure()) {
      return;
    }
  }
}

// f . T w = T^T f . w, with T from follow, from reduce and from block_of.
TEST(Dependence, ReduceAndBlocksAreTheTransposeOfFollow) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    RandomTies random(seed);
    const System system = random.make(0.1);
    const Dependence ties(system.ties, system.cls);
    const Eigen::Index n = system.u.size();
    const auto any = [&] { return random.number(); };
    const Vector w = Vector::NullaryExpr(n, any);
    Vector moved = w;
    ties.follow(moved, 0.0);
    Matrix f = Matrix::NullaryExpr(n, 2, any);
    Matrix reduced = f;
    ties.reduce(reduced);
    const double size = std::max(1.0, moved.norm()) * f.norm();
    for (Eigen::Index c = 0; c < 2; ++c) {
      EXPECT_NEAR(f.col(c).dot(moved), reduced.col(c).dot(w), 1e-13 * size);
    }
    std::vector<std::int32_t> some;
    for (std::size_t i = 0; i < system.size(); ++i) {
      if (random.pick(2) == 0) {
        some.push_back(static_cast<std::int32_t>(i));
      }
    }
    const bool touched = std::any_of(some.begin(), some.end(),
                                     [&](std::int32_t i) { return ties.row_of(i) != nullptr; });
    const auto block = ties.block_of(some);
    ASSERT_EQ(block.has_value(), touched);
    if (!touched) {
      continue;
    }
    EXPECT_LT((Vector(moved(some)) - block->T * Vector(w(block->freedom))).norm(), 1e-13 * size);
    Matrix part = Matrix::Zero(n, 1);
    part(some, 0) = f(some, 0);
    const Vector by_block = block->T.transpose() * Vector(part(some, 0));
    ties.reduce(part);
    EXPECT_LT((Vector(part(block->freedom, 0)) - by_block).norm(), 1e-13 * size);
    EXPECT_NEAR(part.norm(), by_block.norm(), 1e-13 * size); // nothing elsewhere
    if (HasFailure()) {
      return;
    }
  }
}

} // namespace
} // namespace spricka::fe
