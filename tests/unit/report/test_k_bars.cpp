// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/k_bars.hpp"

#include <gtest/gtest.h>

namespace spricka::test_k_bars {
namespace {

results::KErrorBar bar_of(double mesh, double edge, double floor, bool of_best = true) {
  results::KErrorBar bar;
  bar.mesh = mesh;
  bar.edge = edge;
  bar.floor = floor;
  bar.of_best = of_best;
  return bar;
}

TEST(KBars, HaveAsManyDecimalsAsTheyMean) {
  EXPECT_EQ(report::k_with_bar_text(630.683, 630.4412, bar_of(0.39, 0.02, 0.063)),
            "630.68 +- 0.47 (mesh 0.39, contact edge 0.02, floor 0.06); raw 630.44");
  EXPECT_EQ(report::k_with_bar_text(630683.0, 630441.2, bar_of(390.0, 20.0, 63.0)),
            "630683 +- 473 (mesh 390, contact edge 20, floor 63); raw 630441");
  EXPECT_EQ(report::k_with_bar_text(0.0, -1e-9, bar_of(0.0, 0.0, 0.063)),
            "0.000 +- 0.063 (mesh 0.000, contact edge 0.000, floor 0.063); raw 0.000");
  EXPECT_EQ(report::k_with_bar_text(0.0, 0.0, bar_of(0.0, 0.0, 0.0)), "0 +- 0");
}

TEST(KBars, SayWhichKTheyAreOf) {
  EXPECT_EQ(report::k_with_bar_text(630.4412, 630.4412, bar_of(0.39, 0.02, 0.063, false)),
            "630.44 +- 0.47 (mesh 0.39, contact edge 0.02, floor 0.06); as the mesh has it");
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
  tip.K1 = 10.05;
  tip.raw = {10.0, 0.0, 0.0};
  tip.bar = {bar_of(0.1, 0.0, 0.01), bar_of(0.0, 0.0, 0.01, false), {}};
  step.fronts.push_back(front);
  increment.steps.push_back(step);
  EXPECT_EQ(report::k_error_bar_lines(increment, {"MPa*mm^0.5"}),
            "  LOAD  C    K1 = 10.05 +- 0.11 (mesh 0.10, contact edge 0.00, floor 0.01); raw "
            "10.00\n"
            "  LOAD  C    K2 = 0.000 +- 0.010 (mesh 0.000, contact edge 0.000, floor 0.010); as "
            "the mesh has it\n");
}

} // namespace
} // namespace spricka::test_k_bars
