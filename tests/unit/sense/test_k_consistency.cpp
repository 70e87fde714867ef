// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/k_consistency.hpp"

#include <gtest/gtest.h>

namespace spricka::test_k_consistency {
namespace {

constexpr double E = 1000.0;

/// A tip with K1 = 3, K2 = 4 known to `bar` of hypot(K1, K2), whose ways all agree.
results::LoadStepResult step_with(double bar) {
  results::LoadStepResult step;
  step.step = "LOAD";
  step.u = base::Vector::Constant(2, 1e-2);
  results::FrontResult front;
  front.name = "C";
  front.a = 1.0;
  front.missing_bar_reason = "";
  results::FrontPointResult& tip = front.points.emplace_back();
  tip.K1 = 3.0;
  tip.K2 = 4.0;
  tip.G = tip.G_from_K = 25.0 / E;
  tip.K1_domain = {3.0, 3.0, 3.0};
  for (const std::size_t k : {0U, 1U}) {
    tip.bar[k].mesh = 5.0 * bar / 1.4; // (3 + 4) of it over 5
  }
  step.fronts = {front};
  return step;
}

std::vector<std::string> warnings_of(const results::LoadStepResult& step) {
  results::RunResult run;
  run.increments.emplace_back().steps = {step};
  return sense::k_consistency_warnings(run);
}

TEST(TwoWays, AgreeWithinTheBar) {
  results::LoadStepResult step = step_with(0.01);
  EXPECT_TRUE(warnings_of(step).empty());
  step.fronts[0].single_point().G *= 1.018; // 0.9 % of K
  EXPECT_TRUE(warnings_of(step).empty());
}

TEST(TwoWays, PartByMoreThanTheBar) {
  results::LoadStepResult step = step_with(0.01);
  step.fronts[0].single_point().G *= 1.03;
  const std::vector<std::string> told = warnings_of(step);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("G = 0.02575 and (K1^2 + K2^2)/E' = 0.025"), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("1.5 % of K apart"), std::string::npos) << told[0];
}

TEST(TwoWays, DomainsThatPartAreTold) {
  results::LoadStepResult step = step_with(1e-4);
  step.fronts[0].single_point().K1_domain = {2.9, 3.0, 3.1};
  const std::vector<std::string> told = warnings_of(step);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("goes from 2.9 to 3.1, 4 % of K apart"), std::string::npos) << told[0];
  step.fronts[0].single_point().closed = true; // K1 is 0, whatever the domains say
  EXPECT_TRUE(warnings_of(step).empty());
}

// The opening is coarse, but not that coarse.
TEST(TwoWays, TheOpeningMayBeSomePercentOff) {
  results::LoadStepResult step = step_with(1e-4);
  step.fronts[0].single_point().opening = {3.1, 4.2, 0.0};
  EXPECT_TRUE(warnings_of(step).empty());
  step.fronts[0].single_point().opening = {4.0, 4.0, 0.0};
  EXPECT_EQ(warnings_of(step).size(), 1U);
}

// What round-off leaves of a body that only moves is no K.
TEST(TwoWays, RoundOffIsNotCompared) {
  results::LoadStepResult step = step_with(1e-4);
  step.fronts[0].single_point().G = -1.0;
  ASSERT_EQ(warnings_of(step).size(), 1U);
  step.u.setConstant(1e6);
  EXPECT_TRUE(warnings_of(step).empty());
}

} // namespace
} // namespace spricka::test_k_consistency
