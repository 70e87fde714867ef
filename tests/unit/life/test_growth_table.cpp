// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/growth_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

/// Tables over several R: between columns at equal rate by Walker's exponent of the two around R.
namespace spricka::life::test_growth_table {
namespace {

struct RateAt {
  double R, range, rate;
};

model::GrowthLawConstants two_columns(double first, double second) {
  model::GrowthLawConstants c;
  c.table_ratios = {first, second};
  c.growth = {1e-7, 1e-6, 1e-5, 1e-4, 1e-3};
  c.delta_k = {3.3, 4.6, 8.1, 15.5, 29.0, 2.1, 3.1, 5.6, 10.9, 18.2};
  return c;
}

GrowthRateLaw table(const model::GrowthLawConstants& constants) {
  return {model::CrackGrowthLaw::table, constants};
}

double rate_at(const GrowthRateLaw& law, double range, double R) {
  const double K_max = range / (1.0 - std::max(R, 0.0));
  return law.growth_rate(K_max, R * K_max);
}

// Numbers of an independent program, mm and MPa m^0.5.
TEST(TableOverRatios, GoesAtEqualRateByWalkersExponent) {
  constexpr std::array expected{
      RateAt{0.0, 4.0, 3.794896414939671e-07},   RateAt{0.0, 7.0, 5.521324616483389e-06},
      RateAt{0.0, 12.0, 4.0330633897939444e-05}, RateAt{0.25, 4.0, 1.1007692067697666e-06},
      RateAt{0.25, 7.0, 1.0257200948796994e-05}, RateAt{0.25, 12.0, 6.801736127777549e-05},
      RateAt{0.5, 4.0, 2.6978881337089887e-06},  RateAt{0.5, 7.0, 2.1629789520399114e-05},
      RateAt{0.5, 12.0, 0.0001540067177334545},  RateAt{0.7, 4.0, 7.840831927157559e-06},
      RateAt{0.7, 7.0, 5.367072131342007e-05},   RateAt{0.7, 12.0, 0.0006750431829113294}};
  const GrowthRateLaw law = table(two_columns(0.0, 0.5));
  for (const RateAt& at : expected) {
    EXPECT_NEAR(rate_at(law, at.range, at.R) / at.rate, 1.0, 1e-10) << at.R << ' ' << at.range;
    EXPECT_NEAR(law.K_range_for_rate(at.rate, at.R) / at.range, 1.0, 1e-10);
  }
}

// Columns of Walker's law are Walker's law, at every R; at R < 0 that of R = 0.
TEST(TableOverRatios, OfWalkersLawIsThatLaw) {
  model::GrowthLawConstants walker;
  walker.C = 1e-9;
  walker.m = 3.0;
  walker.p = 0.4;
  const GrowthRateLaw law(model::CrackGrowthLaw::walker, walker);
  model::GrowthLawConstants c;
  c.table_ratios = {0.1, 0.4, 0.6};
  c.growth = {1e-8, 1e-5};
  for (const double R : c.table_ratios) {
    for (const double rate : c.growth) {
      c.delta_k.push_back(law.K_range_for_rate(rate, R));
    }
  }
  const GrowthRateLaw rows = table(c);
  for (const double R : {-0.5, 0.0, 0.1, 0.3, 0.5, 0.6, 0.85}) {
    EXPECT_NEAR(rate_at(rows, 9.0, R) / rate_at(law, 9.0, R), 1.0, 1e-12) << R;
  }
  EXPECT_EQ(rows.counted_ratio(-0.5), 0.0);
}

// With a column at R < 0 delta K is K_max - K_min there.
TEST(TableOverRatios, ANegativeColumnHasTheWholeRange) {
  const GrowthRateLaw law = table(two_columns(-1.0, 0.0));
  EXPECT_EQ(law.counted_ratio(-0.5), -0.5);
  EXPECT_NEAR(rate_at(law, 0.5 * 8.1, -1.0) / 1e-5, 1.0, 1e-12);
  EXPECT_NEAR(rate_at(law, 5.6, 0.0) / 1e-5, 1.0, 1e-12);
  EXPECT_NEAR((*law.table_K_range(-1.0))[0] / (0.5 * 3.3), 1.0, 1e-12);
  EXPECT_TRUE(law.is_within_table(2.0, -1.0));
  EXPECT_FALSE(law.is_within_table(2.0, 0.0));
  EXPECT_NEAR(law.K_range_for_rate(1e-5, -1.0) / (0.5 * 8.1), 1.0, 1e-12);
}

// Far beyond the columns the rows would cross; there the exponent ends before.
TEST(TableOverRatios, RisesWithTheRangeAtEveryRatio) {
  model::GrowthLawConstants c = two_columns(0.0, 0.5);
  c.delta_k[9] = 11.0; // close above 10.9
  const GrowthRateLaw law = table(c);
  for (const double R : {-0.9, 0.0, 0.2, 0.5, 0.8, 0.95, 0.9999}) {
    double before = 0.0;
    for (double range = 0.5; range < 50.0; range *= 1.3) {
      const double rate = rate_at(law, range, R);
      EXPECT_TRUE(rate > before || std::isinf(rate)) << R << ' ' << range;
      before = rate;
    }
  }
}

} // namespace
} // namespace spricka::life::test_growth_table
