// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/k_consistency.hpp"

#include <gtest/gtest.h>

namespace spricka::test_front_consistency {
namespace {

constexpr double E = 1000.0;

/// A front of three points, K1 = 3 and K2 = 4 all along it, the first on the surface; G agrees.
results::LoadStepResult step_with_front() {
  results::LoadStepResult step;
  step.step = "LOAD";
  results::FrontResult front;
  front.name = "C";
  front.a = 1.0;
  for (int i = 0; i < 3; ++i) {
    results::FrontPointResult& place = front.points.emplace_back();
    place.x = {0.5 * i, 0.0, 0.0};
    place.K1 = 3.0;
    place.K2 = 4.0;
    place.G = place.G_from_K = 25.0 / E;
    place.at_surface = i == 0;
  }
  step.fronts = {front};
  return step;
}

std::vector<std::string> warnings_of(const std::vector<results::LoadStepResult>& steps) {
  results::RunResult run;
  run.increments.emplace_back().steps = steps;
  return sense::k_consistency_warnings(run);
}

TEST(WaysAlongFronts, AgreeOnSoundMeshes) {
  results::LoadStepResult step = step_with_front();
  EXPECT_TRUE(warnings_of({step}).empty());
  step.fronts[0].points[1].G *= 1.08; // 4 % of K
  EXPECT_TRUE(warnings_of({step}).empty());
  step.fronts[0].points[0].G *= 9.0; // on the surface
  EXPECT_TRUE(warnings_of({step}).empty());
}

TEST(WaysAlongFronts, AgreeBetterWhereThereAreErrorBars) {
  results::LoadStepResult step = step_with_front();
  step.fronts[0].missing_bar_reason = "";
  step.fronts[0].points[1].G *= 1.03; // 1.5 % of K
  EXPECT_TRUE(warnings_of({step}).empty());
  step.fronts[0].points[1].G *= 1.05; // 4 %
  EXPECT_EQ(warnings_of({step}).size(), 1U);
}

TEST(WaysAlongFronts, PartAtTheWorstPlaceOfAllSteps) {
  results::LoadStepResult first = step_with_front();
  first.fronts[0].points[1].G *= 1.21;
  results::LoadStepResult second = step_with_front();
  second.step = "UNLOAD";
  second.fronts[0].points[2].G *= 1.44;
  const std::vector<std::string> told = warnings_of({first, second});
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("C, step UNLOAD, a = 1, at (1, 0, 0)"), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("20 % of K apart"), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("for 1 other result of"), std::string::npos) << told[0];
}

TEST(WaysAlongFronts, MayPartByTheBar) {
  results::LoadStepResult step = step_with_front();
  step.fronts[0].missing_bar_reason = "";
  step.fronts[0].points[1].G *= 1.21;
  for (results::FrontPointResult& place : step.fronts[0].points) {
    place.bar[0].mesh = 0.6; // 12 % of K
  }
  EXPECT_TRUE(warnings_of({step}).empty());
  step.fronts[0].points[1].bar[0].mesh = 0.4;
  EXPECT_EQ(warnings_of({step}).size(), 1U);
}

TEST(WaysAlongFronts, DoNotCountWhereThereIsNoAnswer) {
  results::LoadStepResult closed = step_with_front();
  closed.fronts[0].points[1].G *= 1.44;
  closed.fronts[0].points[1].closed = true;
  EXPECT_TRUE(warnings_of({closed}).empty());
  results::LoadStepResult doubtful = step_with_front();
  doubtful.fronts[0].points[1].G *= 1.44;
  doubtful.fronts[0].invalid_reason = "faces overlap";
  EXPECT_TRUE(warnings_of({doubtful}).empty());
  // K of an unloaded step is round-off, whatever it consists of.
  results::LoadStepResult unloaded = step_with_front();
  for (results::FrontPointResult& place : unloaded.fronts[0].points) {
    place.G_from_K *= 1e-16;
    place.G *= 3e-16;
  }
  EXPECT_TRUE(warnings_of({step_with_front(), unloaded}).empty());
}

// A step whose displacements are so large that K is what round-off leaves of them.
TEST(WaysAlongFronts, RoundOffPartsAsItLikes) {
  results::LoadStepResult step = step_with_front();
  step.fronts[0].points[1].G *= 4.0;
  step.u = base::Vector::Ones(3);
  EXPECT_EQ(warnings_of({step}).size(), 1U);
  step.u *= 1e6; // E u / sqrt(a) is 2e8 times K
  EXPECT_TRUE(warnings_of({step}).empty());
}

} // namespace
} // namespace spricka::test_front_consistency
