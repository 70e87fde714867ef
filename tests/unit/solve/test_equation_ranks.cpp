// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/engine_choice.hpp"
#include "solve/equation_ranks.hpp"
#include "solve/serve_rank.hpp"
#include "solve/sparse_condensation.hpp"

#include <array>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <gtest/gtest.h>
#include <mutex>
#include <thread>
#include <vector>

namespace spricka::solve::test_equation_ranks {
namespace {

/// A square net of rods between nodes [side, side], one freedom each; `ground` holds its first
/// line. The last line has the last numbers.
base::SymmetricCsc rod_net(int side, double ground) {
  base::SymmetricCsc K;
  K.n = static_cast<std::int64_t>(side) * side;
  K.start.push_back(0);
  for (int i = 0; i < side * side; ++i) {
    const int x = i % side;
    const int y = i / side;
    const int rods =
        (x > 0 ? 1 : 0) + (x + 1 < side ? 1 : 0) + (y > 0 ? 1 : 0) + (y + 1 < side ? 1 : 0);
    const auto add = [&](int row, double value) {
      K.row.push_back(row);
      K.value.push_back(value);
    };
    add(i, rods + (y == 0 ? ground : 0.0));
    if (x + 1 < side) {
      add(i + 1, -1.0);
    }
    if (y + 1 < side) {
      add(i + side, -1.0);
    }
    K.start.push_back(static_cast<std::int64_t>(K.row.size()));
  }
  return K;
}

/// Bytes on their way from each rank to each other.
class Wires {
public:
  void put(int from, int to, const void* data, std::size_t bytes) {
    const auto* first = static_cast<const std::byte*>(data);
    {
      const std::scoped_lock lock(mutex_);
      std::deque<std::byte>& wire = bytes_[static_cast<std::size_t>(2 * from + to)];
      wire.insert(wire.end(), first, first + bytes);
    }
    more_.notify_all();
  }
  void get(int from, int to, void* data, std::size_t bytes) {
    std::unique_lock lock(mutex_);
    std::deque<std::byte>& wire = bytes_[static_cast<std::size_t>(2 * from + to)];
    more_.wait(lock, [&] { return wire.size() >= bytes; });
    std::copy_n(wire.begin(), bytes, static_cast<std::byte*>(data));
    wire.erase(wire.begin(), wire.begin() + static_cast<std::ptrdiff_t>(bytes));
  }

private:
  std::mutex mutex_;
  std::condition_variable more_;
  std::array<std::deque<std::byte>, 4> bytes_;
};

/// Two ranks that are threads of this process.
class ThreadCommunicator final : public Communicator {
public:
  ThreadCommunicator(Wires& wires, int rank) : wires_(wires), rank_(rank) {}
  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return 2; }
  [[nodiscard]] int ranks_on_machine() const override { return 2; }
  [[nodiscard]] std::string machine_name() const override { return "here"; }
  void send(int to, const void* data, std::size_t bytes) override {
    wires_.put(rank_, to, data, bytes);
  }
  void receive(int from, void* data, std::size_t bytes) override {
    wires_.get(from, rank_, data, bytes);
  }
  [[nodiscard]] std::unique_ptr<CondensedEquations>
  condense_together(base::SymmetricCsc& /*K*/, std::int64_t /*externals*/,
                    const CondensationSettings& /*settings*/, const CollectiveStep& step) override {
    step(7, 1, [&] { ++own_steps; });
    step(7, 2, [&] { ++own_steps; });
    return std::make_unique<SparseCondensation>(base::SymmetricCsc(), 0);
  }
  void join_step(std::int64_t matrix, int job) override {
    joined.push_back(static_cast<int>(matrix) * 10 + job);
  }
  [[nodiscard]] double memory_of_steps() const override { return 0.0; }
  void abort(int /*exit_code*/) override {}

  int own_steps = 0;
  std::vector<int> joined;

private:
  Wires& wires_;
  int rank_;
};

class EquationRanksTest : public ::testing::Test {
protected:
  EquationRanksTest() : other_([this] { code_ = serve_rank(second_); }), ranks_(first_) {
    set_equation_ranks(&ranks_);
  }
  ~EquationRanksTest() override { end(); }
  EquationRanksTest(const EquationRanksTest&) = delete;
  EquationRanksTest& operator=(const EquationRanksTest&) = delete;

  void end() {
    if (other_.joinable()) {
      set_equation_ranks(nullptr);
      ranks_.end(5);
      other_.join();
    }
  }

  Wires wires_;
  ThreadCommunicator first_{wires_, 0};
  ThreadCommunicator second_{wires_, 1};
  int code_ = -1;
  std::thread other_;
  EquationRanks ranks_;
};

TEST_F(EquationRanksTest, AnotherRankAnswersWithTheSameBits) {
  const std::vector<base::SymmetricCsc> nets{rod_net(14, 1.0), rod_net(12, 0.5)};
  const std::vector<std::int64_t> externals{14, 12};
  std::vector<std::unique_ptr<CondensedEquations>> found(2);
  const std::vector<double> cost{2.0, 1.0}; // the first one stays here
  for_each_on_ranks(cost, 1, [&](std::size_t i) {
    EXPECT_EQ(condenses_elsewhere(), i == 1);
    found[i] = condense_equations(nets[i], externals[i], {});
  });
  EXPECT_FALSE(condenses_elsewhere());
  for (std::size_t i = 0; i < 2; ++i) {
    SparseCondensation here(nets[i], externals[i]);
    CondensedEquations& there = *found[i];
    ASSERT_EQ(there.report().status, FactorStatus::ok);
    EXPECT_EQ(there.report().flops, here.report().flops);
    EXPECT_EQ(there.report().smallest_pivot, here.report().smallest_pivot);
    EXPECT_EQ(there.take_schur(), here.take_schur());
    const base::Matrix f = base::Matrix::Random(nets[i].n, 2);
    const base::Matrix u = base::Matrix::Random(externals[i], 2);
    EXPECT_EQ(there.condense_load(f), here.condense_load(f));
    EXPECT_EQ(there.recover(u, f), here.recover(u, f));
    int asked = 0;
    const ExternalDisplacementSolver stiff = [&](const base::Matrix& load) -> base::Matrix {
      ++asked;
      return 0.25 * load;
    };
    EXPECT_EQ(there.solve(f, stiff), here.solve(f, stiff));
    EXPECT_EQ(asked, 2); // once each
    SparseRightHandSides F;
    F.row = {0, 5, nets[i].n - 1};
    F.value = {1.0, -2.0, 0.5};
    F.start = {0, 2, 3};
    const RowCompliance a = there.compliance_with_externals_held(F);
    const RowCompliance b = here.compliance_with_externals_held(F);
    EXPECT_EQ(a.W, b.W);
    EXPECT_EQ(a.condensed, b.condensed);
  }
  const std::vector<RankWork> work = ranks_.work();
  EXPECT_EQ(work[0].nets, 1);
  EXPECT_EQ(work[1].nets, 1);
  EXPECT_EQ(work[1].unknowns, nets[1].n);
  EXPECT_EQ(work[1].machine, "here");
  found.clear(); // the other rank may forget its factor
  end();
  EXPECT_EQ(code_, 5);
}

TEST_F(EquationRanksTest, AMechanismIsFoundElsewhereToo) {
  const base::SymmetricCsc loose = rod_net(6, 0.0); // nothing holds it
  std::unique_ptr<CondensedEquations> found;
  for_each_on_ranks(std::vector<double>{2.0, 1.0}, 1, [&](std::size_t i) {
    if (i == 1) {
      found = condense_equations(loose, 0, {});
    }
  });
  EXPECT_EQ(found->report().status, FactorStatus::not_positive_definite);
  EXPECT_EQ(found->report().failed_row, SparseCondensation(loose, 0).report().failed_row);
}

TEST_F(EquationRanksTest, StepsOfAllRanksAreAnnounced) {
  const auto together = condense_equations(rod_net(4, 1.0), 0, {.engine = EquationEngine::mumps});
  EXPECT_EQ(first_.own_steps, 2);
  EXPECT_EQ(ranks_.work()[1].nets_of_all, 1);
  end();
  EXPECT_EQ(second_.joined, (std::vector<int>{71, 72}));
}

TEST(DistributeByCost, TheDearestFirstToWhoHasLeast) {
  EXPECT_EQ(distribute_by_cost(std::vector<double>{1.0, 5.0, 4.0, 2.0}, 2),
            (std::vector<int>{0, 0, 1, 1}));
  EXPECT_EQ(distribute_by_cost(std::vector<double>{3.0, 3.0}, 3), (std::vector<int>{0, 1}));
  EXPECT_EQ(distribute_by_cost(std::vector<double>{3.0, 4.0}, 1), (std::vector<int>{0, 0}));
}

} // namespace
} // namespace spricka::solve::test_equation_ranks
