// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/mode_split.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spricka::solve::test_mode_split {
namespace {

// Openings of `n` radial rows round a bore whose centre is `off` to the right of that of a ring of
// radius 1, by the ring's unit motions x, y and its rotation, and by those of a fixed shaft inside
// it that has the ring's own centre.
base::Matrix ring_between(int n, double off) {
  base::Matrix B = base::Matrix::Zero(2L * n, 5);
  for (int i = 0; i < n; ++i) {
    const double t = 2.0 * std::numbers::pi * i / n;
    const base::Vec2 radial(std::cos(t), std::sin(t));
    B.block<1, 2>(i, 0) = -radial.transpose();
    B(i, 2) = off * radial.y();
    B.block<1, 2>(n + i, 0) = radial.transpose();
    B.block<1, 2>(n + i, 3) = -radial.transpose();
  }
  return B;
}

// A ring turns freely in a bore, whether or not the bore's centre is known to the last digit.
TEST(ModeSplit, TurningInABoreOpensNoRow) {
  for (const double off : {0.0, 1e-14, 1.3e-9, 1e-8, 5e-8}) {
    const ModeSplit split = split_controllable_modes(ring_between(61, off), 0.0);
    ASSERT_EQ(split.uncontrollable.cols(), 1) << off;
    EXPECT_NEAR(std::abs(split.uncontrollable(2, 0)), 1.0, 1e-6) << off;
    EXPECT_EQ(split.controllable.cols(), 4) << off;
    EXPECT_LT(split.controllable.colwise().norm().maxCoeff(), 10.0) << off;
  }
}

// Where the shaft can follow, the ring turns about the bore's centre, however far off that is.
TEST(ModeSplit, AnEccentricRingCarriesItsShaftAlong) {
  const ModeSplit split = split_controllable_modes(ring_between(61, 1e-3), 0.0);
  EXPECT_EQ(split.uncontrollable.cols(), 1);
  EXPECT_EQ(split.controllable.cols(), 4);
}

// With the shaft held it cannot turn but by an eccentricity that is round-off.
TEST(ModeSplit, AnEccentricRingRoundAHeldShaftIsHeld) {
  const base::Matrix held = ring_between(61, 1e-3).leftCols(3);
  EXPECT_EQ(split_controllable_modes(held, 0.0).uncontrollable.cols(), 0);
  const base::Matrix round = ring_between(61, 1e-9).leftCols(3);
  EXPECT_EQ(split_controllable_modes(round, 0.0).uncontrollable.cols(), 1);
}

} // namespace
} // namespace spricka::solve::test_mode_split
