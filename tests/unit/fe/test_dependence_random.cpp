// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/dependence.hpp"
#include "model/freedoms.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

// Random ties against a dense null space.
namespace spricka::fe::test_dependence_random {
namespace {

using base::Matrix;
using base::Vector;
using Cls = model::FreedomRole;

/// Ties that a hidden vector `u` satisfies, some of them combinations of others.
struct System {
  std::vector<Tie> ties;
  std::vector<Cls> cls;
  Vector u;

  [[nodiscard]] std::size_t size() const { return cls.size(); }
  [[nodiscard]] Matrix matrix() const {
    Matrix A = Matrix::Zero(static_cast<Eigen::Index>(ties.size()), u.size());
    for (std::size_t i = 0; i < ties.size(); ++i) {
      for (const FreedomTerm& t : ties[i].terms) {
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
        for (const FreedomTerm& t : system.ties[which].terms) {
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
Vector some_motion(const System& system, const ConstraintTransformation& ties, RandomTies& random) {
  Vector u = system.u;
  for (std::size_t i = 0; i < system.size(); ++i) {
    if (system.cls[i] == Cls::local || system.cls[i] == Cls::external) {
      u[static_cast<Eigen::Index>(i)] = random.number();
    }
  }
  ties.set_dependent_displacements(u, 1.0);
  return u;
}

void expect_solved(const System& system, const ConstraintTransformation& ties, RandomTies& random) {
  Eigen::FullPivLU<Matrix> lu(free_columns(system));
  lu.setThreshold(1e-9);
  EXPECT_EQ(static_cast<Eigen::Index>(ties.rows().size()), lu.rank());
  EXPECT_EQ(ties.rows().size() + ties.fully_given_ties().size() +
                static_cast<std::size_t>(ties.redundant_tie_count()),
            system.ties.size());
  for (const ConstraintTransformation::DependentRow& row : ties.rows()) {
    for (const FreedomTerm& t : row.terms) {
      EXPECT_EQ(ties.find_row(t.freedom), nullptr);
    }
  }
  for (const ConstraintTransformation::FullyGivenTie& demand : ties.fully_given_ties()) {
    double sum = -demand.rhs;
    for (const FreedomTerm& t : demand.terms) {
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

TEST(RandomDependence, RandomSystemsHaveTheWholeNullSpace) {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    RandomTies random(seed);
    const System system = random.make(0.0);
    const ConstraintTransformation ties(system.ties, system.cls);
    expect_solved(system, ties, random);
    EXPECT_TRUE(ties.fully_given_ties().empty());
    if (HasFailure()) {
      return;
    }
  }
}

TEST(RandomDependence, RandomSystemsWithSupports) {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    RandomTies random(seed);
    const System system = random.make(0.25);
    const ConstraintTransformation ties(system.ties, system.cls);
    expect_solved(system, ties, random);
    for (const ConstraintTransformation::DependentRow& row : ties.rows()) {
      const Cls cls = system.cls[static_cast<std::size_t>(row.freedom)];
      EXPECT_TRUE(cls == Cls::local || cls == Cls::external);
    }
    if (HasFailure()) {
      return;
    }
  }
}

// f . T w = T^T f . w, with T from follow, from reduce and from block_of.
TEST(RandomDependence, ReduceAndBlocksAreTheTransposeOfFollow) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    RandomTies random(seed);
    const System system = random.make(0.1);
    const ConstraintTransformation ties(system.ties, system.cls);
    const Eigen::Index n = system.u.size();
    const auto any = [&] { return random.number(); };
    const Vector w = Vector::NullaryExpr(n, any);
    Vector moved = w;
    ties.set_dependent_displacements(moved, 0.0);
    Matrix f = Matrix::NullaryExpr(n, 2, any);
    Matrix reduced = f;
    ties.transfer_forces_to_masters(reduced);
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
                                     [&](std::int32_t i) { return ties.find_row(i) != nullptr; });
    const auto block = ties.find_block_transformation(some);
    ASSERT_EQ(block.has_value(), touched);
    if (!touched) {
      continue;
    }
    EXPECT_LT((Vector(moved(some)) - block->T * Vector(w(block->freedom))).norm(), 1e-13 * size);
    Matrix part = Matrix::Zero(n, 1);
    part(some, 0) = f(some, 0);
    const Vector by_block = block->T.transpose() * Vector(part(some, 0));
    ties.transfer_forces_to_masters(part);
    EXPECT_LT((Vector(part(block->freedom, 0)) - by_block).norm(), 1e-13 * size);
    EXPECT_NEAR(part.norm(), by_block.norm(), 1e-13 * size); // nothing elsewhere
    if (HasFailure()) {
      return;
    }
  }
}

} // namespace
} // namespace spricka::fe::test_dependence_random
