// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/k_bars.hpp"

#include <gtest/gtest.h>

namespace spricka::test_k_bars {
namespace {

results::KErrorBar bar_of(double mesh, double edge, double floor, double best) {
  results::KErrorBar bar;
  bar.mesh = mesh;
  bar.edge = edge;
  bar.floor = floor;
  bar.best = best;
  return bar;
}

TEST(KBars, HaveAsManyDecimalsAsTheyMean) {
  EXPECT_EQ(report::k_with_bar_text(630.4412, bar_of(0.39, 0.02, 0.063, 630.683)),
            "630.44 +- 0.47 (mesh 0.39, contact edge 0.02, floor 0.06); best 630.68");
  EXPECT_EQ(report::k_with_bar_text(630441.2, bar_of(390.0, 20.0, 63.0, 630683.0)),
            "630441 +- 473 (mesh 390, contact edge 20, floor 63); best 630683");
  EXPECT_EQ(report::k_with_bar_text(-1e-9, bar_of(0.0, 0.0, 0.063, 0.0)),
            "0.000 +- 0.063 (mesh 0.000, contact edge 0.000, floor 0.063); best 0.000");
  EXPECT_EQ(report::k_with_bar_text(0.0, bar_of(0.0, 0.0, 0.0, 0.0)), "0 +- 0; best 0");
}

TEST(KBars, HaveASizeOfTwoDigits) {
  EXPECT_EQ(report::format_error_bar(286.7), "290");
  EXPECT_EQ(report::format_error_bar(99.7), "100");
  EXPECT_EQ(report::format_error_bar(12.34), "12");
  EXPECT_EQ(report::format_error_bar(0.0526), "0.053");
  EXPECT_EQ(report::format_error_bar(473210.0), "470000");
  EXPECT_EQ(report::format_error_bar(0.0), "0");
}

TEST(KBars, AreListedForTipsThatHaveThem) {
  results::CrackLengthResult increment;
  results::LoadStepResult step;
  step.step = "LOAD";
  results::FrontResult front;
  front.name = "C.1";
  results::FrontPointResult& tip = front.points.emplace_back();
  step.fronts.push_back(front); // not estimated
  front.name = "C";
  front.missing_bar_reason.clear();
  tip.K1 = 10.0;
  tip.bar = {bar_of(0.1, 0.0, 0.01, 10.05), bar_of(0.0, 0.0, 0.01, 0.0), {}};
  step.fronts.push_back(front);
  increment.steps.push_back(step);
  EXPECT_EQ(report::k_error_bar_lines(increment),
            "  LOAD  C    K1 = 10.00 +- 0.11 (mesh 0.10, contact edge 0.00, floor 0.01); best "
            "10.05\n"
            "  LOAD  C    K2 = 0.000 +- 0.010 (mesh 0.000, contact edge 0.000, floor 0.010); best "
            "0.000\n");
}

} // namespace
} // namespace spricka::test_k_bars
