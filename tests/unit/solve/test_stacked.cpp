// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/dense_solve.hpp"
#include "solve/condense.hpp"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <random>
#include <vector>

// Dense blocks on top of a sparse matrix against the dense elimination of their sum.
namespace spricka::solve::test_stacked {
namespace {

using base::Matrix;

struct Sum {
  base::SymmetricCsc K;
  Matrix block;
  std::vector<std::int64_t> rows; ///< of the block; one has none
  Matrix whole;
};

// A chain of 30 springs to the ground, its last rows and 6 that it does not reach under the block.
Sum chain_and_block(double ground) {
  constexpr std::int64_t chain = 30;
  constexpr std::int64_t n = 36;
  Sum sum;
  sum.whole = Matrix::Zero(n, n);
  sum.K.n = n;
  sum.K.start = {0};
  for (std::int64_t j = 0; j < n; ++j) {
    const bool linked = j + 1 < chain;
    sum.K.row.push_back(j);
    sum.K.value.push_back(j < chain ? ground + (linked ? 2.0 : 1.0) + (j == 0 ? -1.0 : 0.0) : 0.0);
    sum.whole(j, j) = sum.K.value.back();
    if (linked) {
      sum.K.row.push_back(j + 1);
      sum.K.value.push_back(-1.0);
      sum.whole(j + 1, j) = sum.whole(j, j + 1) = -1.0;
    }
    sum.K.start.push_back(static_cast<std::int64_t>(sum.K.row.size()));
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  sum.rows = {26, -1, 27, 30, 31, 32, 33, 34, 35};
  const auto m = static_cast<Eigen::Index>(sum.rows.size());
  const Matrix A = Matrix::NullaryExpr(m, 2 * m, [&] { return value(random); });
  sum.block = A * A.transpose();
  for (Eigen::Index c = 0; c < m; ++c) {
    for (Eigen::Index r = 0; r < m; ++r) {
      const std::int64_t i = sum.rows[static_cast<std::size_t>(r)];
      const std::int64_t j = sum.rows[static_cast<std::size_t>(c)];
      if (i >= 0 && j >= 0) {
        sum.whole(i, j) += sum.block(r, c);
      }
    }
  }
  return sum;
}

TEST(TwoLevelCondensation, IsTheDenseEliminationOfTheSum) {
  const Sum sum = chain_and_block(0.1);
  for (const std::int64_t e : {0, 4, 9}) {
    const std::vector<CondensedNetBlock> blocks{{sum.rows, &sum.block}};
    const Condensation c(sum.K, e, blocks);
    ASSERT_EQ(c.report().status, FactorStatus::ok);
    const std::int64_t l = sum.K.n - e;
    const Matrix coupling = sum.whole.topRightCorner(l, e);
    const Matrix S = sum.whole.bottomRightCorner(e, e) -
                     coupling.transpose() *
                         base::solve_square_system(Matrix(sum.whole.topLeftCorner(l, l)), coupling);
    EXPECT_LE((c.schur() - S).norm(), 1e-12 * (1.0 + S.norm()));
    EXPECT_EQ((c.schur() - c.schur().transpose()).norm(), 0.0);
    // loads condensed and displacements recovered are those of the whole
    const Matrix f = Matrix::Random(sum.K.n, 2);
    const Matrix u = base::solve_square_system(sum.whole, f);
    EXPECT_LE((S * u.bottomRows(e) - c.condense_load(f)).norm(), 1e-10);
    EXPECT_LE((c.recover(u.bottomRows(e), f) - u).norm(), 1e-10 * u.norm());
    const FactorReport told = Condensation::forecast(sum.K, e, blocks);
    EXPECT_EQ(told.flops, c.report().flops);
    EXPECT_EQ(told.memory, c.report().memory);
  }
}

// The factor that stands in for S, its early rows kept from one matrix for the next.
TEST(TwoLevelCondensation, EarlyRowsAreEliminatedOnceForAll) {
  constexpr std::int64_t e = 9;
  std::shared_ptr<const FirstBlockFactor> kept;
  const FirstBlockFactor* first = nullptr;
  EarlyLateRowPartition told_lists;
  for (const double ground : {0.1, 0.7}) {
    const Sum sum = chain_and_block(ground);
    const std::vector<CondensedNetBlock> blocks{{sum.rows, &sum.block}};
    Condensation c(sum.K, e, blocks, &kept);
    ASSERT_EQ(c.report().status, FactorStatus::ok);
    EXPECT_EQ(c.schur().size(), 0);
    const std::optional<FactoredSchurComplement> own = c.take_factored_schur();
    ASSERT_TRUE(own && own->L.is_positive_definite());
    EXPECT_EQ(own->L.first_block_size(), 6); // rows 30 to 35
    first = first == nullptr ? kept.get() : first;
    EXPECT_EQ(own->L.first_block().get(), first);
    // S^-1 F, as the elimination of the whole gives it
    const Matrix F = Matrix::Random(e, 3);
    Matrix f = Matrix::Zero(sum.K.n, 3);
    f.bottomRows(e) = F;
    const Matrix u = base::solve_square_system(sum.whole, f);
    Matrix g = Matrix::Zero(own->L.size(), 3);
    g(own->row, Eigen::all) = F;
    EXPECT_LE((own->L.solve(g)(own->row, Eigen::all) - u.bottomRows(e)).norm(), 1e-10 * u.norm());
    const Matrix Y = own->L.forward_substitute(g);
    EXPECT_LE((Y.transpose() * Y - F.transpose() * u.bottomRows(e)).norm(), 1e-10 * u.norm());
    // loads condensed and displacements recovered as ever
    const Condensation plain(sum.K, e, blocks);
    const Matrix load = Matrix::Random(sum.K.n, 2);
    EXPECT_LE((c.condense_load(load) - plain.condense_load(load)).norm(), 1e-12 * load.norm());
    const Matrix all = plain.recover(F.leftCols(2), load);
    EXPECT_LE((c.recover(F.leftCols(2), load) - all).norm(), 1e-12 * all.norm());
    // made anew: the same bits
    std::shared_ptr<const FirstBlockFactor> none;
    Condensation anew(sum.K, e, blocks, &none);
    EXPECT_EQ((anew.take_factored_schur()->L.forward_substitute(g) - Y).cwiseAbs().maxCoeff(), 0.0);
    const FactorReport told = Condensation::forecast(sum.K, e, blocks, &told_lists);
    EXPECT_EQ(told.flops, c.report().flops);
    EXPECT_EQ(told.memory, c.report().memory);
    // what was eliminated before is not counted again
    EXPECT_EQ(c.report().flops < anew.report().flops, ground == 0.7);
  }
}

// An element of which one freedom is left adds to the diagonal alone: that row is not early.
TEST(TwoLevelCondensation, ASpringOnARowOfTheBlockIsNotLost) {
  Sum sum = chain_and_block(0.1);
  const auto start = static_cast<std::size_t>(sum.K.start[33]);
  sum.K.value[start] = 2.5;
  sum.whole(33, 33) += 2.5;
  const std::vector<CondensedNetBlock> blocks{{sum.rows, &sum.block}};
  std::shared_ptr<const FirstBlockFactor> kept;
  Condensation c(sum.K, 9, blocks, &kept);
  const std::optional<FactoredSchurComplement> own = c.take_factored_schur();
  ASSERT_TRUE(own && own->L.is_positive_definite());
  EXPECT_EQ(own->L.first_block_size(), 5);
  Matrix f = Matrix::Zero(sum.K.n, 9);
  f.bottomRows(9).setIdentity();
  Matrix g = Matrix::Zero(own->L.size(), 9);
  g(own->row, Eigen::all) = Matrix::Identity(9, 9);
  const Matrix u = base::solve_square_system(sum.whole, f).bottomRows(9);
  EXPECT_LE((own->L.solve(g)(own->row, Eigen::all) - u).norm(), 1e-10 * u.norm());
}

// Early rows that only the rest of the body would hold: S as ever.
TEST(TwoLevelCondensation, ABlockThatDoesNotHoldItsRowsGivesS) {
  Sum sum = chain_and_block(0.1);
  const auto weak = static_cast<Eigen::Index>(sum.rows.size()) - 1; // row 35 hangs on nothing
  sum.block.row(weak).setZero();
  sum.block.col(weak).setZero();
  const std::vector<CondensedNetBlock> blocks{{sum.rows, &sum.block}};
  std::shared_ptr<const FirstBlockFactor> kept;
  Condensation c(sum.K, 9, blocks, &kept);
  ASSERT_EQ(c.report().status, FactorStatus::ok);
  EXPECT_FALSE(c.take_factored_schur());
  const Condensation plain(sum.K, 9, blocks);
  EXPECT_EQ((c.schur() - plain.schur()).cwiseAbs().maxCoeff(), 0.0);
}

TEST(TwoLevelCondensation, ABlockThatHoldsNothingIsNamed) {
  Sum sum = chain_and_block(0.1);
  sum.block.row(4).setZero(); // row 31
  sum.block.col(4).setZero();
  const std::vector<CondensedNetBlock> blocks{{sum.rows, &sum.block}};
  const Condensation c(sum.K, 2, blocks);
  EXPECT_EQ(c.report().status, FactorStatus::not_positive_definite);
  EXPECT_EQ(c.report().failed_row, 31);
}

TEST(TwoLevelCondensation, PaysWhereTheBlockFillsTheTop) {
  const Sum sum = chain_and_block(0.1);
  EXPECT_TRUE(
      is_two_level_cheaper(std::vector<CondensedNetBlock>{{sum.rows, nullptr}}, sum.K.n, 4));
  EXPECT_FALSE(
      is_two_level_cheaper(std::vector<CondensedNetBlock>{{{30, 31}, nullptr}}, sum.K.n, 20));
  EXPECT_FALSE(is_two_level_cheaper({}, sum.K.n, 4));
}

} // namespace
} // namespace spricka::solve::test_stacked
