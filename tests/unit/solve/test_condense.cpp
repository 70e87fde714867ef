// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/dense_solve.hpp"
#include "base/parallel.hpp"
#include "solve/condense.hpp"
#include "solve/engine_choice.hpp"
#include "solve/rate.hpp"
#include "spring_net.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace spricka::solve::test_condense {
namespace {

using namespace test_nets;

TEST(Condensation, SchurComplementIsThatOfDenseElimination) {
  for (const OrderingMethod ordering : {OrderingMethod::amd, OrderingMethod::metis}) {
    SpringNet net(14, 0.8);
    const std::int64_t e =
        net.put_last([](int x, int y) { return x == 13 || (x == 6 && y % 3 == 0); });
    const SymmetricCsc K = net.matrix();
    const Condensation c(K, e, {.ordering = ordering});
    ASSERT_EQ(c.report().status, FactorStatus::ok);
    const Matrix S = dense_schur(dense(K), K.n - e);
    EXPECT_LT((c.schur() - S).norm(), 1e-12 * S.norm());
    EXPECT_TRUE(same_bits(c.schur(), c.schur().transpose()));
    EXPECT_GT(c.report().flops, 0.0);
    EXPECT_GT(c.report().factor_entries, static_cast<double>(K.n));
    EXPECT_GT(c.report().memory, 8.0 * c.report().factor_entries);
  }
}

TEST(Condensation, ForecastIsWhatFactorisingReports) {
  for (const bool faces : {false, true}) {
    SpringNet net(24, 1.0);
    const std::int64_t externals = net.put_last([&](int x, int) { return faces && x == 23; });
    const Condensation c(net.matrix(), externals);
    SymmetricCsc pattern = net.matrix();
    std::fill(pattern.value.begin(), pattern.value.end(), 0.0);
    const FactorReport told = Condensation::forecast(std::move(pattern), externals);
    EXPECT_EQ(told.status, FactorStatus::ok);
    EXPECT_EQ(told.flops, c.report().flops);
    EXPECT_EQ(told.factor_entries, c.report().factor_entries);
    EXPECT_EQ(told.memory, c.report().memory);
  }
}

TEST(FlopRate, GrowsWithTheBlocks) {
  const FlopRate rate = measure_flop_rate(0.01);
  EXPECT_GT(rate.measured, 1e7);
  EXPECT_GE(rate.peak, rate.measured);
  EXPECT_LE(rate.at(8.0), rate.at(64.0));
  EXPECT_LE(rate.at(64.0), rate.peak);
}

TEST(Condensation, CondensedLoadAndRecoveredLocalsSolveTheWhole) {
  SpringNet net(12, 1.3);
  const std::int64_t e = net.put_last([](int x, int y) { return y == 11 && x > 2; });
  const SymmetricCsc K = net.matrix();
  const Matrix A = dense(K);
  const std::int64_t l = K.n - e;
  const Matrix f = random_columns(K.n, 5);
  const Condensation c(K, e);
  const Matrix f_e = c.condense_load(f);
  const Matrix expected =
      f.bottomRows(e) -
      A.bottomLeftCorner(e, l) *
          base::solve_square_system(Matrix(A.topLeftCorner(l, l)), Matrix(f.topRows(l)));
  EXPECT_LT((f_e - expected).norm(), 1e-12 * expected.norm());
  const Matrix u = c.recover(base::solve_square_system(Matrix(c.schur()), f_e), f);
  EXPECT_LT((A * u - f).norm(), 1e-12 * A.norm() * u.norm());
  const Matrix whole = base::solve_square_system(A, f);
  EXPECT_LT((u - whole).norm(), 1e-11 * whole.norm());
}

TEST(Condensation, CompliancesOfRowsAreThoseOfTheirHalfSolves) {
  for (const bool faces : {false, true}) {
    SpringNet net(20, faces ? 0.0 : 0.7);
    const std::int64_t e = net.put_last([&](int x, int y) { return faces && x == 19 && y < 9; });
    const SymmetricCsc K = net.matrix();
    const Matrix A = dense(K);
    const std::int64_t l = K.n - e;
    const Condensation c(K, e, {.ordering = OrderingMethod::metis});
    const SparseRightHandSides sparse = random_rows(K.n, 300); // more than one panel
    Matrix F = Matrix::Zero(K.n, 300);
    for (int j = 0; j < 300; ++j) {
      for (std::int64_t p = sparse.start[at(j)]; p < sparse.start[at(j + 1)]; ++p) {
        F(sparse.row[at(p)], j) += sparse.value[at(p)];
      }
    }
    const RowCompliance found = c.compliance_with_externals_held(sparse);
    const Matrix U = base::solve_square_system(Matrix(A.topLeftCorner(l, l)), Matrix(F.topRows(l)));
    const Matrix W = F.topRows(l).transpose() * U;
    EXPECT_LT((found.W - W).norm(), 1e-12 * W.norm());
    EXPECT_TRUE(same_bits(found.W, found.W.transpose()));
    const Matrix left = F.bottomRows(e) - A.bottomLeftCorner(e, l) * U;
    EXPECT_LE((found.condensed - left).norm(), 1e-12 * left.norm());
    EXPECT_TRUE(same_bits(found.W, c.compliance_with_externals_held(sparse).W));
    const FactorReport told =
        Condensation::forecast(K, e, {.ordering = OrderingMethod::metis}, &sparse);
    EXPECT_EQ(told.row_flops, found.flops);
    EXPECT_GT(told.row_memory, 0.0);
  }
}

TEST(Condensation, FloatingBodyNeedsNoSupport) {
  SpringNet net(15, 0.0);
  const std::int64_t e = net.put_last([](int x, int y) { return x == 0 || (y == 0 && x < 9); });
  const SymmetricCsc K = net.matrix();
  const Condensation c(K, e);
  ASSERT_EQ(c.report().status, FactorStatus::ok);
  const Matrix R = net.rigid().bottomRows(e);
  EXPECT_LT((c.schur() * R).cwiseAbs().maxCoeff(), 1e-12 * c.schur().cwiseAbs().maxCoeff());
  const Matrix u = c.recover(R, Matrix::Zero(K.n, 3)); // externals moved rigidly carry the rest
  EXPECT_LT((u - net.rigid()).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(Condensation, SingleExternalFreedomsMayBeSpread) {
  // normals only: one freedom of some nodes, and two whole nodes that carry the body
  SpringNet net(10, 0.0);
  SymmetricCsc K = net.matrix();
  const Matrix A = dense(K);
  std::vector<std::int64_t> order;
  std::vector<std::int64_t> last;
  for (std::int64_t i = 0; i < K.n; ++i) {
    const std::int64_t node = i / 2;
    const bool external = node == 0 || node == 99 || (i % 2 == 0 && node % 10 == 9);
    (external ? last : order).push_back(i);
  }
  const std::int64_t e = static_cast<std::int64_t>(last.size());
  order.insert(order.end(), last.begin(), last.end());
  Matrix P(K.n, K.n);
  SymmetricCsc Kp;
  Kp.n = K.n;
  Kp.start.push_back(0);
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t i = 0; i < K.n; ++i) {
      P(i, j) = A(order[at(i)], order[at(j)]);
      if (i >= j && (i == j || P(i, j) != 0.0)) {
        Kp.row.push_back(i);
        Kp.value.push_back(P(i, j));
      }
    }
    Kp.start.push_back(static_cast<std::int64_t>(Kp.row.size()));
  }
  const Condensation c(Kp, e);
  const Matrix S = dense_schur(P, K.n - e);
  EXPECT_LT((c.schur() - S).norm(), 1e-12 * A.norm());
}

TEST(Condensation, RepeatsToTheLastBit) {
  SpringNet net(20, 0.5);
  const std::int64_t e = net.put_last([](int x, int) { return x == 19; });
  const SymmetricCsc K = net.matrix();
  const Matrix f = random_columns(K.n, 3);
  for (const OrderingMethod ordering : {OrderingMethod::amd, OrderingMethod::metis}) {
    const Condensation a(K, e, {.ordering = ordering});
    const Condensation b(K, e, {.ordering = ordering});
    EXPECT_TRUE(same_bits(a.schur(), b.schur()));
    EXPECT_TRUE(same_bits(a.recover(f.topRows(e), f), b.recover(f.topRows(e), f)));
  }
}

TEST(Condensation, SideBySideGivesTheSameBits) {
  std::vector<SymmetricCsc> K;
  std::vector<std::int64_t> externals;
  for (const int side : {18, 23, 30, 21}) {
    SpringNet net(side, 0.5);
    externals.push_back(net.put_last([side](int x, int) { return x == side - 1; }));
    K.push_back(net.matrix());
  }
  std::vector<Matrix> together(K.size());
  base::parallel_for(K.size(), 4, [&](std::size_t i) {
    together[i] = Condensation(K[i], externals[i], {.ordering = OrderingMethod::metis}).schur();
  });
  for (std::size_t i = 0; i < K.size(); ++i) {
    EXPECT_TRUE(
        same_bits(together[i],
                  Condensation(K[i], externals[i], {.ordering = OrderingMethod::metis}).schur()));
  }
}

TEST(Condensation, WithoutExternalsItSolves) {
  SpringNet net(13, 0.9);
  const SymmetricCsc K = net.matrix();
  const Condensation c(K, 0);
  const Matrix f = random_columns(K.n, 2);
  EXPECT_EQ(c.schur().size(), 0);
  const Matrix u = c.recover(Matrix(0, 2), f);
  EXPECT_LT((dense(K) * u - f).norm(), 1e-12 * dense(K).norm() * u.norm());
  EXPECT_EQ(c.condense_load(f).rows(), 0);
}

TEST(Condensation, WithExternalsOnlyItIsTheMatrix) {
  SpringNet net(6, 0.0);
  const SymmetricCsc K = net.matrix();
  const Condensation c(K, K.n);
  ASSERT_EQ(c.report().status, FactorStatus::ok);
  EXPECT_LT((c.schur() - dense(K)).norm(), 1e-13 * dense(K).norm());
  const Matrix f = random_columns(K.n, 2);
  EXPECT_TRUE(same_bits(c.condense_load(f), f));
  EXPECT_TRUE(same_bits(c.recover(f, f), f));
}

TEST(Condensation, NothingAtAllIsFine) {
  SymmetricCsc K;
  K.start.push_back(0);
  const Condensation c(K, 0);
  EXPECT_EQ(c.report().status, FactorStatus::ok);
  EXPECT_EQ(c.recover(Matrix(0, 1), Matrix(0, 1)).rows(), 0);
}

TEST(Condensation, NamesTheRowWithoutStiffness) {
  SpringNet net(9, 1.0);
  SymmetricCsc K = net.matrix();
  const std::int64_t loose = net.row(4, 7, 1);
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      if (j == loose || K.row[at(p)] == loose) {
        K.value[at(p)] = 0.0;
      }
    }
  }
  const Condensation c(K, 0);
  EXPECT_EQ(c.report().status, FactorStatus::not_positive_definite);
  EXPECT_EQ(c.report().failed_row, loose);
}

TEST(Condensation, UnsupportedBodyIsNotSolvedSilently) {
  for (const int side : {3, 8, 21, 60}) {
    const SymmetricCsc K = SpringNet(side, 0.0).matrix();
    const Condensation c(K, 0);
    EXPECT_EQ(c.report().status, FactorStatus::not_positive_definite) << side;
    EXPECT_GE(c.report().failed_row, 0);
    EXPECT_LT(c.report().failed_row, K.n);
  }
  // a soft ground is enough
  const SymmetricCsc K = SpringNet(21, 1e-6).matrix();
  EXPECT_EQ(Condensation(K, 0).report().status, FactorStatus::ok);
}

TEST(Condensation, NumbersThatAreNoneAreRefused) {
  SymmetricCsc K = SpringNet(5, 1.0).matrix();
  K.value[at(K.start[7])] = std::nan("");
  EXPECT_EQ(Condensation(K, 4).report().status, FactorStatus::not_positive_definite);
}

TEST(Condensation, MovesWithItsFactor) {
  SpringNet net(7, 1.0);
  const SymmetricCsc K = net.matrix();
  Condensation first(K, 4);
  const Matrix f = random_columns(K.n, 1);
  const Matrix u = first.recover(f.topRows(4), f);
  Condensation second(std::move(first));
  EXPECT_TRUE(same_bits(second.recover(f.topRows(4), f), u));
  second = Condensation(K, 4);
  EXPECT_TRUE(same_bits(second.recover(f.topRows(4), f), u));
}

TEST(Engine, IsKnownByItsWordInDecksAndOnTheCommandLine) {
  EXPECT_EQ(base::equation_engine_of_word("mumps"), EquationEngine::mumps);
  EXPECT_EQ(base::equation_engine_of_word("MULTIGRID"), EquationEngine::multigrid);
  EXPECT_FALSE(base::equation_engine_of_word("mump"));
  EXPECT_EQ(base::equation_engine_word(EquationEngine::automatic), "auto");
}

TEST(Engine, IsExplainedWhereThereIsAReason) {
  const SymmetricCsc K = SpringNet(6, 1.0).matrix();
  EXPECT_EQ(explain_engine(Condensation(K, 4).report()), "");
  const Condensation next(K, 4, {.engine_reason = "another has given up"});
  EXPECT_EQ(explain_engine(next.report()), "Cholesky: another has given up");
}

} // namespace
} // namespace spricka::solve::test_condense
