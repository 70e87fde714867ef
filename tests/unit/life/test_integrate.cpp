// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/integrate.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace spricka::life::test_integrate {
namespace {

TEST(Integrate, SmoothToTheTolerance) {
  const Integral found = integrate([](double x) { return std::exp(x); }, 0.0, 2.0, 1e-12);
  const double exact = std::expm1(2.0);
  EXPECT_NEAR(found.value, exact, 1e-12 * exact);
  EXPECT_LE(found.error, 1e-11 * exact);
}

TEST(Integrate, ACornerBetweenPoints) {
  const double corner = 1.0 / std::sqrt(3.0);
  const auto f = [&](double x) { return std::fabs(x - corner); };
  const double exact = (corner * corner + (1.0 - corner) * (1.0 - corner)) / 2.0;
  EXPECT_NEAR(integrate(f, 0.0, 1.0, 1e-12).value, exact, 1e-12 * exact);
}

// More waves than 200 parts of 31 points can follow: the tolerance is out of reach, and the error
// has to say so.
TEST(Integrate, WhatIsNotReachedStandsInTheError) {
  const double waves = 1e5;
  const auto f = [&](double x) { return 1.0 + std::cos(waves * x); };
  const Integral found = integrate(f, 0.0, 1.0, 1e-12);
  const double exact = 1.0 + std::sin(waves) / waves;
  EXPECT_GT(found.error, 1e-6 * exact);
  EXPECT_LE(std::fabs(found.value - exact), found.error);
}

TEST(Integrate, NoLengthNoIntegral) {
  const Integral found = integrate([](double) { return 1.0; }, 3.0, 3.0, 1e-12);
  EXPECT_EQ(found.value, 0.0);
  EXPECT_EQ(found.error, 0.0);
}

} // namespace
} // namespace spricka::life::test_integrate
