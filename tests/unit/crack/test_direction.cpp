// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/direction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spricka::test_direction {
namespace {

using crack::KinkCriterion;

constexpr double degree = std::numbers::pi / 180.0;

// Benchmark G03: theta = 2 atan((1 - sqrt(1 + 8 q^2)) / (4 q)), q = K2/K1.
TEST(Direction, HoopStressAnglesOfTheBenchmark) {
  const double K1 = 630.0;
  for (const auto& [q, wanted] :
       {std::pair(0.5, 40.2078187), std::pair(1.0, 53.1301024), std::pair(2.0, 61.3418441)}) {
    EXPECT_NEAR(crack::kink_angle(KinkCriterion::hoop, K1, q * K1) / degree, -wanted, 1e-6) << q;
    EXPECT_NEAR(crack::kink_angle(KinkCriterion::hoop, K1, -q * K1) / degree, wanted, 1e-6) << q;
  }
  EXPECT_NEAR(crack::kink_angle(KinkCriterion::hoop, 0.0, 1.0) / degree, -70.5287794, 1e-6);
}

// No cancellation where K2 is small: theta tends to -2 q for both criteria.
TEST(Direction, SmallK2) {
  for (const KinkCriterion criterion : {KinkCriterion::hoop, KinkCriterion::k2_zero}) {
    EXPECT_NEAR(crack::kink_angle(criterion, 1.0, 1e-9) / 1e-9, -2.0, 1e-5);
    EXPECT_EQ(crack::kink_angle(criterion, 1.0, 0.0), 0.0);
    EXPECT_EQ(crack::kink_angle(criterion, 0.0, 0.0), 0.0);
  }
}

// The angle is where the hoop stress is largest: no other direction has more.
TEST(Direction, HoopStressIsLargestThere) {
  for (const double K2 : {-1.7, -0.3, 0.2, 0.9}) {
    const double angle = crack::kink_angle(KinkCriterion::hoop, 1.0, K2);
    const auto hoop = [&](double at) {
      return crack::kinked_K1_factors(KinkCriterion::hoop, at).dot(base::Vec2(1.0, K2));
    };
    const double h = 1e-3;
    EXPECT_GT(hoop(angle), hoop(angle + h));
    EXPECT_GT(hoop(angle), hoop(angle - h));
  }
}

// Amestoy and Leblond 1992: in pure mode 2 the kink without K2 stands at 77.3 degrees, that of the
// largest energy release rate at 75.6 to 75.8.
TEST(Direction, PureModeTwo) {
  EXPECT_NEAR(crack::kink_angle(KinkCriterion::k2_zero, 0.0, 1.0) / degree, -77.33, 0.01);
  double best = 0.0;
  double largest = 0.0;
  for (double angle = 60.0; angle < 90.0; angle += 0.01) {
    const crack::KinkFunctions F = crack::kink_functions(-angle * degree);
    const double G = F.F12 * F.F12 + F.F22 * F.F22;
    if (G > largest) {
      largest = G;
      best = angle;
    }
  }
  EXPECT_NEAR(best, 75.7, 0.15);
}

// K2 is 0 behind the kink, and the expansion's first order is that of a slightly kinked crack
// (Cotterell and Rice 1980): K1 - 3/2 theta K2, K2 + 1/2 theta K1.
TEST(Direction, KinkWithoutK2) {
  for (const double K2 : {-3.0, -0.4, 0.1, 1.0}) {
    const double angle = crack::kink_angle(KinkCriterion::k2_zero, 1.0, K2);
    const crack::KinkFunctions F = crack::kink_functions(angle);
    EXPECT_NEAR(F.F21 + F.F22 * K2, 0.0, 1e-12);
    EXPECT_LT(angle * K2, 0.0);
  }
  const crack::KinkFunctions F = crack::kink_functions(1e-4);
  EXPECT_NEAR(F.F12, -1.5e-4, 1e-10);
  EXPECT_NEAR(F.F21, 0.5e-4, 1e-10);
  EXPECT_NEAR(F.F11, 1.0, 1e-7);
}

} // namespace
} // namespace spricka::test_direction
