// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parallel.hpp"
#include "solve/engine_choice.hpp"
#include "solve/engine_module.hpp"
#include "solve/sparse_condensation.hpp"
#include "spring_net.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace spricka::solve::test_multigrid {
namespace {

using namespace test_nets;

class Multigrid : public testing::Test {
protected:
  void SetUp() override {
    if (const std::string missing = why_engine_module_is_missing(EngineModule::multigrid);
        !missing.empty()) {
      GTEST_SKIP() << missing;
    }
  }
  static std::unique_ptr<CondensedEquations> condense(SymmetricCsc& K, const SpringBlock& block,
                                                      const Matrix* loads = nullptr) {
    const UnknownPlaces places = block.places();
    CondensationSettings settings;
    settings.places = &places;
    settings.loads = loads;
    return condense_by_module(EngineModule::multigrid, K, block.externals(), settings);
  }
  static std::unique_ptr<CondensedEquations> condense(const SpringBlock& block,
                                                      const Matrix* loads = nullptr) {
    SymmetricCsc K = block.matrix();
    return condense(K, block, loads);
  }
};

double energy(const Matrix& K, const Matrix& u) {
  return u.col(0).dot(K * u.col(0));
}

const ExternalDisplacementSolver nothing_moves = [](const Matrix& load) {
  return Matrix(Matrix::Zero(load.rows(), load.cols()));
};

// All that contact asks of a body, as the factor gives it; the body floats, its externals hold it.
TEST_F(Multigrid, AgreesWithTheFactor) {
  const SpringBlock block{.sides = {6, 6, 8}, .ground = 0.0, .external_layers = 1};
  const Matrix f = random_columns(block.rows(), 2);
  const SparseRightHandSides rows = random_rows(block.rows(), 5);
  const std::unique_ptr<CondensedEquations> own = condense(block);
  SparseCondensation factor(block.matrix(), block.externals());
  ASSERT_EQ(own->report().status, FactorStatus::ok) << own->report().trouble;
  EXPECT_EQ(own->report().engine, EquationEngine::multigrid);
  const Matrix S = own->take_schur();
  const Matrix exact_S = factor.take_schur();
  EXPECT_TRUE(same_bits(S, S.transpose()));
  EXPECT_LT((S - exact_S).norm(), 1e-7 * exact_S.norm());
  EXPECT_LT((own->condense_load(f) - factor.condense_load(f)).norm(), 1e-6 * f.norm());
  const auto follow = [](const Matrix& load) { return Matrix(0.3 * load); };
  const Matrix u = factor.solve(f, follow);
  EXPECT_LT((own->solve(f, follow) - u).norm(), 1e-7 * u.norm());
  const RowCompliance exact = factor.compliance_with_externals_held(rows);
  const RowCompliance found = own->compliance_with_externals_held(rows);
  EXPECT_TRUE(same_bits(found.W, found.W.transpose()));
  EXPECT_LT((found.W - exact.W).norm(), 1e-6 * exact.W.norm());
  EXPECT_LT((found.condensed - exact.condensed).norm(), 1e-6 * exact.condensed.norm());
}

// The error that is stated is none too small: of the load that is worst for it, bent through.
TEST_F(Multigrid, StatesAnErrorThatIsNotExceeded) {
  const SpringBlock block{.sides = {3, 3, 60}};
  Matrix f = Matrix::Zero(block.rows(), 1);
  f(block.rows() - 3, 0) = 1.0;
  const std::unique_ptr<CondensedEquations> own = condense(block);
  ASSERT_EQ(own->report().status, FactorStatus::ok) << own->report().trouble;
  const SparseCondensation factor(block.matrix(), 0);
  const Matrix u = factor.solve(f, nothing_moves);
  const Matrix error = own->solve(f, nothing_moves) - u;
  const Matrix K = dense(block.matrix());
  EXPECT_LE(std::sqrt(energy(K, error) / energy(K, u)), 1e-8);
  EXPECT_GT(own->report().relative_error, 0.0);
}

// Loads that were announced, and what is combined of them, are known already.
TEST_F(Multigrid, CombinesWhatItKnows) {
  const SpringBlock block{.sides = {8, 8, 8}};
  const Matrix loads = random_columns(block.rows(), 2);
  const std::unique_ptr<CondensedEquations> own = condense(block, &loads);
  ASSERT_EQ(own->report().status, FactorStatus::ok) << own->report().trouble;
  const double flops = own->report().flops;
  const Matrix both = 2.0 * loads.col(0) - 0.5 * loads.col(1);
  const Matrix u = own->solve(both, nothing_moves);
  EXPECT_EQ(own->report().flops, flops);
  const Matrix exact = SparseCondensation(block.matrix(), 0).solve(both, nothing_moves);
  EXPECT_LT((u - exact).norm(), 1e-7 * exact.norm());
}

TEST_F(Multigrid, GivesTheSameBitsAgainAndBesideOthers) {
  const SpringBlock block{.sides = {7, 6, 9}, .external_layers = 1};
  const Matrix f = random_columns(block.rows(), 1);
  std::array<Matrix, 5> u;
  const auto solve = [&](std::size_t i) { u.at(i) = condense(block)->solve(f, nothing_moves); };
  solve(0);
  base::parallel_for(4, 4, [&](std::size_t i) { solve(i + 1); });
  for (std::size_t i = 1; i < u.size(); ++i) {
    EXPECT_TRUE(same_bits(u.at(i), u[0])) << i;
  }
}

TEST_F(Multigrid, NamesWhatNothingHolds) {
  const SpringBlock loose{.sides = {5, 5, 5}, .ground = 0.0};
  EXPECT_EQ(condense(loose)->report().status, FactorStatus::not_positive_definite);
  const SpringBlock corner{.sides = {5, 5, 5}, .ground = 1e-18, .loose_corner = true};
  EXPECT_EQ(condense(corner)->report().status, FactorStatus::not_positive_definite);
}

// What it refuses the next engine gets as it was.
TEST_F(Multigrid, PutsTheMatrixBack) {
  const SpringBlock block{.sides = {4, 4, 5}, .external_layers = 1};
  const SymmetricCsc whole = block.matrix();
  CondensationSettings settings;
  SymmetricCsc K = whole;
  auto refused = condense_by_module(EngineModule::multigrid, K, block.externals(), settings);
  EXPECT_EQ(refused->report().status, FactorStatus::engine_failed); // it does not know the nodes
  EXPECT_EQ(K.value, whole.value);

  const UnknownPlaces places = block.places();
  settings.places = &places;
  settings.besides = 1e18;
  refused = condense_by_module(EngineModule::multigrid, K, block.externals(), settings);
  EXPECT_EQ(refused->report().status, FactorStatus::out_of_memory);
  EXPECT_EQ(K.value, whole.value);
}

// Cells a thousand times as long as they are thick, of springs along their sides.
TEST_F(Multigrid, RefusesWhatTakesTooLong) {
  const SpringBlock needle{.sides = {4, 4, 700}, .external_layers = 1, .stretch = 0.002};
  SymmetricCsc K = needle.matrix();
  const SymmetricCsc whole = K;
  const std::unique_ptr<CondensedEquations> own = condense(K, needle);
  ASSERT_EQ(own->report().status, FactorStatus::engine_failed);
  EXPECT_NE(own->report().trouble.find("iterations"), std::string::npos);
  SparseCondensation factor(std::move(K), needle.externals());
  SparseCondensation exact(whole, needle.externals());
  EXPECT_LT((factor.take_schur() - exact.take_schur()).norm(), 1e-12);
}

} // namespace
} // namespace spricka::solve::test_multigrid
