// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ready_queue.hpp"
#include "solve/condense.hpp"
#include "spring_net.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <gtest/gtest.h>
#include <stdexcept>
#include <vector>

namespace spricka::solve::test_factor_threads {
namespace {

using namespace test_nets;

Matrix times(const SymmetricCsc& K, const Matrix& u) {
  Matrix f = Matrix::Zero(u.rows(), u.cols());
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      const std::int64_t i = K.row[at(p)];
      f.row(i) += K.value[at(p)] * u.row(j);
      if (i != j) {
        f.row(j) += K.value[at(p)] * u.row(i);
      }
    }
  }
  return f;
}

// Large enough for panels above the subtrees, of which some have several tiles.
TEST(FactorThreads, GiveTheSameBits) {
  const SpringBlock block{.sides = {14, 14, 14}, .external_layers = 1};
  const std::int64_t externals = block.externals();
  const SymmetricCsc K = block.matrix();
  const Matrix f = Matrix::Ones(K.n, 2) + Matrix::Identity(K.n, 2);
  const Condensation one(K, externals, {.threads = 1});
  ASSERT_EQ(one.report().status, FactorStatus::ok);
  ASSERT_GT(one.report().flops, 5e8);
  const Matrix u = one.recover(Matrix::Zero(externals, 2), f);
  for (const int threads : {2, 3, 4, 9}) {
    const Condensation many(K, externals, {.threads = threads});
    EXPECT_TRUE(same_bits(many.schur(), one.schur())) << threads;
    EXPECT_TRUE(same_bits(many.recover(Matrix::Zero(externals, 2), f), u)) << threads;
    EXPECT_EQ(many.report().smallest_pivot, one.report().smallest_pivot);
  }
}

// K u = f with u of the externals given, and S u_e = what holds them there.
TEST(FactorThreads, SolveTheEquations) {
  const SpringBlock block{.sides = {13, 13, 13}, .external_layers = 1};
  const std::int64_t externals = block.externals();
  const SymmetricCsc K = block.matrix();
  const Condensation factor(K, externals, {.threads = 3});
  Matrix f = Matrix::Zero(K.n, 1);
  f.topRows(K.n - externals).setOnes();
  const Matrix given = Matrix::Random(externals, 1);
  const Matrix u = factor.recover(given, f);
  const Matrix rest = times(K, u) - f;
  EXPECT_LT(rest.topRows(K.n - externals).norm(), 1e-11 * f.norm());
  const Matrix held = factor.schur() * given - factor.condense_load(f);
  EXPECT_LT((rest.bottomRows(externals) - held).norm(), 1e-11 * held.norm());
}

// Pieces beside each other stop at pivots of their own: the first of all is named.
TEST(FactorThreads, NameTheSameBadPivot) {
  SymmetricCsc K = SpringBlock{.sides = {12, 12, 12}}.matrix();
  for (const std::int64_t row : {40, 1800, 3003, 5100}) {
    K.value[at(K.start[at(row)])] = -3.0;
  }
  const Condensation one(K, 0, {.threads = 1});
  ASSERT_EQ(one.report().status, FactorStatus::not_positive_definite);
  for (const int threads : {2, 4, 4, 4}) {
    const Condensation many(K, 0, {.threads = threads});
    EXPECT_EQ(many.report().status, FactorStatus::not_positive_definite);
    EXPECT_EQ(many.report().failed_row, one.report().failed_row);
  }
}

TEST(ReadyQueue, RunsWhatTasksMakeReady) {
  for (const int threads : {1, 2, 5}) {
    base::ReadyQueue queue;
    std::vector<std::atomic<int>> runs(1000);
    queue.push(1, 0.0);
    queue.run(threads, [&](std::size_t task, std::size_t worker) {
      EXPECT_LT(worker, static_cast<std::size_t>(threads));
      ++runs[task];
      for (const std::size_t next : {2 * task, 2 * task + 1}) {
        if (next < runs.size()) {
          queue.push(next, static_cast<double>(next));
        }
      }
    });
    for (std::size_t task = 1; task < runs.size(); ++task) {
      EXPECT_EQ(runs[task], 1) << task;
    }
  }
}

TEST(ReadyQueue, TakesTheMostUrgentFirst) {
  base::ReadyQueue queue;
  for (const std::size_t task : {3U, 1U, 4U, 2U}) {
    queue.push(task, static_cast<double>(task % 3));
  }
  std::vector<std::size_t> order;
  queue.run(1, [&](std::size_t task, std::size_t) { order.push_back(task); });
  EXPECT_EQ(order, (std::vector<std::size_t>{2, 1, 4, 3}));
}

TEST(ReadyQueue, EndsWhenATaskFails) {
  for (const int threads : {1, 4}) {
    base::ReadyQueue queue;
    queue.push(0, 0.0);
    const auto chain = [&](std::size_t task, std::size_t) {
      if (task == 20) {
        throw std::runtime_error("no");
      }
      queue.push(task + 1, 0.0);
    };
    EXPECT_THROW(queue.run(threads, chain), std::runtime_error);
  }
}

} // namespace
} // namespace spricka::solve::test_factor_threads
