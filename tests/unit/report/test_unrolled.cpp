// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/unrolled.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::report::test_unrolled {
namespace {

constexpr double pi = std::numbers::pi;

// A bore of radius 3 from z = 1 to 3, 480 cells of two triangles, pressed by
// 5 (1 + z) cos(theta - 3), 0 where that is negative.
results::ContactResult pressed_bore() {
  constexpr int cells = 480;
  results::ContactResult bore;
  bore.radius = 3.0;
  for (const double z : {1.0, 3.0}) {
    for (int i = 0; i < cells; ++i) {
      results::ContactPoint p;
      p.theta = std::remainder(2.0 * pi * i / cells, 2.0 * pi);
      p.arc = z;
      p.p_lumped = 5.0 * (1.0 + z) * std::max(0.0, std::cos(p.theta - 3.0));
      p.p_consistent = 1.0;
      bore.points.push_back(p);
    }
  }
  for (int i = 0; i < cells; ++i) {
    const int next = (i + 1) % cells;
    for (const int corner : {i, next, cells + i, next, cells + next, cells + i}) {
      bore.corners.push_back(corner);
    }
  }
  return bore;
}

TEST(UnrolledSurface, PressureIsThereAllRoundAndNowhereElse) {
  const UnrolledSurface surface(pressed_bore(), false);
  EXPECT_EQ(surface.lowest_axial_position(), 1.0);
  EXPECT_EQ(surface.highest_axial_position(), 3.0);
  for (int i = 0; i <= 100; ++i) { // the seam at +-pi too
    const double theta = -pi + 2.0 * pi * i / 100.0;
    const std::optional<double> p = surface.pressure_at({theta, 2.0});
    ASSERT_TRUE(p) << theta;
    EXPECT_NEAR(*p, 15.0 * std::max(0.0, std::cos(theta - 3.0)), 15.0 * 0.03) << theta;
    EXPECT_NEAR(UnrolledSurface(pressed_bore(), true).pressure_at({theta, 2.0}).value_or(0.0), 1.0,
                1e-12);
  }
  EXPECT_FALSE(surface.pressure_at({0.0, 0.9}));
}

// The integral of cos^2 over half a turn is pi/2.
TEST(UnrolledSurface, PushIsTheIntegralRoundTheAxis) {
  const UnrolledSurface surface(pressed_bore(), false);
  for (const double z : {1.0, 1.7, 3.0}) {
    const double size = 3.0 * 5.0 * (1.0 + z) * 0.5 * pi;
    const DrawingPoint push = surface.line_force_at_axial_position(z);
    EXPECT_NEAR(push.x, size * std::cos(3.0), 2e-3 * size);
    EXPECT_NEAR(push.y, size * std::sin(3.0), 2e-3 * size);
  }
}

} // namespace
} // namespace spricka::report::test_unrolled
