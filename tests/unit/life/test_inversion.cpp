// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/inversion.hpp"
#include "life/smoothing.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace spricka::life::test_inversion {
namespace {

// G02 of the open benchmarks: a(N) of Paris with m = 3 and beta = 1.12 in closed form, a from 1 to
// 10, read every 500 cycles.
constexpr double k_beta = 1.12;
constexpr double k_C = 1e-11;
constexpr double k_stress = 100.0;

double half_rate() {
  return 0.5 * k_C * std::pow(k_beta * k_stress * std::sqrt(std::numbers::pi), 3.0);
}
double exact_length(double N) {
  return std::pow(1.0 - N * half_rate(), -2.0);
}

std::vector<CrackReading> readings(double every = 500.0) {
  std::vector<CrackReading> all;
  for (double N = 0.0; N < 17480.0; N += every) {
    all.push_back({N, exact_length(N)});
  }
  return all;
}

std::vector<CrackReading> rounded(double step) {
  std::vector<CrackReading> all = readings();
  for (CrackReading& reading : all) {
    reading.a = step * std::round(reading.a / step);
  }
  return all;
}

GrowthRateLaw reference() {
  model::GrowthLawConstants c;
  c.C = k_C;
  c.m = 3.0;
  return {model::CrackGrowthLaw::paris, c};
}

struct Deviation {
  double largest = 0.0;
  double rms = 0.0;
};

// Of beta from its value.
Deviation deviation_of(const std::vector<CrackReading>& test, model::TestRateMethod method) {
  const std::vector<InferredK> found = infer_K_from_growth(compute_growth_rates(test, method),
                                                           reference(), [](double) { return 0.0; });
  Deviation d;
  for (const InferredK& k : found) {
    const double beta = k.K_max / (k_stress * std::sqrt(std::numbers::pi * k.a));
    const double off = std::fabs(beta / k_beta - 1.0);
    EXPECT_FALSE(std::isnan(off)) << k.a;
    d.largest = std::max(d.largest, off);
    d.rms += off * off / static_cast<double>(found.size());
  }
  d.rms = std::sqrt(d.rms);
  return d;
}

TEST(Inversion, G02WithoutNoise) {
  for (const model::TestRateMethod method :
       {model::TestRateMethod::secant, model::TestRateMethod::polynomial,
        model::TestRateMethod::spline}) {
    const Deviation d = deviation_of(readings(), method);
    EXPECT_LT(d.largest, 0.002) << static_cast<int>(method);
  }
}

TEST(Inversion, G02Rounded) {
  for (const model::TestRateMethod method :
       {model::TestRateMethod::secant, model::TestRateMethod::e647,
        model::TestRateMethod::polynomial, model::TestRateMethod::spline}) {
    const Deviation d = deviation_of(rounded(0.01), method);
    EXPECT_LT(d.rms, 0.03) << static_cast<int>(method);
  }
}

// The parabola through a(N) of E647 is blind to the third derivative, which makes its slope too
// large by 7 h^2 a''' / 6 over seven readings h apart: beta by 14 / 3 (h / (N_end - N))^2 here.
TEST(Inversion, E647HasTheErrorOfItsParabola) {
  const double h = 500.0;
  const MeasuredGrowthRates found = compute_growth_rates(readings(h), model::TestRateMethod::e647);
  for (const MeasuredGrowthRate& point : found.points) {
    const double x = h * half_rate() / (1.0 - point.cycles * half_rate());
    const double true_rate = 2.0 * half_rate() * std::pow(exact_length(point.cycles), 1.5);
    EXPECT_NEAR((point.rate / true_rate - 1.0) / (14.0 * x * x), 1.0, 0.15);
  }
}

// Readings with normal scatter: 95 % of the true rates within their bands, up to what some hundred
// of them can tell, and the scatter itself found.
class Noise : public testing::TestWithParam<model::TestRateMethod> {};

TEST_P(Noise, BandsHoldTheTruth) {
  constexpr double deviation = 0.01;
  int inside = 0;
  int all = 0;
  double variance = 0.0;
  constexpr unsigned tests = 40;
  for (unsigned seed = 1; seed <= tests; ++seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise(0.0, deviation);
    std::vector<CrackReading> test = readings(250.0);
    for (CrackReading& reading : test) {
      reading.a += noise(engine);
    }
    const MeasuredGrowthRates found = compute_growth_rates(test, GetParam());
    variance += found.scatter * found.scatter / tests;
    for (const MeasuredGrowthRate& point : found.points) {
      const double truth = 2.0 * half_rate() * std::pow(exact_length(point.cycles), 1.5);
      inside += std::fabs(point.rate - truth) <= point.half_width ? 1 : 0;
      ++all;
    }
  }
  const double coverage = static_cast<double>(inside) / all;
  EXPECT_GT(coverage, 0.92);
  EXPECT_LT(coverage, 0.98);
  EXPECT_NEAR(std::sqrt(variance) / deviation, 1.0, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Methods, Noise,
                         testing::Values(model::TestRateMethod::secant,
                                         model::TestRateMethod::polynomial,
                                         model::TestRateMethod::spline));

// Growth that scatter turns back has no K, and its neighbours keep theirs.
TEST(Inversion, ShrinkingHasNoK) {
  const std::vector<CrackReading> test{{0, 1.0}, {100, 1.1}, {200, 1.09}, {300, 1.3}};
  const std::vector<InferredK> found =
      infer_K_from_growth(compute_growth_rates(test, model::TestRateMethod::secant), reference(),
                          [](double) { return 0.0; });
  ASSERT_EQ(found.size(), 3U);
  EXPECT_GT(found[0].K_max, 0.0);
  EXPECT_TRUE(std::isnan(found[1].K_max));
  EXPECT_GT(found[2].K_max, 0.0);
}

// R of the part, not of the reference: the same delta K makes a larger K_max.
TEST(Inversion, TheRatioOfKGivesTheMaximum) {
  const MeasuredGrowthRates rates = compute_growth_rates(readings(), model::TestRateMethod::secant);
  const auto at = [&](double R) {
    return infer_K_from_growth(rates, reference(), [R](double) { return R; }).front().K_max;
  };
  EXPECT_NEAR(at(0.5) / at(0.0), 2.0, 1e-12);
  EXPECT_NEAR(at(-1.0) / at(0.0), 1.0, 1e-12);
}

// A table that ends below the measured rate is gone beyond, and says so.
TEST(Inversion, RatesBeyondTheReferenceAreMarked) {
  model::GrowthLawConstants c;
  c.delta_k = {100.0, 400.0};
  c.growth = {k_C * 1e6, k_C * 64e6};
  const std::vector<InferredK> found = infer_K_from_growth(
      compute_growth_rates(readings(), model::TestRateMethod::secant),
      GrowthRateLaw(model::CrackGrowthLaw::table, c), [](double) { return 0.0; });
  EXPECT_TRUE(found.front().covered);
  EXPECT_FALSE(found.back().covered);
}

// A straight line is left as it is, a cubic nearly so: they bend nothing or little.
TEST(Smoothing, KeepsAStraightLine) {
  std::vector<double> x, y, weight;
  for (int i = 0; i < 30; ++i) {
    x.push_back(10.0 * i + (i % 3));
    y.push_back(2.0 - 0.03 * x.back());
    weight.push_back(1.0 + i);
  }
  const SmoothedCurve curve = fit_smoothing_spline(x, y, weight);
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(curve.value[i], y[i], 1e-9);
    EXPECT_NEAR(curve.slope[i], -0.03, 1e-10);
  }
}

TEST(Smoothing, StudentsQuantiles) { // tables of the t distribution, two-sided 95 %
  EXPECT_NEAR(two_sided_student_quantile_95(4.0), 2.7764451, 1e-6);
  EXPECT_NEAR(two_sided_student_quantile_95(30.0), 2.0422725, 1e-6);
  EXPECT_NEAR(two_sided_student_quantile_95(1e9), 1.9599640, 1e-6);
}

} // namespace
} // namespace spricka::life::test_inversion
