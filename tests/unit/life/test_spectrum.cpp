// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/spectrum.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace spricka::life::test_spectrum {
namespace {

GrowthRateLaw paris(double m) {
  model::GrowthLawConstants c;
  c.C = 1e-11;
  c.m = m;
  return {model::CrackGrowthLaw::paris, c};
}

base::PiecewiseLinear map(const std::vector<double>& t, const std::vector<double>& K) {
  std::vector<double> slope;
  for (std::size_t i = 1; i < t.size(); ++i) {
    slope.push_back((K[i] - K[i - 1]) / (t[i] - t[i - 1]));
  }
  return {t, {K.begin(), K.end() - 1}, slope};
}

std::vector<double> random_history(std::size_t size, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> load(-0.5, 1.5);
  std::vector<double> history(size);
  for (double& x : history) {
    x = load(engine);
  }
  return history;
}

TEST(Spectrum, BlocksAddUp) {
  const CountedSpectrum blocks =
      CountedSpectrum::from_cycles({{0, 100, 60}, {0, 150, 10}, {100, 0, 40}, {0, 200, 1}});
  EXPECT_EQ(blocks.cycles_per_pass(), 111.0);
  EXPECT_EQ(blocks.cycles().size(), 3U); // the two rows of 0 to 100 are one
  EXPECT_EQ(blocks.lowest_load(), 0.0);
  EXPECT_EQ(blocks.highest_load(), 200.0);
  const base::PiecewiseLinear K = map({0, 200}, {0, 600});
  EXPECT_NEAR(blocks.growth_per_pass(paris(3.0), K), 1e-11 * 27.0 * (100e6 + 10 * 3.375e6 + 8e6),
              1e-14);
  EXPECT_EQ(blocks.extreme_K(K), std::pair(0.0, 600.0));
}

// A bent map, as contact makes it: each cycle by itself, K looked up one by one.
TEST(Spectrum, EqualsTheSumOverItsCycles) {
  const base::PiecewiseLinear K =
      map({-0.5, 0.1, 0.34, 0.6, 0.61, 1.0, 1.5}, {150, 230, 280, 420, 430, 700, 1060});
  const std::vector<double> history = random_history(5001, 7);
  for (const bool repeated : {true, false}) {
    const CountedSpectrum spectrum = CountedSpectrum::from_sequence(history, repeated);
    double sum = 0.0;
    for (const LoadCycle& cycle : count_rainflow_cycles(history, repeated)) {
      sum += cycle.count * 1e-11 * std::pow(K(cycle.high) - K(cycle.low), 3.0);
    }
    EXPECT_FALSE(spectrum.requires_counting_on_K(K));
    EXPECT_NEAR(spectrum.growth_per_pass(paris(3.0), K) / sum, 1.0, 1e-12);
  }
}

// K that falls with t: the same cycles of K as of a history turned upside down.
TEST(Spectrum, AFallingMapIsAsGoodAsARisingOne) {
  const std::vector<double> history = random_history(301, 3);
  std::vector<double> upside_down = history;
  for (double& t : upside_down) {
    t = -t;
  }
  const base::PiecewiseLinear falling = map({-0.5, 0.4, 1.5}, {900, 500, 50});
  const base::PiecewiseLinear rising = map({-1.5, -0.4, 0.5}, {50, 500, 900});
  const CountedSpectrum a = CountedSpectrum::from_sequence(history);
  const CountedSpectrum b = CountedSpectrum::from_sequence(upside_down);
  EXPECT_FALSE(a.requires_counting_on_K(falling));
  EXPECT_NEAR(a.growth_per_pass(paris(3.0), falling) / b.growth_per_pass(paris(3.0), rising), 1.0,
              1e-12);
}

// K = 100 |t|: a load from -1 to 1 opens the crack twice.
TEST(Spectrum, CountsOnKWhereKTurns) {
  const base::PiecewiseLinear K = map({-2, 0, 2}, {200, 0, 200});
  const double one = 1e-11 * 1e6;
  const CountedSpectrum sequence = CountedSpectrum::from_sequence({-1, 1, -1, 1});
  EXPECT_TRUE(sequence.requires_counting_on_K(K));
  EXPECT_NEAR(sequence.growth_per_pass(paris(3.0), K), 4.0 * one, 1e-12 * one);
  const CountedSpectrum blocks = CountedSpectrum::from_cycles({{-1, 1, 2}});
  EXPECT_NEAR(blocks.growth_per_pass(paris(3.0), K), 4.0 * one, 1e-12 * one);
  EXPECT_EQ(blocks.extreme_K(K), std::pair(0.0, 100.0));
  const CountedSpectrum tension = CountedSpectrum::from_cycles({{0.5, 1, 2}});
  EXPECT_FALSE(tension.requires_counting_on_K(K));
  EXPECT_NEAR(tension.growth_per_pass(paris(1.0), K), 2.0 * 1e-11 * 50.0, 1e-22);
}

// With m = 1 growth is half the way that K goes up and down, however it turns in between.
TEST(Spectrum, NoWayOfKIsLost) {
  const base::PiecewiseLinear K =
      map({-0.5, 0.0, 0.2, 0.5, 0.6, 1.1, 1.5}, {300, 100, 100, 400, 350, 500, 20});
  const std::vector<double> history = random_history(400, 11);
  double way = 0.0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double from = history[i];
    const double to = history[(i + 1) % history.size()];
    constexpr int parts = 20000;
    double before = K(from);
    for (int k = 1; k <= parts; ++k) {
      const double now = K(from + (to - from) * k / parts);
      way += std::fabs(now - before);
      before = now;
    }
  }
  const CountedSpectrum spectrum = CountedSpectrum::from_sequence(history);
  EXPECT_TRUE(spectrum.requires_counting_on_K(K));
  EXPECT_NEAR(spectrum.growth_per_pass(paris(1.0), K) / (0.5e-11 * way), 1.0, 1e-4);
}

TEST(Spectrum, NothingIsExtrapolated) {
  const base::PiecewiseLinear K = map({0, 1}, {0, 600});
  EXPECT_TRUE(
      std::isnan(CountedSpectrum::from_cycles({{0, 1.001, 1}}).growth_per_pass(paris(3.0), K)));
  EXPECT_TRUE(std::isnan(CountedSpectrum::from_cycles({{-0.001, 1, 1}}).extreme_K(K).first));
}

TEST(Spectrum, AConstantLoadGrowsNothing) {
  const CountedSpectrum constant = CountedSpectrum::from_sequence({0.5, 0.5});
  EXPECT_EQ(constant.growth_per_pass(paris(3.0), map({0, 1}, {0, 600})), 0.0);
  EXPECT_EQ(constant.extreme_K(map({0, 1}, {0, 600})), std::pair(300.0, 300.0));
}

} // namespace
} // namespace spricka::life::test_spectrum
