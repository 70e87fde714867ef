// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/growth_law.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::life::test_growth_law {
namespace {

LawConstants constants(double C, double m) {
  LawConstants c;
  c.C = C;
  c.m = m;
  return c;
}

LawConstants tough(double C, double m, double k_c) {
  LawConstants c = constants(C, m);
  c.k_c = k_c;
  return c;
}

LawConstants rows(std::vector<double> delta_k, std::vector<double> growth) {
  LawConstants c;
  c.delta_k = std::move(delta_k);
  c.growth = std::move(growth);
  return c;
}

LawConstants nasgro() {
  LawConstants c = tough(2e-12, 3.0, 1500.0);
  c.p = 0.5;
  c.q = 1.0;
  c.threshold = 60.0;
  return c;
}

TEST(GrowthLaw, TheRangeEndsAtZeroK) {
  EXPECT_EQ(growing_range(500.0, 200.0), 300.0);
  EXPECT_EQ(growing_range(500.0, -200.0), 500.0);
  const GrowthLaw paris(Law::paris, constants(1e-11, 3.0));
  EXPECT_EQ(paris.rate(500.0, -200.0), paris.rate(500.0, 0.0));
  EXPECT_EQ(paris.rate(-100.0, -200.0), 0.0);
}

TEST(GrowthLaw, ParisIsAPower) {
  const GrowthLaw paris(Law::paris, constants(1e-11, 3.0));
  EXPECT_NEAR(paris.rate(500.0, 200.0), 1e-11 * 27e6, 1e-18);
}

// C = 1e-11 m/cycle at MPa m^0.5 is C 1000^(1 - m/2) mm/cycle at MPa mm^0.5.
TEST(GrowthLaw, ConstantsHaveTheirOwnUnits) {
  LawConstants in_metres = constants(1e-11, 3.2);
  in_metres.k_unit = std::sqrt(1000.0);
  in_metres.a_unit = 1000.0;
  const GrowthLaw a(Law::paris, in_metres);
  const GrowthLaw b(Law::paris, constants(1e-11 * std::pow(1000.0, 1.0 - 1.6), 3.2));
  EXPECT_NEAR(a.rate(400.0, 100.0) / b.rate(400.0, 100.0), 1.0, 1e-13);

  LawConstants forman = tough(1e-9, 3.0, 2000.0); // C in m/cycle (MPa m^0.5)^-2
  forman.k_unit = std::sqrt(1000.0);
  forman.a_unit = 1000.0;
  const double K = 400.0 / std::sqrt(1000.0);
  const double by_hand = 1000.0 * 1e-9 * K * K * K / (2000.0 / std::sqrt(1000.0) - K);
  EXPECT_NEAR(GrowthLaw(Law::forman, forman).rate(400.0, 0.0) / by_hand, 1.0, 1e-13);
}

// gamma = 1 knows no R, gamma = 0 only K_max: the two ends of Walker's law.
TEST(GrowthLaw, WalkerLiesBetweenRangeAndMaximum) {
  LawConstants c = constants(1e-11, 3.0);
  const GrowthLaw paris(Law::paris, c);
  c.p = 1.0;
  EXPECT_NEAR(GrowthLaw(Law::walker, c).rate(500.0, 200.0) / paris.rate(500.0, 200.0), 1.0, 1e-14);
  c.p = 0.0;
  EXPECT_NEAR(GrowthLaw(Law::walker, c).rate(500.0, 200.0) / paris.rate(500.0, 0.0), 1.0, 1e-14);
  c.p = 0.5;
  const GrowthLaw walker(Law::walker, c);
  EXPECT_NEAR(walker.rate(500.0, 200.0), 1e-11 * std::pow(std::sqrt(300.0 * 500.0), 3.0), 1e-15);
  EXPECT_EQ(walker.rate(500.0, -200.0), walker.rate(500.0, 0.0));
}

// Half way to the toughness at R = 0 Forman's denominator is half of K_c.
TEST(GrowthLaw, FormanHasAPoleAtTheToughness) {
  const GrowthLaw forman(Law::forman, tough(1e-8, 3.0, 1000.0));
  EXPECT_NEAR(forman.rate(500.0, 0.0), 1e-8 * 1.25e8 / 500.0, 1e-12);
  EXPECT_GT(forman.rate(999.999, 0.0), 1e6 * forman.rate(100.0, 0.0));
  EXPECT_TRUE(std::isinf(forman.rate(1000.0, 0.0)));
  EXPECT_TRUE(std::isinf(forman.rate(1200.0, 900.0)));
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
  LawConstants c = tough(1e-11, 3.0, 1e9);
  c.alpha = 3.0;
  const GrowthLaw paris(Law::paris, constants(1e-11, 3.0));
  EXPECT_GT(NewmanClosure(3.0, 0.3)(0.3), 0.3); // closes below R = 0.36 or so
  EXPECT_NEAR(GrowthLaw(Law::nasgro, c).rate(500.0, 350.0) / paris.rate(500.0, 350.0), 1.0, 1e-12);
  EXPECT_LT(GrowthLaw(Law::nasgro, c).rate(500.0, 0.0), paris.rate(500.0, 0.0));
}

TEST(GrowthLaw, NasgroEndsAtThresholdAndToughness) {
  const GrowthLaw law(Law::nasgro, nasgro());
  EXPECT_EQ(law.rate(60.0, 0.0), 0.0);
  EXPECT_EQ(law.rate(90.0, 30.0), 0.0);
  EXPECT_GT(law.rate(60.1, 0.0), 0.0);
  EXPECT_LT(law.rate(60.1, 0.0), 0.05 * 2e-12 * 60.0 * 60.0 * 60.0);
  EXPECT_TRUE(std::isinf(law.rate(1500.0, 0.0)));
  EXPECT_GT(law.rate(1499.0, 0.0), 100.0 * law.rate(1000.0, 0.0));
}

TEST(GrowthLaw, ThresholdStopsEveryLaw) {
  LawConstants c = constants(1e-11, 3.0);
  c.threshold = 100.0;
  const GrowthLaw paris(Law::paris, c);
  EXPECT_EQ(paris.rate(100.0, 0.0), 0.0);
  EXPECT_EQ(paris.rate(300.0, 200.0), 0.0);
  EXPECT_GT(paris.rate(300.1, 200.0), 0.0);
  EXPECT_TRUE(std::isnan(paris.range(1e-11 * 9e5, 0.0))); // delta K = 96.5 grows nothing
  EXPECT_TRUE(std::isnan(paris.rate(std::nan(""), 0.0)));
}

// Two rows on a power law are that power law, between and beyond.
TEST(GrowthLaw, TableIsStraightInItsLogarithms) {
  const GrowthLaw table(Law::table, rows({100.0, 200.0, 400.0}, {1e-5, 8e-5, 64e-5}));
  for (const double range : {50.0, 100.0, 130.0, 200.0, 390.0, 1000.0}) {
    EXPECT_NEAR(table.rate(range, 0.0) / (1e-5 * std::pow(range / 100.0, 3.0)), 1.0, 1e-12);
  }
  EXPECT_TRUE(table.covers(100.0));
  EXPECT_TRUE(table.covers(400.0));
  EXPECT_FALSE(table.covers(99.9));
  EXPECT_FALSE(table.covers(401.0));
}

TEST(GrowthLaw, ATableThatFallsHasNoInverse) {
  const GrowthLaw table(Law::table, rows({100.0, 200.0, 400.0}, {1e-5, 0.9e-5, 64e-5}));
  EXPECT_TRUE(std::isnan(table.range(2e-5, 0.0)));
}

class Inverse : public testing::TestWithParam<Law> {};

TEST_P(Inverse, GivesBackTheRange) {
  LawConstants c = nasgro();
  c.delta_k = {50.0, 200.0, 2000.0};
  c.growth = {1e-7, 2e-5, 1e-2};
  const GrowthLaw law(GetParam(), c);
  for (const double R : {-3.0, -0.5, 0.0, 0.3, 0.7}) {
    for (const double part : {0.1, 0.4, 0.9}) { // of the way from threshold to toughness
      const double open = 1.0 - std::max(R, 0.0);
      const double range = c.threshold + part * (open * *c.k_c - c.threshold);
      const double K_max = range / open;
      const double rate = law.rate(K_max, R * K_max);
      ASSERT_GT(rate, 0.0);
      EXPECT_NEAR(law.range(rate, R) / range, 1.0, 1e-12) << "R " << R << " part " << part;
    }
  }
  EXPECT_TRUE(std::isnan(law.range(0.0, 0.0)));
  EXPECT_TRUE(std::isnan(law.range(-1e-6, 0.0)));
  EXPECT_TRUE(std::isnan(law.range(1e-6, 1.0)));
}

INSTANTIATE_TEST_SUITE_P(Laws, Inverse,
                         testing::Values(Law::paris, Law::walker, Law::forman, Law::nasgro,
                                         Law::table));

TEST(GrowthLaw, FormanWithoutThresholdHasAnInverseForTheSmallestRates) {
  const GrowthLaw forman(Law::forman, tough(1e-8, 3.0, 1000.0));
  const double rate = forman.rate(1e-3, 0.0);
  EXPECT_NEAR(forman.range(rate, 0.0) / 1e-3, 1.0, 1e-12);
}

} // namespace
} // namespace spricka::life::test_growth_law
