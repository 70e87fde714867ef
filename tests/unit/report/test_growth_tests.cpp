// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/topics/growth_test_tables.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace spricka::report::test_growth_tests {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinite = std::numeric_limits<double>::infinity();

results::GrowthTestPoint point(double a, double K, double half_width, double computed) {
  results::GrowthTestPoint p;
  p.a = a;
  p.K = K;
  p.low = K - half_width;
  p.high = K + half_width;
  p.computed = computed;
  return p;
}

// Ratios 2, 1/2 and 1; the first point's band misses, the last ones say nothing.
results::GrowthTestResult sample() {
  results::GrowthTestResult test;
  test.name = "T";
  test.tip = "C1";
  test.readings = {{0.0, 1.0}, {100.0, 2.0}};
  test.points = {point(1.0, 200.0, 20.0, 100.0), point(2.0, 100.0, 150.0, 200.0),
                 point(4.0, 400.0, 10.0, 400.0), point(8.0, k_nan, k_nan, 500.0),
                 point(16.0, 900.0, 10.0, k_nan)};
  return test;
}

TEST(GrowthTests, AreComparedPointByPoint) {
  const results::GrowthTestComparison all = results::compare_test_k(sample(), 0.0, k_infinite);
  EXPECT_EQ(all.points, 3);
  EXPECT_NEAR(all.ratio, 1.0, 1e-14);
  EXPECT_NEAR(all.rms, std::sqrt((1.0 + 0.25) / 3.0), 1e-14);
  EXPECT_NEAR(all.inside, 2.0 / 3.0, 1e-14);
  EXPECT_EQ(results::compare_test_k(sample(), 1.5, 4.0).points, 2);
  EXPECT_EQ(results::compare_test_k(sample(), 5.0, k_infinite).points, 0);
}

TEST(GrowthTests, KIsStraightInItsLogarithms) {
  const results::GrowthTestResult test = sample();
  EXPECT_NEAR(results::measured_k_at(test, std::sqrt(2.0)), 100.0 * std::sqrt(2.0), 1e-10);
  EXPECT_EQ(results::measured_k_at(test, 4.0), 400.0);
  EXPECT_NEAR(results::measured_k_at(test, 8.0), 600.0, 1e-9); // the point without K is no corner
  EXPECT_TRUE(std::isnan(results::measured_k_at(test, 0.9)));
  EXPECT_TRUE(std::isnan(results::measured_k_at(test, 17.0)));
}

// A band without an end is open there.
TEST(GrowthTests, AnOpenBandHoldsWhatLiesThere) {
  results::GrowthTestResult test;
  test.points = {point(1.0, 200.0, 20.0, 100.0)};
  test.points[0].low = k_nan;
  EXPECT_EQ(results::compare_test_k(test, 0.0, 2.0).inside, 1.0);
  test.points[0].computed = 300.0;
  EXPECT_EQ(results::compare_test_k(test, 0.0, 2.0).inside, 0.0);
}

TEST(GrowthTests, TablesHaveARowForEachPoint) {
  model::Model model;
  results::RunResult run;
  run.tests = {sample()};
  const ReportTable points = test_points_table(model, run.tests[0]);
  ASSERT_EQ(points.rows.size(), 5U);
  EXPECT_EQ(points.rows[0].back(), "2.000");
  EXPECT_EQ(points.rows[3].back(), "");
  EXPECT_EQ(growth_test_summary_table(model, run).rows.size(), 1U);
  for (const auto& row : points.rows) {
    EXPECT_EQ(row.size(), points.columns.size());
  }
  EXPECT_EQ(growth_test_figures(model, run).size(), 1U);
}

} // namespace
} // namespace spricka::report::test_growth_tests
