// SPDX-License-Identifier: GPL-3.0-or-later
// K along a front over the load, with contact at its mouth: exact against steps in between.
#include "tests/unit/analysis/front_decks.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace spricka::test_path_of_fronts {
namespace {

TEST(PathOfFronts, AgreesWithStepsBetween) {
  std::string steps = "$STEP NAME=S0\n  FIT ON 1\n  LOAD PULL 1\n  LOAD PRESS 1\n";
  for (int k = 1; k <= 5; ++k) {
    steps += fmt::format("$STEP NAME=S{}\n  LOAD TILT ({}/5*1.2)\n  LOAD PULL ({})\n", k, k,
                         1.0 + 0.1 * k);
  }
  const auto solved =
      test::solve_text_with_raw_K(test::pressed_mouth(steps + "$LOADPATH NAME=UP FROM=S0 TO=S5\n"));
  ASSERT_TRUE(solved);
  const results::CrackLengthResult& increment = solved->run.increments.front();
  const results::LoadPathResult& path = increment.paths.front();
  EXPECT_TRUE(path.stopped.empty()) << path.stopped;
  EXPECT_GT(path.t.size(), 5U); // contact changes on the way
  EXPECT_LT(path.mismatch, 1e-9);
  ASSERT_EQ(path.fronts.size(), 1U);
  double size = 0.0;
  for (const results::LoadPathFrontPoint& point : path.fronts[0].points) {
    size = std::max(size, point.K[0].largest_value());
  }
  for (std::size_t s = 0; s < increment.steps.size(); ++s) {
    const double t = static_cast<double>(s) / 5.0;
    const results::FrontResult found = path.fronts[0].at(t);
    const results::FrontResult& own = increment.steps[s].fronts[0];
    ASSERT_EQ(found.points.size(), own.points.size());
    for (std::size_t i = 0; i < own.points.size(); ++i) {
      const results::FrontPointResult& a = found.points[i];
      const results::FrontPointResult& b = own.points[i];
      EXPECT_NEAR(a.K1, b.K1, 1e-9 * size) << t << " point " << i;
      EXPECT_NEAR(a.K2, b.K2, 1e-9 * size) << t << " point " << i;
      EXPECT_NEAR(a.K3, b.K3, 1e-9 * size) << t << " point " << i;
      if (b.at_surface) {
        EXPECT_NEAR(a.smooth[0], b.smooth[0], 1e-9 * size);
      }
    }
  }
}

} // namespace
} // namespace spricka::test_path_of_fronts
