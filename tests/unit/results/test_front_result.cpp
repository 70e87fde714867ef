// SPDX-License-Identifier: GPL-3.0-or-later
// K between the points of a front: the cubic through four smooth values.
#include "results/front_result.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::results::test_front_result {
namespace {

constexpr double pi = std::numbers::pi;

double cubic(double s) {
  return 2.0 - s + 0.7 * s * s - 0.2 * s * s * s;
}

TEST(FrontValue, IsExactForACubicUpToTheEnds) {
  FrontResult front;
  front.length = 3.0;
  for (const double s : {0.0, 0.2, 0.7, 1.1, 2.0, 3.0}) {
    FrontPointResult& place = front.points.emplace_back();
    place.s = s;
    place.x = {s, 0.0, 0.0};
    place.K1 = -1.0; // a mean over the hat is no value of the curve
    place.T = 3.0 * s;
    place.smooth = {cubic(s), 0.0, 0.0};
  }
  for (const double s : {0.0, 0.1, 0.5, 1.0, 1.7, 2.5, 3.0}) {
    EXPECT_NEAR(*front_value_at_length(front, *find_front_quantity("K1"), s), cubic(s), 1e-12);
    EXPECT_NEAR(front_value_near(front, *find_front_quantity("K1"), {s, 1.0, 0.0}), cubic(s),
                1e-12);
    EXPECT_NEAR(*front_value_at_length(front, *find_front_quantity("T"), s), 3.0 * s, 1e-12);
  }
}

TEST(FrontValue, GoesRoundAClosedFront) {
  FrontResult front;
  front.closed = front.angles = true;
  front.length = 2.0 * pi;
  constexpr int points = 24;
  for (int i = 0; i < points; ++i) {
    FrontPointResult& place = front.points.emplace_back();
    place.s = 2.0 * pi * i / points;
    place.phi = std::remainder(place.s, 2.0 * pi);
    place.smooth = {0.0, std::cos(place.s), 0.0};
  }
  // Chords would cut the curve by h^2/8, 9e-3.
  for (double phi = -pi; phi < pi; phi += 0.05) {
    EXPECT_NEAR(*front_value_at_angle(front, *find_front_quantity("K2"), phi), std::cos(phi), 2e-4);
  }
}

TEST(FrontValue, TakesWhatThereIsOnAShortFront) {
  FrontResult front;
  front.length = 1.0;
  for (const double s : {0.0, 1.0}) {
    FrontPointResult& place = front.points.emplace_back();
    place.s = s;
    place.smooth = {1.0 + s, 0.0, 0.0};
  }
  EXPECT_NEAR(*front_value_at_length(front, *find_front_quantity("K1"), 0.25), 1.25, 1e-14);
}

} // namespace
} // namespace spricka::results::test_front_result
