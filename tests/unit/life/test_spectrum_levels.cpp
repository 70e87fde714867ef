// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/ordered_cycles.hpp"
#include "life/spectrum_levels.hpp"
#include "model/reduce_spectrum.hpp"
#include "model/steps.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace spricka::life::test_spectrum_levels {
namespace {

std::vector<double> random_history(std::size_t size, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> load(-0.5, 1.5);
  std::vector<double> history(size);
  for (double& x : history) {
    x = load(engine);
  }
  return history;
}

TEST(CycleLevels, FewLevelsStandOneByOne) {
  const std::vector<LoadCycle> cycles{{0.0, 1.0, 2.0}, {0.5, 1.0, 3.0}, {0.0, 0.6, 10.0}};
  const auto peaks = sort_by_peak(cycles, PartsOfCycles{{0.5, 0.2, 0.3}, {0.4, 0.2, 0.4}});
  ASSERT_EQ(peaks.size(), 2U);
  EXPECT_EQ(peaks[0].low, 1.0);
  EXPECT_EQ(peaks[0].cycles, 5.0);
  EXPECT_EQ(peaks[1].reached, 15.0);
  EXPECT_EQ(peaks[0].crossed, 5.0);
  EXPECT_EQ(peaks[1].crossed, 15.0);
  EXPECT_NEAR(peaks[0].growth, 0.7, 1e-15);
  EXPECT_NEAR(peaks[1].life, 0.4, 1e-15);
  EXPECT_EQ(sort_by_range(cycles, std::nullopt).size(), 3U);
  EXPECT_TRUE(std::isnan(sort_by_range(cycles, std::nullopt)[0].growth));
}

// How often the load rises through a level does not depend on the count, and classes lose nothing.
TEST(CycleLevels, CrossingsAreThoseOfTheHistory) {
  const std::vector<double> history = random_history(2001, 4);
  for (const auto counting : {model::CycleCounting::rainflow, model::CycleCounting::pairs}) {
    const std::vector<LoadCycle> cycles = order_cycles(history, counting);
    const auto levels = sort_by_peak(cycles, std::nullopt);
    ASSERT_EQ(levels.size(), most_levels);
    for (const CycleLevel& level : levels) {
      double rises = 0.0;
      for (std::size_t i = 0; i < history.size(); ++i) {
        const double next = history[(i + 1) % history.size()];
        rises += history[i] < level.low && next >= level.low ? 1.0 : 0.0;
      }
      if (level.low > levels.back().low) { // the lowest peak itself is within round-off
        EXPECT_EQ(level.crossed, rises) << level.low;
      }
    }
    EXPECT_EQ(levels.back().reached, static_cast<double>(cycles.size()));
  }
}

// The rainflow cycles of the rest are those that are not small.
TEST(ReduceSpectrum, SmallRangesAndNoOthersAreLeftOut) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    const std::vector<double> history = random_history(300 + seed, seed);
    constexpr double least = 0.7;
    std::vector<double> kept;
    for (const LoadCycle& cycle : count_rainflow_cycles(history, true)) {
      if (cycle.high - cycle.low >= least) {
        kept.push_back(cycle.high - cycle.low);
      }
    }
    std::vector<double> rest;
    for (const LoadCycle& cycle :
         count_rainflow_cycles(model::leave_out_small_ranges(history, least), true)) {
      rest.push_back(cycle.high - cycle.low);
    }
    std::sort(kept.begin(), kept.end());
    std::sort(rest.begin(), rest.end());
    ASSERT_EQ(kept, rest);
  }
}

} // namespace
} // namespace spricka::life::test_spectrum_levels
