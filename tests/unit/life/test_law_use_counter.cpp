// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/law_use_counter.hpp"

#include <gtest/gtest.h>

namespace spricka::life::test_law_use_counter {
namespace {

model::GrowthLawConstants paris() {
  model::GrowthLawConstants c;
  c.C = 1e-9;
  c.m = 3.0;
  return c;
}

TEST(LawUse, CountsCyclesAndTheirGrowthOutsideTheData) {
  const GrowthRateLaw law(model::CrackGrowthLaw::paris, paris());
  model::GrowthLawData data;
  data.lowest_delta_k = 10.0;
  data.highest_delta_k = 30.0;
  data.highest_ratio = 0.5;
  LawUseCounter counter(law, data);
  const auto add = [&](double K_max, double K_min, double count) {
    counter.add(K_max, K_min, count, law.growth_rate(K_max, K_min));
  };
  add(10.0, 0.0, 60.0); // the least of the data
  add(20.0, 10.0, 20.0);
  add(5.0, 0.0, 10.0);
  add(40.0, 0.0, 5.0);
  add(20.0, 12.0, 5.0); // below and at too high an R
  add(-1.0, -2.0, 1000.0);
  const model::LawUse use = counter.use();
  EXPECT_DOUBLE_EQ(use.outside, 0.2);
  EXPECT_DOUBLE_EQ(use.below_delta_k, 0.15);
  EXPECT_DOUBLE_EQ(use.above_delta_k, 0.05);
  EXPECT_DOUBLE_EQ(use.above_ratio, 0.05);
  EXPECT_EQ(use.below_ratio, 0.0);
  EXPECT_NEAR(use.growth_outside,
              (10 * 125.0 + 5 * 64000.0 + 5 * 512.0) /
                  (80 * 1000.0 + 10 * 125.0 + 5 * 64000.0 + 5 * 512.0),
              1e-12);
  EXPECT_EQ(use.lowest_delta_k, 5.0);
  EXPECT_EQ(use.highest_delta_k, 40.0);
  EXPECT_EQ(use.lowest_ratio, 0.0);
  EXPECT_EQ(use.highest_ratio, 0.6);
}

TEST(LawUse, OfATableEndsAtItsRowsAndColumns) {
  model::GrowthLawConstants c;
  c.table_ratios = {0.0, 0.5};
  c.growth = {1e-6, 1e-4};
  c.delta_k = {10.0, 40.0, 6.0, 20.0};
  const GrowthRateLaw law(model::CrackGrowthLaw::table, c);
  const model::GrowthLawData nothing;
  LawUseCounter counter(law, nothing);
  counter.add(9.0, 0.0, 1.0, 1e-7); // below at R = 0, within at R = 0.5
  counter.add(18.0, 9.0, 1.0, 1e-6);
  counter.add(30.0, 21.0, 1.0, 1e-6);
  counter.add(41.0, 0.0, 1.0, 1e-6);
  const model::LawUse use = counter.use();
  EXPECT_DOUBLE_EQ(use.below_delta_k, 0.25);
  EXPECT_DOUBLE_EQ(use.above_delta_k, 0.25);
  EXPECT_DOUBLE_EQ(use.above_ratio, 0.25);
  EXPECT_DOUBLE_EQ(use.outside, 0.75);
}

TEST(LawUse, OfNothingIsNothing) {
  const GrowthRateLaw law(model::CrackGrowthLaw::paris, paris());
  const model::GrowthLawData nothing;
  const model::LawUse use = LawUseCounter(law, nothing).use();
  EXPECT_GT(use.lowest_delta_k, use.highest_delta_k);
  EXPECT_EQ(use.outside, 0.0);
}

} // namespace
} // namespace spricka::life::test_law_use_counter
