// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/turning_points.hpp"
#include "life/growth_law.hpp"
#include "life/ordered_cycles.hpp"
#include "life/spectrum.hpp"
#include "model/twist_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace spricka::life::test_ordered_cycles {
namespace {

using Pair = std::pair<double, double>;

std::vector<Pair> ends_of(const std::vector<LoadCycle>& cycles) {
  std::vector<Pair> ends;
  for (const LoadCycle& cycle : cycles) {
    ends.emplace_back(cycle.low, cycle.high);
  }
  return ends;
}

// ASTM E1049-85, figure 6, and a history with three equal ranges one in the other.
const std::vector<double> astm{-2, 1, -3, 5, -1, 3, -4, 4, -2};
const std::vector<double> nested{2, -14, 10, 0, 13, -9, 11, -8, 8, -9, 15, -4, 10, 0, 13, 0};

TEST(OrderedCycles, RainflowInOrderOfPeaks) {
  EXPECT_EQ(ends_of(count_rainflow_in_order_of_peaks(astm)),
            (std::vector<Pair>{{-2, 1}, {-4, 5}, {-1, 3}, {-3, 4}}));
  EXPECT_EQ(ends_of(count_rainflow_in_order_of_peaks(nested)),
            (std::vector<Pair>{
                {0, 2}, {0, 10}, {-9, 13}, {-9, 11}, {-8, 8}, {-14, 15}, {0, 10}, {-4, 13}}));
}

TEST(OrderedCycles, EachValleyWithThePeakBehindIt) {
  EXPECT_EQ(ends_of(pair_valleys_with_peaks(astm)),
            (std::vector<Pair>{{-2, 1}, {-3, 5}, {-1, 3}, {-4, 4}}));
  // A peak first: its valley is the last of the pass.
  EXPECT_EQ(ends_of(pair_valleys_with_peaks(std::vector<double>{5, 1, 4, 0})),
            (std::vector<Pair>{{0, 5}, {1, 4}}));
  EXPECT_TRUE(pair_valleys_with_peaks(std::vector<double>{1, 1, 1}).empty());
  EXPECT_TRUE(count_rainflow_in_order_of_peaks(std::vector<double>{1, 1}).empty());
}

TEST(OrderedCycles, TheEndOfAPassLeadsToItsStart) {
  EXPECT_EQ(base::closed_turning_points(std::vector<double>{1, 2, 0, 0.5}),
            (std::vector<double>{2, 0}));
  EXPECT_EQ(base::closed_turning_points(std::vector<double>{1, 3, 0, 2, 1}),
            (std::vector<double>{1, 3, 0, 2}));
  EXPECT_EQ(base::closed_turning_points(std::vector<double>{4, 4}), std::vector<double>{4});
}

// The count in order has the cycles of the count that is not, and as many as there are peaks.
TEST(OrderedCycles, AreTheCyclesOfTheCount) {
  std::mt19937 engine(5);
  std::uniform_int_distribution<int> level(0, 12);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> history(3 + static_cast<std::size_t>(trial));
    for (double& x : history) {
      x = level(engine);
    }
    std::vector<Pair> ordered = ends_of(count_rainflow_in_order_of_peaks(history));
    std::vector<Pair> counted = ends_of(count_rainflow_cycles(history, true));
    std::vector<double> peaks;
    for (const LoadCycle& cycle : pair_valleys_with_peaks(history)) {
      peaks.push_back(cycle.high);
    }
    ASSERT_EQ(ordered.size(), peaks.size());
    for (std::size_t i = 0; i < peaks.size(); ++i) {
      ASSERT_EQ(ordered[i].second, peaks[i]);
    }
    std::sort(ordered.begin(), ordered.end());
    std::sort(counted.begin(), counted.end());
    ASSERT_EQ(ordered, counted);
  }
}

TEST(OrderedCycles, BlocksStandAsTheyAreListed) {
  model::SpectrumDefinition spectrum;
  spectrum.cycles = {{0.1, 1.0, 10}, {0.1, 0.6, 990}, {0.0, 0.6, 2}};
  const std::vector<LoadCycle> cycles = order_cycles(spectrum);
  ASSERT_EQ(cycles.size(), 3U);
  EXPECT_EQ(cycles[1].high, 0.6);
  EXPECT_EQ(cycles[1].count, 990.0);
  EXPECT_EQ(cycles[2].low, 0.0);
}

// K = 100 |t|: each half of the load's way opens the crack once, as pairs of K as well.
TEST(OrderedCycles, PairsAreFormedOfKWhereItTurns) {
  const base::PiecewiseLinear K({-2, 0, 2}, {200, 0}, {-100, 100});
  model::GrowthLawConstants constants;
  constants.C = 1e-11;
  constants.m = 3.0;
  const GrowthRateLaw paris(model::CrackGrowthLaw::paris, constants);
  const CountedSpectrum pairs = CountedSpectrum::from_pairs({-1, 1, -1, 1});
  EXPECT_NEAR(pairs.growth_per_pass(paris, K), 4e-5, 1e-15);
  // 0 to 1 and 0.5 to 1.5 as pairs; by rainflow 0 to 1.5 and 0.5 to 1.
  const base::PiecewiseLinear straight({0, 2}, {0}, {100});
  EXPECT_NEAR(CountedSpectrum::from_pairs({0, 1, 0.5, 1.5}).growth_per_pass(paris, straight),
              1e-5 * (1.0 + 1.0), 1e-15);
  EXPECT_NEAR(CountedSpectrum::from_sequence({0, 1, 0.5, 1.5}).growth_per_pass(paris, straight),
              1e-5 * (3.375 + 0.125), 1e-15);
}

// The sums that are published with the table.
TEST(TwistSpectrum, TheTableAddsUp) {
  const std::vector<double> exceeded{1, 3, 8, 26, 78, 230, 1030, 5200, 40000, 398665};
  std::vector<double> counts = model::twist_gust_counts();
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
  EXPECT_EQ(counts, exceeded);
  const model::TwistHistory all = model::generate_twist_history({});
  EXPECT_EQ(all.flights, 4000.0);
  EXPECT_EQ(pair_valleys_with_peaks(all.points).size(), 398665U);
}

TEST(TwistSpectrum, LevelsAreCutAndLeftOut) {
  const model::TwistHistory cut =
      model::generate_twist_history({.highest_level = 2, .lowest_level = 8});
  EXPECT_EQ(*std::max_element(cut.points.begin(), cut.points.end()), 2.3);
  EXPECT_EQ(std::count(cut.points.begin(), cut.points.end(), 2.3), 8);
  const model::TwistHistory other = model::generate_twist_history({.seed = 2});
  EXPECT_NE(other.points, model::generate_twist_history({}).points);
}

// Walker's law of 2024-T3 [mm, MPa m^0.5], what is below 0 not counted.
double walker_rate(const LoadCycle& cycle, double stress, double a) {
  const double unit = stress * std::sqrt(std::numbers::pi * a / 1000.0);
  const double high = cycle.high * unit;
  const double low = std::max(0.0, cycle.low * unit);
  return high <= 0.0 ? 0.0
                     : 3.115782828226343e-08 *
                           std::pow((high - low) / std::pow(1.0 - low / high, 1.0 - 0.618), 3.273);
}

double passes(const std::vector<LoadCycle>& cycles) {
  double a = 8.0;
  std::size_t done = 0;
  while (a < 12.0) {
    a += walker_rate(cycles[done++ % cycles.size()], 52.0, a);
  }
  return static_cast<double>(done) / static_cast<double>(cycles.size());
}

// Twenty passes of two blocks, against an independent program.
TEST(OrderedCycles, BlocksOneAfterAnother) {
  model::SpectrumDefinition spectrum;
  spectrum.cycles = {{10, 180, 10}, {10, 110, 990}};
  double a = 8.0;
  std::vector<double> after;
  for (int pass = 0; pass < 20; ++pass) {
    for (const LoadCycle& cycle : order_cycles(spectrum)) {
      for (double n = 0.0; n < cycle.count; n += 1.0) {
        a += walker_rate(cycle, 1.0, a);
      }
    }
    after.push_back(a);
  }
  EXPECT_NEAR(after[0], 8.32065511088, 1e-10);
  EXPECT_NEAR(after[4], 9.84116988995, 1e-10);
  EXPECT_NEAR(after[9], 12.493670852, 1e-9);
  EXPECT_NEAR(after[19], 23.3341072271, 1e-9);
}

// A centre crack from 8 to 12 mm under TWIST without level X, cycle by cycle, against an
// independent program.
TEST(TwistSpectrum, MovesALifeByTheWayItIsCounted) {
  const model::TwistHistory twist = model::generate_twist_history({.lowest_level = 8});
  ASSERT_EQ(twist.points.size(), 84422U);
  EXPECT_NEAR(std::accumulate(twist.points.begin(), twist.points.end(), 0.0), 79103.415, 1e-6);
  const std::vector<double> first{-0.5, 1.375, -0.5, 1.0, -0.5, 1.0};
  EXPECT_TRUE(std::equal(first.begin(), first.end(), twist.points.begin()));
  EXPECT_NEAR(passes(pair_valleys_with_peaks(twist.points)), 1.99860226, 1e-8);
  EXPECT_NEAR(passes(count_rainflow_in_order_of_peaks(twist.points)), 1.92115799, 1e-8);
}

} // namespace
} // namespace spricka::life::test_ordered_cycles
