// SPDX-License-Identifier: GPL-3.0-or-later
#include "../life/centre_crack.hpp"
#include "growth/cycle_by_cycle.hpp"
#include "life/ordered_cycles.hpp"
#include "model/steps.hpp"
#include "model/twist_spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

/// Growth cycle by cycle over stations of a centre crack, whose K is known, against an independent
/// program and against slow loops.
namespace spricka::growth::test_cycle_by_cycle {
namespace {

using life::CountedSpectrum;
using life::LoadCycle;
using life::LoadInteraction;
using model::InteractionRule;
using test::interaction_2024;

constexpr double no_limit = 1e9;

// Stations of one tip whose K is t times the stress times that of a centre crack; places t from -1
// to `last`.
std::vector<SolvedStation> stations_of(const std::vector<double>& lengths, double stress,
                                       double last = 2.0) {
  std::vector<SolvedStation> stations;
  for (const double a : lengths) {
    const double K = stress * test::centre_crack_K(a);
    TipStation tip;
    tip.a = a;
    tip.K_max = K;
    tip.rate = 1e-5;
    tip.K_over_path = base::PiecewiseLinear({-1.0, 0.5, last}, {-K, 0.5 * K}, {K, K});
    stations.push_back({.s = a, .tips = {tip}});
  }
  return stations;
}

CountedSpectrum blocks(const std::vector<LoadCycle>& cycles) {
  model::SpectrumDefinition spectrum;
  for (const LoadCycle& cycle : cycles) {
    spectrum.cycles.push_back({cycle.low, cycle.high, cycle.count});
  }
  return CountedSpectrum::from_definition(spectrum);
}

const std::vector<double> lengths{8.0, 8.7, 9.5, 10.4, 11.4, 12.6, 14.0, 17.0, 21.0, 26.0};

TEST(CycleByCycleGrowth, ALongSequenceOfPairs) {
  test::CongruentialNumbers number(7);
  std::vector<LoadCycle> pairs;
  for (int i = 0; i < 100000; ++i) {
    const double u = number();
    const double peak = 0.4 + 0.6 * u * u;
    const double valley = peak * (0.7 * number() - 0.2);
    pairs.push_back({valley, peak, 1.0});
  }
  const CountedSpectrum spectrum = blocks(pairs);
  const std::vector<SolvedStation> stations = stations_of(lengths, 80.0);
  const CycleByCycleGrowth by_cycles(stations, spectrum);
  struct Case {
    std::optional<model::LoadInteractionDefinition> with;
    double at_10000, at_50000;
  };
  model::LoadInteractionDefinition chang = interaction_2024(InteractionRule::chang);
  const std::vector<Case> cases{
      {std::nullopt, 8.23875947715, 9.29957460389},
      {interaction_2024(InteractionRule::wheeler), 8.13067837211, 8.66923239225},
      {interaction_2024(InteractionRule::willenborg_1971), 8.1183021899, 8.60172913265},
      {interaction_2024(InteractionRule::willenborg), 8.18861399832, 8.99635194754},
      {interaction_2024(InteractionRule::modified), 8.18019359568, 8.95163169089},
      {chang, 8.19910427645, 9.05741550826}};
  for (const Case& c : cases) {
    const LoadInteraction interaction(c.with, test::walker_2024());
    // a after so many cycles of the pass
    const auto a = [&](double cycles) {
      return by_cycles.extent_after_passes(cycles / 100000.0, interaction, no_limit).value();
    };
    EXPECT_NEAR(a(10000.0) / c.at_10000, 1.0, 1e-9);
    EXPECT_NEAR(a(50000.0) / c.at_50000, 1.0, 1e-9);
  }
}

TEST(CycleByCycleGrowth, BlocksInTheirOrder) {
  const CountedSpectrum spectrum =
      blocks({{10.0 / 180.0, 1.0, 10.0}, {10.0 / 180.0, 110.0 / 180.0, 990.0}});
  const std::vector<SolvedStation> stations = stations_of(lengths, 180.0);
  const CycleByCycleGrowth by_cycles(stations, spectrum);
  struct Case {
    std::optional<model::LoadInteractionDefinition> with;
    double after_1, after_10, after_20;
  };
  const std::vector<Case> cases{
      {std::nullopt, 8.32065511088, 12.493670852, 23.3341072271},
      {interaction_2024(InteractionRule::wheeler), 8.09401175051, 9.03084279794, 10.3059864569},
      {interaction_2024(InteractionRule::willenborg), 8.17069700724, 10.014387285, 13.0139277314},
      {interaction_2024(InteractionRule::modified), 8.15881579093, 9.87374773938, 12.6667081678}};
  for (const Case& c : cases) {
    const LoadInteraction interaction(c.with, test::walker_2024());
    for (const auto& [passes, a] :
         {std::pair(1.0, c.after_1), std::pair(10.0, c.after_10), std::pair(20.0, c.after_20)}) {
      EXPECT_NEAR(by_cycles.extent_after_passes(passes, interaction, no_limit).value() / a, 1.0,
                  1e-9)
          << passes;
    }
  }
}

// TWIST's statistics without level X, in the order of model/twist_spectrum: from 8 to 12 mm at a
// mean stress of 52 MPa.
TEST(CycleByCycleGrowth, FlightsByPairsAndByRainflow) {
  model::SpectrumDefinition flights;
  flights.sequence = true;
  flights.turning_points = model::generate_twist_history({.lowest_level = 8}).points;
  const std::vector<SolvedStation> stations = stations_of({8.0, 9.0, 10.5, 12.0}, 52.0, 3.0);
  struct Case {
    std::optional<model::LoadInteractionDefinition> with;
    double pairs, rainflow;
  };
  const std::vector<Case> cases{
      {std::nullopt, 1.99860226, 1.92115799},
      {interaction_2024(InteractionRule::wheeler), 7.3808249, 6.50955912},
      {interaction_2024(InteractionRule::willenborg), 2.79647485, 2.62476606},
      {interaction_2024(InteractionRule::modified), 2.63601905, 2.48039611}};
  for (const auto counting : {model::CycleCounting::pairs, model::CycleCounting::rainflow}) {
    flights.counting = counting;
    const CountedSpectrum spectrum = CountedSpectrum::from_definition(flights);
    for (const Case& c : cases) {
      const LoadInteraction interaction(c.with, test::walker_2024());
      const auto passes =
          CycleByCycleGrowth(stations, spectrum).passes_at({8.0, 12.0}, interaction, no_limit);
      ASSERT_TRUE(passes);
      const double wanted = counting == model::CycleCounting::pairs ? c.pairs : c.rainflow;
      // The other program counts whole cycles.
      const double whole = std::ceil(passes->back() * spectrum.cycles_per_pass());
      EXPECT_NEAR(whole / spectrum.cycles_per_pass() / wanted, 1.0, 1e-8);
    }
  }
}

// What is asked backwards and forwards is one growth.
TEST(CycleByCycleGrowth, PassesAtLengthsAreTheInverse) {
  const CountedSpectrum spectrum = blocks({{0.1, 1.0, 3.0}, {0.2, 0.6, 200.0}});
  const std::vector<SolvedStation> stations = stations_of(lengths, 150.0);
  const CycleByCycleGrowth by_cycles(stations, spectrum);
  const LoadInteraction interaction(interaction_2024(InteractionRule::wheeler),
                                    test::walker_2024());
  const std::vector<double> places{8.0, 9.0, 9.5, 11.0, 20.0, 26.0};
  const auto passes = by_cycles.passes_at(places, interaction, no_limit);
  ASSERT_TRUE(passes);
  EXPECT_EQ(passes->front(), 0.0);
  for (std::size_t k = 1; k + 1 < places.size(); ++k) {
    EXPECT_NEAR(by_cycles.extent_after_passes((*passes)[k], interaction, no_limit).value() /
                    places[k],
                1.0, 1e-9);
  }
  EXPECT_FALSE(by_cycles.extent_after_passes(1.001 * passes->back(), interaction, no_limit));
  EXPECT_FALSE(by_cycles.passes_at(places, interaction, 1000.0));
}

// Between stations ln K is a cubic of ln s, whatever K is: a loop over Lagrange's polynomials.
TEST(CycleByCycleGrowth, IsASlowLoopOverTheStations) {
  std::vector<SolvedStation> stations = stations_of({8.0, 9.0, 10.0, 11.5, 13.0}, 120.0);
  constexpr std::array bends{1.0, 1.02, 0.97, 1.05, 1.01};
  for (std::size_t k = 0; k < stations.size(); ++k) {
    const double K = bends[k] * stations[k].tips[0].K_max;
    // K at the small load is no fixed part of it
    stations[k].tips[0].K_over_path =
        base::PiecewiseLinear({0.0, 0.4, 1.0}, {0.0, 0.3 * K * bends[k]},
                              {0.3 * K * bends[k] / 0.4, (K - 0.3 * K * bends[k]) / 0.6});
  }
  const CountedSpectrum spectrum = blocks({{0.0, 1.0, 2.0}, {0.2, 0.7, 50.0}});
  const LoadInteraction interaction(interaction_2024(InteractionRule::willenborg),
                                    test::walker_2024());
  const auto K_at = [&](double t, double s) {
    const std::size_t interval = s <= 9.0 ? 0 : s <= 10.0 ? 1 : s <= 11.5 ? 2 : 3;
    const std::size_t first = std::min<std::size_t>(interval > 0 ? interval - 1 : 0, 1);
    double ln_top = 0.0;
    double part = 0.0;
    for (std::size_t i = first; i < first + 4; ++i) {
      double weight = 1.0;
      for (std::size_t k = first; k < first + 4; ++k) {
        weight *=
            k == i ? 1.0 : std::log(s / stations[k].s) / std::log(stations[i].s / stations[k].s);
      }
      const base::PiecewiseLinear& path = stations[i].tips[0].K_over_path;
      ln_top += weight * std::log(path(1.0));
      part += weight * path(t) / path(1.0);
    }
    return std::exp(ln_top) * part;
  };
  life::OverloadMemory memory;
  double a = 8.0;
  double cycles = 0.0;
  while (a < 12.5) {
    const bool large = std::fmod(cycles, 52.0) < 2.0;
    a += interaction.growth(K_at(large ? 1.0 : 0.7, a), K_at(large ? 0.0 : 0.2, a), {}, {.a = a},
                            memory);
    cycles += 1.0;
  }
  EXPECT_NEAR(CycleByCycleGrowth(stations, spectrum)
                      .extent_after_passes(cycles / 52.0, interaction, no_limit)
                      .value() /
                  a,
              1.0, 1e-9);
}

// K that turns within the loads: a cycle of loads is more than one of K.
TEST(CycleByCycleGrowth, CountsOnKWhereKTurns) {
  std::vector<SolvedStation> stations = stations_of(lengths, 150.0);
  for (SolvedStation& station : stations) {
    const double K = station.tips[0].K_max;
    station.tips[0].K_over_path =
        base::PiecewiseLinear({0.0, 0.5, 1.0}, {0.8 * K, 0.1 * K}, {-1.4 * K, 1.8 * K});
  }
  const CountedSpectrum turning = blocks({{0.0, 1.0, 1.0}});
  // in the order of their peaks
  const CountedSpectrum twice = blocks({{0.1, 0.8, 1.0}, {0.1, 1.0, 1.0}});
  const LoadInteraction interaction(interaction_2024(InteractionRule::wheeler),
                                    test::walker_2024());
  const double one = CycleByCycleGrowth(stations, turning)
                         .extent_after_passes(1000.0, interaction, no_limit)
                         .value();
  const std::vector<SolvedStation> plain = stations_of(lengths, 150.0);
  const double other =
      CycleByCycleGrowth(plain, twice).extent_after_passes(1000.0, interaction, no_limit).value();
  EXPECT_NEAR(one / other, 1.0, 1e-6); // K is that of the beginning of the pass, but for its size
}

TEST(CycleByCycleGrowth, EndsWhereNothingGrowsAnyMore) {
  model::GrowthLawConstants c;
  c.C = 3e-8;
  c.m = 3.0;
  c.k_unit = test::sqrt_metre;
  c.threshold = 150.0 * test::centre_crack_K(8.0) * 1.5; // a zone that shuts the crack off
  const CountedSpectrum spectrum = blocks({{0.0, 1.0, 1.0}});
  const std::vector<SolvedStation> stations = stations_of(lengths, 150.0);
  const LoadInteraction interaction(std::nullopt,
                                    life::GrowthRateLaw(model::CrackGrowthLaw::paris, c));
  const auto passes =
      CycleByCycleGrowth(stations, spectrum).passes_at({8.0, 9.0}, interaction, no_limit);
  ASSERT_TRUE(passes);
  EXPECT_EQ(passes->front(), 0.0);
  EXPECT_TRUE(std::isinf(passes->back()));
}

} // namespace
} // namespace spricka::growth::test_cycle_by_cycle
