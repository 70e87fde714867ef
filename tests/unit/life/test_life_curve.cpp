// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/life_curve.hpp"

#include "life/growth_law.hpp"
#include "life/spectrum.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

namespace spricka::life::test_life_curve {
namespace {

using Function = std::function<double(double)>;
constexpr double pi = std::numbers::pi;

// G01 of the open benchmarks: da/dN = 1e-11 delta K^3, K = 1.12 S sqrt(pi a), a from 1 to 10.
constexpr double k_beta = 1.12;
double K_of(double stress, double a) {
  return k_beta * stress * std::sqrt(pi * a);
}

GrowthRateLaw g01_law() {
  model::GrowthLawConstants c;
  c.C = 1e-11;
  c.m = 3.0;
  return {model::CrackGrowthLaw::paris, c};
}

std::vector<double> spaced(double a0, double a1, int intervals) {
  std::vector<double> a;
  for (int i = 0; i <= intervals; ++i) {
    a.push_back(i == intervals ? a1 : a0 * std::pow(a1 / a0, static_cast<double>(i) / intervals));
  }
  return a;
}

LifeCurve curve(const Function& rate, double a0, double a1, int intervals) {
  const std::vector<double> a = spaced(a0, a1, intervals);
  std::vector<double> rates;
  rates.reserve(a.size());
  for (const double x : a) {
    rates.push_back(rate(x));
  }
  return {a, rates};
}

// Simpson's rule with many equal parts of sqrt(a): shares nothing with the adaptive quadrature.
double simpson_life(const Function& rate, double a0, double a1) {
  constexpr int parts = 20000;
  const double h = (std::sqrt(a1) - std::sqrt(a0)) / parts;
  double sum = 0.0;
  for (int i = 0; i <= parts; ++i) {
    const double s = std::sqrt(a0) + h * i;
    const double weight = i == 0 || i == parts ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * 2.0 * s / rate(s * s);
  }
  return sum * h / 3.0;
}

TEST(LifeCurve, G01Cycles) {
  const GrowthRateLaw law = g01_law();
  const auto rate = [&](double a) { return law.growth_rate(K_of(100.0, a), 0.0); };
  const LifeCurve life = curve(rate, 1.0, 10.0, 7);
  EXPECT_NEAR(life.cycles(1.0, 10.0) / 17480.851359, 1.0, 1e-9);
  EXPECT_NEAR(life.cycles(1.0, 2.5) + life.cycles(2.5, 10.0), life.cycles(1.0, 10.0), 1e-6);
  EXPECT_LT(life.cycles_error(1.0, 10.0), 1e-6);
}

TEST(LifeCurve, G01Blocks) {
  const CountedSpectrum blocks =
      CountedSpectrum::from_cycles({{0, 100, 100}, {0, 150, 10}, {0, 200, 1}});
  const GrowthRateLaw law = g01_law();
  const auto rate = [&](double a) {
    return blocks.growth_per_pass(law, base::PiecewiseLinear({0.0, 200.0}, {0.0}, {K_of(1.0, a)}));
  };
  EXPECT_NEAR(curve(rate, 1.0, 10.0, 7).cycles(1.0, 10.0) / 123.321703, 1.0, 1e-8);
}

// a(N) of m = 3 and a constant beta in closed form: a = (1 - N / 25565.7..)^-2.
TEST(LifeCurve, G01Lengths) {
  const GrowthRateLaw law = g01_law();
  const LifeCurve life =
      curve([&](double a) { return law.growth_rate(K_of(100.0, a), 0.0); }, 1.0, 10.0, 7);
  const double half_rate = 0.5e-11 * std::pow(k_beta * 100.0 * std::sqrt(pi), 3.0);
  for (const double N : {0.0, 1.0, 500.0, 9000.0, 17000.0, 17480.8}) {
    EXPECT_NEAR(life.length_at(N) * std::pow(1.0 - N * half_rate, 2.0), 1.0, 1e-11);
  }
  EXPECT_NEAR(life.length_at(life.cycles(1.0, 10.0)), 10.0, 1e-9);
  EXPECT_TRUE(std::isnan(life.length_at(20000.0)));
  EXPECT_TRUE(std::isnan(life.length_at(-1.0)));
  EXPECT_TRUE(std::isnan(life.growth_rate(10.5)));
  EXPECT_TRUE(std::isnan(life.cycles(0.9, 2.0)));
  EXPECT_TRUE(std::isnan(life.cycles(3.0, 2.0)));
}

// The published formulas, written down once more, with K of a centre crack in a finite plate and
// K_min = R K_max; lives of `GrowthLaw` through `LifeCurve` agree to 1e-6.
constexpr double k_width = 40.0;
double K_plate(double a) {
  return 60.0 * std::sqrt(pi * a / std::cos(pi * a / (2.0 * k_width)));
}

struct Case {
  const char* name;
  model::CrackGrowthLaw law;
  model::GrowthLawConstants constants;
  double R;
  Function formula; ///< da/dN of K_max
};

model::GrowthLawConstants make(double C, double m, double k_c, double threshold) {
  model::GrowthLawConstants c;
  c.C = C;
  c.m = m;
  c.k_c = k_c;
  c.threshold = threshold;
  return c;
}

Case walker(double R) {
  model::GrowthLawConstants c = make(3e-12, 3.1, 1500.0, 0.0);
  c.p = 0.6;
  return {"walker", model::CrackGrowthLaw::walker, c, R, [R](double K) {
            const double r = std::max(R, 0.0);
            return 3e-12 * std::pow((1.0 - r) * K / std::pow(1.0 - r, 1.0 - 0.6), 3.1);
          }};
}

Case forman(double R) {
  return {"forman", model::CrackGrowthLaw::forman, make(2e-9, 2.9, 1500.0, 0.0), R, [R](double K) {
            const double r = std::max(R, 0.0);
            const double range = (1.0 - r) * K;
            return 2e-9 * std::pow(range, 2.9) / ((1.0 - r) * 1500.0 - range);
          }};
}

// Newman's f by its polynomial, alpha 1.9 and stress ratio 0.25.
double opening(double R) {
  const double A0 =
      (0.825 - 0.34 * 1.9 + 0.05 * 1.9 * 1.9) * std::pow(std::cos(pi / 2.0 * 0.25), 1.0 / 1.9);
  const double A1 = (0.415 - 0.071 * 1.9) * 0.25;
  const double A3 = 2.0 * A0 + A1 - 1.0;
  const double A2 = 1.0 - A0 - A1 - A3;
  return R < 0.0 ? A0 + A1 * R : std::max(R, A0 + A1 * R + A2 * R * R + A3 * R * R * R);
}

Case nasgro(double R) {
  model::GrowthLawConstants c = make(2e-12, 3.2, 1500.0, 25.0);
  c.p = 0.7;
  c.q = 0.9;
  c.alpha = 1.9;
  c.stress_ratio = 0.25;
  return {"nasgro", model::CrackGrowthLaw::nasgro, c, R, [R](double K) {
            const double full = (1.0 - R) * K; // K_max - K_min
            const double open = R < 0.0 ? K : full;
            return 2e-12 * std::pow((1.0 - opening(R)) / (1.0 - R) * full, 3.2) *
                   std::pow(1.0 - 25.0 / open, 0.7) / std::pow(1.0 - K / 1500.0, 0.9);
          }};
}

Case table(double R) {
  model::GrowthLawConstants c;
  c.delta_k = {50.0, 200.0, 600.0};
  c.growth = {2e-6, 1e-4, 5e-3};
  return {"table", model::CrackGrowthLaw::table, c, R, [R](double K) {
            const double range = (1.0 - std::max(R, 0.0)) * K;
            return range < 200.0 ? 2e-6 * std::pow(range / 50.0, std::log(50.0) / std::log(4.0))
                                 : 1e-4 * std::pow(range / 200.0, std::log(50.0) / std::log(3.0));
          }};
}

Case paris(double R) {
  return {"paris", model::CrackGrowthLaw::paris, make(5e-12, 2.8, 1500.0, 0.0), R,
          [R](double K) { return 5e-12 * std::pow((1.0 - std::max(R, 0.0)) * K, 2.8); }};
}

class EveryLaw : public testing::TestWithParam<Case> {};

TEST_P(EveryLaw, EqualsAnIndependentIntegration) {
  const Case& c = GetParam();
  const GrowthRateLaw law(c.law, c.constants);
  const auto rate = [&](double a) { return law.growth_rate(K_plate(a), c.R * K_plate(a)); };
  const auto published = [&](double a) { return c.formula(K_plate(a)); };
  // a table has a corner where its rows meet: its life in two parts
  double corner = 8.0;
  while (c.law == model::CrackGrowthLaw::table &&
         (1.0 - std::max(c.R, 0.0)) * K_plate(corner) > 200.0) {
    corner -= 1e-4;
  }
  const double life = curve(rate, 0.8, corner, 60).cycles(0.8, corner) +
                      curve(rate, corner, 32.0, 60).cycles(corner, 32.0);
  const double expected =
      simpson_life(published, 0.8, corner) + simpson_life(published, corner, 32.0);
  EXPECT_NEAR(life / expected, 1.0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw,
                         testing::Values(paris(0.0), paris(0.4), paris(-1.0), walker(0.0),
                                         walker(0.4), walker(-1.0), forman(0.0), forman(0.4),
                                         forman(-1.0), nasgro(0.0), nasgro(0.4), nasgro(0.7),
                                         nasgro(-1.0), table(0.0), table(0.3), table(-1.0)),
                         [](const testing::TestParamInfo<Case>& one) {
                           return one.param.name + std::to_string(one.index);
                         });

// Few stations, at even and odd places: the estimate is above the true error, also where the rate
// has a corner at a = 7 that no station knows of; it falls with the stations, by fourth order where
// K is smooth. K as that of a short crack at a hole that runs into a finite plate.
class FewStations : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(FewStations, KnowTheirError) {
  const auto [m, corner] = GetParam();
  const auto rate = [m = m, corner = corner](double a) {
    const double K =
        60.0 * std::sqrt(pi * a / std::cos(pi * a / 80.0)) * (1.0 + 2.3 / (1.0 + a / 2.0));
    return 1e-11 * std::pow(K * std::pow(std::max(a / 7.0, 1.0), corner), m);
  };
  const double exact = simpson_life(rate, 0.5, 30.0);
  double coarse = 0.0;
  double estimate = 0.0;
  for (const int intervals : {3, 4, 6, 8, 12, 16, 24, 32}) {
    const LifeCurve life = curve(rate, 0.5, 30.0, intervals);
    estimate = life.cycles_error(0.5, 30.0) / exact;
    EXPECT_GT(estimate, std::fabs(life.cycles(0.5, 30.0) / exact - 1.0)) << intervals;
    coarse = intervals == 8 ? estimate : coarse;
  }
  EXPECT_LT(estimate, corner == 0.0 ? 4e-4 : 6e-3);
  EXPECT_LT(estimate, coarse / (corner == 0.0 ? 50.0 : 8.0)); // 256 and 16 in the limit
}

INSTANTIATE_TEST_SUITE_P(LoadAndGapRates, FewStations,
                         testing::Combine(testing::Values(2.0, 3.0, 4.0),
                                          testing::Values(0.0, 0.1, 0.5, -0.3)));

TEST(LifeCurve, TwoStationsKnowNothingOfTheirError) {
  const LifeCurve life({1.0, 2.0}, {1e-5, 3e-5});
  EXPECT_TRUE(std::isinf(life.cycles_error(1.0, 2.0)));
  EXPECT_NEAR(life.growth_rate(std::sqrt(2.0)), std::sqrt(3.0) * 1e-5, 1e-18);
}

} // namespace
} // namespace spricka::life::test_life_curve
