// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/growth_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::life::test_growth_law {
namespace {

model::GrowthLawConstants constants(double C, double m) {
  model::GrowthLawConstants c;
  c.C = C;
  c.m = m;
  return c;
}

model::GrowthLawConstants tough(double C, double m, double k_c) {
  model::GrowthLawConstants c = constants(C, m);
  c.k_c = k_c;
  return c;
}

model::GrowthLawConstants rows(std::vector<double> delta_k, std::vector<double> growth) {
  model::GrowthLawConstants c;
  c.delta_k = std::move(delta_k);
  c.growth = std::move(growth);
  return c;
}

model::GrowthLawConstants nasgro() {
  model::GrowthLawConstants c = tough(2e-12, 3.0, 1500.0);
  c.p = 0.5;
  c.q = 1.0;
  c.threshold = 60.0;
  return c;
}

TEST(GrowthLaw, TheRangeEndsAtZeroK) {
  EXPECT_EQ(tensile_K_range(500.0, 200.0), 300.0);
  EXPECT_EQ(tensile_K_range(500.0, -200.0), 500.0);
  const GrowthRateLaw paris(model::CrackGrowthLaw::paris, constants(1e-11, 3.0));
  EXPECT_EQ(paris.growth_rate(500.0, -200.0), paris.growth_rate(500.0, 0.0));
  EXPECT_EQ(paris.growth_rate(-100.0, -200.0), 0.0);
}

TEST(GrowthLaw, ParisIsAPower) {
  const GrowthRateLaw paris(model::CrackGrowthLaw::paris, constants(1e-11, 3.0));
  EXPECT_NEAR(paris.growth_rate(500.0, 200.0), 1e-11 * 27e6, 1e-18);
}

// C = 1e-11 m/cycle at MPa m^0.5 is C 1000^(1 - m/2) mm/cycle at MPa mm^0.5.
TEST(GrowthLaw, ConstantsHaveTheirOwnUnits) {
  model::GrowthLawConstants in_metres = constants(1e-11, 3.2);
  in_metres.k_unit = std::sqrt(1000.0);
  in_metres.a_unit = 1000.0;
  const GrowthRateLaw a(model::CrackGrowthLaw::paris, in_metres);
  const GrowthRateLaw b(model::CrackGrowthLaw::paris,
                        constants(1e-11 * std::pow(1000.0, 1.0 - 1.6), 3.2));
  EXPECT_NEAR(a.growth_rate(400.0, 100.0) / b.growth_rate(400.0, 100.0), 1.0, 1e-13);

  model::GrowthLawConstants forman = tough(1e-9, 3.0, 2000.0); // C in m/cycle (MPa m^0.5)^-2
  forman.k_unit = std::sqrt(1000.0);
  forman.a_unit = 1000.0;
  const double K = 400.0 / std::sqrt(1000.0);
  const double by_hand = 1000.0 * 1e-9 * K * K * K / (2000.0 / std::sqrt(1000.0) - K);
  EXPECT_NEAR(GrowthRateLaw(model::CrackGrowthLaw::forman, forman).growth_rate(400.0, 0.0) /
                  by_hand,
              1.0, 1e-13);
}

// gamma = 1 knows no R, gamma = 0 only K_max: the two ends of Walker's law.
TEST(GrowthLaw, WalkerLiesBetweenRangeAndMaximum) {
  model::GrowthLawConstants c = constants(1e-11, 3.0);
  const GrowthRateLaw paris(model::CrackGrowthLaw::paris, c);
  c.p = 1.0;
  EXPECT_NEAR(GrowthRateLaw(model::CrackGrowthLaw::walker, c).growth_rate(500.0, 200.0) /
                  paris.growth_rate(500.0, 200.0),
              1.0, 1e-14);
  c.p = 0.0;
  EXPECT_NEAR(GrowthRateLaw(model::CrackGrowthLaw::walker, c).growth_rate(500.0, 200.0) /
                  paris.growth_rate(500.0, 0.0),
              1.0, 1e-14);
  c.p = 0.5;
  const GrowthRateLaw walker(model::CrackGrowthLaw::walker, c);
  EXPECT_NEAR(walker.growth_rate(500.0, 200.0), 1e-11 * std::pow(std::sqrt(300.0 * 500.0), 3.0),
              1e-15);
  EXPECT_EQ(walker.growth_rate(500.0, -200.0), walker.growth_rate(500.0, 0.0));
}

// Half way to the toughness at R = 0 Forman's denominator is half of K_c.
TEST(GrowthLaw, FormanHasAPoleAtTheToughness) {
  const GrowthRateLaw forman(model::CrackGrowthLaw::forman, tough(1e-8, 3.0, 1000.0));
  EXPECT_NEAR(forman.growth_rate(500.0, 0.0), 1e-8 * 1.25e8 / 500.0, 1e-12);
  EXPECT_GT(forman.growth_rate(999.999, 0.0), 1e6 * forman.growth_rate(100.0, 0.0));
  EXPECT_TRUE(std::isinf(forman.growth_rate(1000.0, 0.0)));
  EXPECT_TRUE(std::isinf(forman.growth_rate(1200.0, 900.0)));
}

// Newman 1984: at R = 1 a crack is open all the time; at R = 0 and low stress the opening ratio is
// 0.535 in plane stress and 0.255 in plane strain.
TEST(NewmanClosure, HasItsLimits) {
  EXPECT_NEAR(NewmanClosure(1.0, 0.0)(0.0), 0.535, 1e-14);
  EXPECT_NEAR(NewmanClosure(3.0, 0.0)(0.0), 0.255, 1e-14);
  for (const double alpha : {1.0, 1.9, 2.5, 3.0}) {
    for (const double stress : {0.0, 0.3, 0.8}) {
      const NewmanClosure f(alpha, stress);
      EXPECT_NEAR(f(1.0), 1.0, 1e-14);
      EXPECT_NEAR(f(-1e-12), f(1e-12), 1e-11);
      EXPECT_EQ(f(-5.0), f(-2.0));
      for (double R = 0.0; R < 1.0; R += 0.01) {
        EXPECT_GE(f(R), R);
        EXPECT_LE(f(R), 1.0);
      }
    }
  }
}

// A crack that is open all the time (f = R at high R) grows by Paris when p = q = 0.
TEST(GrowthLaw, NasgroBecomesParisWithoutClosure) {
  model::GrowthLawConstants c = tough(1e-11, 3.0, 1e9);
  c.alpha = 3.0;
  const GrowthRateLaw paris(model::CrackGrowthLaw::paris, constants(1e-11, 3.0));
  EXPECT_GT(NewmanClosure(3.0, 0.3)(0.3), 0.3); // closes below R = 0.36 or so
  EXPECT_NEAR(GrowthRateLaw(model::CrackGrowthLaw::nasgro, c).growth_rate(500.0, 350.0) /
                  paris.growth_rate(500.0, 350.0),
              1.0, 1e-12);
  EXPECT_LT(GrowthRateLaw(model::CrackGrowthLaw::nasgro, c).growth_rate(500.0, 0.0),
            paris.growth_rate(500.0, 0.0));
}

TEST(GrowthLaw, NasgroEndsAtThresholdAndToughness) {
  const GrowthRateLaw law(model::CrackGrowthLaw::nasgro, nasgro());
  EXPECT_EQ(law.growth_rate(60.0, 0.0), 0.0);
  EXPECT_EQ(law.growth_rate(90.0, 30.0), 0.0);
  EXPECT_GT(law.growth_rate(60.1, 0.0), 0.0);
  EXPECT_LT(law.growth_rate(60.1, 0.0), 0.05 * 2e-12 * 60.0 * 60.0 * 60.0);
  EXPECT_TRUE(std::isinf(law.growth_rate(1500.0, 0.0)));
  EXPECT_GT(law.growth_rate(1499.0, 0.0), 100.0 * law.growth_rate(1000.0, 0.0));
}

TEST(GrowthLaw, ThresholdStopsEveryLaw) {
  model::GrowthLawConstants c = constants(1e-11, 3.0);
  c.threshold = 100.0;
  const GrowthRateLaw paris(model::CrackGrowthLaw::paris, c);
  EXPECT_EQ(paris.growth_rate(100.0, 0.0), 0.0);
  EXPECT_EQ(paris.growth_rate(300.0, 200.0), 0.0);
  EXPECT_GT(paris.growth_rate(300.1, 200.0), 0.0);
  EXPECT_TRUE(std::isnan(paris.K_range_for_rate(1e-11 * 9e5, 0.0))); // delta K = 96.5 grows nothing
  EXPECT_TRUE(std::isnan(paris.growth_rate(std::nan(""), 0.0)));
}

// Two rows on a power law are that power law, between and beyond.
TEST(GrowthLaw, TableIsStraightInItsLogarithms) {
  const GrowthRateLaw table(model::CrackGrowthLaw::table,
                            rows({100.0, 200.0, 400.0}, {1e-5, 8e-5, 64e-5}));
  for (const double range : {50.0, 100.0, 130.0, 200.0, 390.0, 1000.0}) {
    EXPECT_NEAR(table.growth_rate(range, 0.0) / (1e-5 * std::pow(range / 100.0, 3.0)), 1.0, 1e-12);
  }
  EXPECT_TRUE(table.is_within_table(100.0, 0.0));
  EXPECT_TRUE(table.is_within_table(400.0, 0.0));
  EXPECT_FALSE(table.is_within_table(99.9, 0.0));
  EXPECT_FALSE(table.is_within_table(401.0, 0.0));
}

TEST(GrowthLaw, ATableThatFallsHasNoInverse) {
  const GrowthRateLaw table(model::CrackGrowthLaw::table,
                            rows({100.0, 200.0, 400.0}, {1e-5, 0.9e-5, 64e-5}));
  EXPECT_TRUE(std::isnan(table.K_range_for_rate(2e-5, 0.0)));
}

class Inverse : public testing::TestWithParam<model::CrackGrowthLaw> {};

TEST_P(Inverse, GivesBackTheRange) {
  model::GrowthLawConstants c = nasgro();
  c.delta_k = {50.0, 200.0, 2000.0};
  c.growth = {1e-7, 2e-5, 1e-2};
  const GrowthRateLaw law(GetParam(), c);
  for (const double R : {-3.0, -0.5, 0.0, 0.3, 0.7}) {
    for (const double part : {0.1, 0.4, 0.9}) { // of the way from threshold to toughness
      const double open = 1.0 - std::max(R, 0.0);
      const double range = c.threshold + part * (open * *c.k_c - c.threshold);
      const double K_max = range / open;
      const double rate = law.growth_rate(K_max, R * K_max);
      ASSERT_GT(rate, 0.0);
      EXPECT_NEAR(law.K_range_for_rate(rate, R) / range, 1.0, 1e-12)
          << "R " << R << " part " << part;
    }
  }
  EXPECT_TRUE(std::isnan(law.K_range_for_rate(0.0, 0.0)));
  EXPECT_TRUE(std::isnan(law.K_range_for_rate(-1e-6, 0.0)));
  EXPECT_TRUE(std::isnan(law.K_range_for_rate(1e-6, 1.0)));
}

INSTANTIATE_TEST_SUITE_P(
    Laws, Inverse,
    testing::Values(model::CrackGrowthLaw::paris, model::CrackGrowthLaw::walker,
                    model::CrackGrowthLaw::forman, model::CrackGrowthLaw::nasgro,
                    model::CrackGrowthLaw::table, model::CrackGrowthLaw::hartman));

TEST(GrowthLaw, FormanWithoutThresholdHasAnInverseForTheSmallestRates) {
  const GrowthRateLaw forman(model::CrackGrowthLaw::forman, tough(1e-8, 3.0, 1000.0));
  const double rate = forman.growth_rate(1e-3, 0.0);
  EXPECT_NEAR(forman.K_range_for_rate(rate, 0.0) / 1e-3, 1.0, 1e-12);
}

// 2024-T3 (DOT/FAA/AR-05/15, 2005), K_max = 15 MPa m^0.5, mm: three uses at R = -1.
TEST(GrowthLaw, WalkerAtNegativeRIsWhatTheNameSays) {
  model::GrowthLawConstants c = constants(3.115782828226343e-08, 3.273);
  c.p = 0.618;
  c.p_below = 0.164;
  const auto rate = [&](model::NegativeRatioRule rule, double R) {
    c.at_negative_ratio = rule;
    const GrowthRateLaw law(model::CrackGrowthLaw::walker, c);
    const double found = law.growth_rate(15.0, R * 15.0);
    EXPECT_NEAR(law.K_range_for_rate(found, R) / (15.0 * (1.0 - std::max(R, 0.0))), 1.0, 1e-12);
    return found;
  };
  using enum model::NegativeRatioRule;
  for (const model::NegativeRatioRule rule : {positive_part, whole_range, K_max}) {
    EXPECT_NEAR(rate(rule, 0.0) / 0.00022024896202842893, 1.0, 1e-10);
    EXPECT_NEAR(rate(rule, 0.3) / 0.00010705119195680337, 1.0, 1e-10);
    EXPECT_NEAR(rate(rule, 0.7) / 1.928766756067801e-05, 1.0, 1e-10);
  }
  EXPECT_NEAR(rate(positive_part, -1.0) / 0.00022024896202842893, 1.0, 1e-10);
  EXPECT_NEAR(rate(whole_range, -1.0) / 0.00031952021754333106, 1.0, 1e-10);
  EXPECT_NEAR(rate(K_max, -1.0) / 9.258492545286329e-05, 1.0, 1e-10);
}

// 7050-T7451 (Jones, Molent, Walker 2012), mm and MPa m^0.5.
TEST(GrowthLaw, HartmanAndSchijve) {
  model::GrowthLawConstants c = tough(7e-7, 2.0, 47.0);
  c.threshold = 0.1;
  const GrowthRateLaw law(model::CrackGrowthLaw::hartman, c);
  struct RateAt {
    double R, range, rate;
  };
  for (const RateAt& at :
       {RateAt{0.0, 0.2, 7.02991452991453e-09}, RateAt{0.0, 9.0, 6.85791842105263e-05},
        RateAt{0.1, 5.0, 1.9059949061662197e-05}, RateAt{0.5, 1.0, 5.922e-07},
        RateAt{0.8, 9.0, 0.001303004500000005}}) {
    const double K_max = at.range / (1.0 - at.R);
    const double rate = law.growth_rate(K_max, at.R * K_max);
    EXPECT_NEAR(rate / at.rate, 1.0, 1e-12) << at.R << ' ' << at.range;
    EXPECT_NEAR(law.K_range_for_rate(rate, at.R) / at.range, 1.0, 1e-12);
  }
  EXPECT_EQ(law.growth_rate(0.1, 0.0), 0.0);
  EXPECT_TRUE(std::isinf(law.growth_rate(47.0, 0.0)));
  EXPECT_FALSE(law.is_held_by_constant_threshold(0.15, 0.09)); // its constant is one of all R
}

TEST(GrowthLaw, APlaceHasAToughnessOfItsOwn) {
  const GrowthRateLaw law(model::CrackGrowthLaw::nasgro, nasgro());
  EXPECT_TRUE(std::isinf(law.growth_rate(1200.0, 0.0, {1.0, 1100.0})));
  EXPECT_GT(law.growth_rate(1000.0, 0.0, {1.0, 1100.0}), law.growth_rate(1000.0, 0.0));
}

// Cycles of a centre crack in an infinite plate, K = S (pi a)^0.5, by Simpson's rule over ln a.
double cycles_of_plate(const GrowthRateLaw& law, double S, double R, double from, double to) {
  constexpr int parts = 2000;
  const double h = std::log(to / from) / parts;
  double sum = 0.0;
  for (int i = 0; i <= parts; ++i) {
    const double a = from * std::exp(h * i); // mm
    const double K = S * std::sqrt(std::numbers::pi * a / 1000.0);
    const double weight = i == 0 || i == parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * a / law.growth_rate(K, R * K);
  }
  return sum * h / 3.0;
}

// Against integrals in closed form; C in mm and MPa m^0.5.
TEST(GrowthLaw, LivesInClosedForm) {
  const auto paris = [](double C, double m) {
    return GrowthRateLaw(model::CrackGrowthLaw::paris, constants(C, m));
  };
  EXPECT_NEAR(cycles_of_plate(paris(1e-8, 3.0), 100, 0, 1, 10) / 776634.4444503561, 1.0, 1e-10);
  EXPECT_NEAR(cycles_of_plate(paris(1e-8, 2.0), 100, 0, 1, 10) / 7329355.9887942765, 1.0, 1e-10);
  EXPECT_NEAR(cycles_of_plate(paris(5e-9, 3.5), 80, 0, 1.27, 25) / 1042649.8628859223, 1.0, 1e-10);
  const GrowthRateLaw forman(model::CrackGrowthLaw::forman, tough(7.13e-6, 2.7, 71.3));
  EXPECT_NEAR(cycles_of_plate(forman, 100, 0.1, 1, 10) / 155479.6558065734, 1.0, 1e-10);
}

// d ln N / d ln x of Paris' life, from the closed form.
TEST(GrowthLaw, LivesFollowTheirConstantsAsTheClosedFormDoes) {
  struct Case {
    double C = 5e-9, m = 3.5, S = 80.0, from = 1.27, to = 25.0;
  };
  const auto life = [](const Case& c) {
    return std::log(cycles_of_plate({model::CrackGrowthLaw::paris, constants(c.C, c.m)}, c.S, 0.0,
                                    c.from, c.to));
  };
  constexpr double part = 1e-4;
  const auto derivative = [&](double Case::*x) {
    Case more;
    Case less;
    more.*x *= 1.0 + part;
    less.*x *= 1.0 - part;
    return (life(more) - life(less)) / (std::log1p(part) - std::log1p(-part));
  };
  EXPECT_NEAR(derivative(&Case::C), -1.0, 1e-6);
  EXPECT_NEAR(derivative(&Case::m), -7.378553085946037, 1e-4);
  EXPECT_NEAR(derivative(&Case::S), -3.5, 1e-6);
  EXPECT_NEAR(derivative(&Case::from), -0.8398688671640286, 1e-4);
  EXPECT_NEAR(derivative(&Case::to), 0.08986886710360409, 1e-4);
}

} // namespace
} // namespace spricka::life::test_growth_law
