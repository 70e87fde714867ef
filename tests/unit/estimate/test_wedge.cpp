// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/wedge.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::test_wedge {
namespace {

using estimate::MultiMaterialWedge;
using estimate::singularity_exponent;

constexpr double pi = std::numbers::pi;

fe::ConstitutiveLaw plane_strain(double E, double nu) {
  fe::ConstitutiveLaw law;
  law.lambda = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  law.mu = E / (2.0 * (1.0 + nu));
  return law;
}

MultiMaterialWedge wedge(double angle, double nu, bool clamped, double turned = 0.3) {
  return {{{turned, turned + angle, plane_strain(7.0, nu)}},
          false,
          {{{clamped, clamped}, {false, false}}}};
}

// sin(lambda alpha) = -+ lambda sin(alpha) between free sides (Williams 1952).
TEST(MultiMaterialWedge, FreeNotchesAreWilliams) {
  for (const double degrees : {200.0, 225.0, 270.0, 300.0, 330.0, 360.0}) {
    const double alpha = degrees * pi / 180.0;
    const double found = singularity_exponent(wedge(alpha, 0.3, false));
    EXPECT_LT(found, 1.0);
    EXPECT_NEAR(std::sin(found * alpha), -found * std::sin(alpha), 1e-5) << degrees;
  }
  EXPECT_NEAR(singularity_exponent(wedge(1.5 * pi, 0.2, false)), 0.544484, 1e-5);
  EXPECT_EQ(singularity_exponent(wedge(0.5 * pi, 0.3, false)), 1.0);
  EXPECT_EQ(singularity_exponent(wedge(pi, 0.3, false)), 1.0);
}

// sin^2(lambda alpha) = ((kappa + 1)^2 / 4 - lambda^2 sin^2(alpha)) / kappa, one side held
// (Williams 1952).
TEST(MultiMaterialWedge, ClampedSidesAreWilliams) {
  int real = 0;
  for (const double nu : {0.0, 0.3, 0.45, 0.49}) {
    for (const double degrees : {80.0, 90.0, 120.0, 150.0}) {
      const double alpha = degrees * pi / 180.0;
      const double kappa = 3.0 - 4.0 * nu;
      const double l = singularity_exponent(wedge(alpha, nu, true));
      if (l < 1.0) {
        const double right =
            (0.25 * (kappa + 1.0) * (kappa + 1.0) - std::pow(l * std::sin(alpha), 2.0)) / kappa;
        if (right <= 1.0) { // else the exponent is complex
          ++real;
          EXPECT_NEAR(std::pow(std::sin(l * alpha), 2.0), right, 1e-5) << nu << ' ' << degrees;
        }
      } else {
        EXPECT_TRUE(nu == 0.0 || degrees < 90.0);
      }
    }
  }
  EXPECT_GE(real, 8);
  // the end of a clamp on a straight side: 1/2, with an oscillating part
  EXPECT_NEAR(singularity_exponent(wedge(pi, 0.3, true)), 0.5, 1e-5);
}

TEST(MultiMaterialWedge, RollersMirrorTheBody) {
  // a roller along x under a wedge is the wedge twice as wide, and free
  for (const double degrees : {100.0, 135.0, 180.0}) {
    const double alpha = degrees * pi / 180.0;
    const MultiMaterialWedge half{
        {{0.0, alpha, plane_strain(1.0, 0.3)}}, false, {{{false, true}, {}}}};
    const double found = singularity_exponent(half);
    const double mirrored = singularity_exponent(wedge(2.0 * alpha, 0.3, false));
    EXPECT_NEAR(found, mirrored, 1e-5) << degrees; // the symmetric field is the stronger
  }
}

TEST(MultiMaterialWedge, MaterialsJoinWithoutATraceWhereTheyAreOne) {
  const fe::ConstitutiveLaw soft = plane_strain(1.0, 0.3);
  const fe::ConstitutiveLaw stiff = plane_strain(10.0, 0.3);
  const MultiMaterialWedge same{{{-0.5 * pi, 0.0, soft}, {0.0, 0.5 * pi, soft}}, false, {}};
  EXPECT_EQ(singularity_exponent(same), 1.0);
  const MultiMaterialWedge ends{{{-0.5 * pi, 0.0, soft}, {0.0, 0.5 * pi, stiff}}, false, {}};
  const MultiMaterialWedge swapped{{{-0.5 * pi, 0.0, stiff}, {0.0, 0.5 * pi, soft}}, false, {}};
  EXPECT_LT(singularity_exponent(ends), 0.9);
  EXPECT_NEAR(singularity_exponent(ends), singularity_exponent(swapped), 1e-6);
  // a corner of an inclusion, the body going all round; a very stiff one is nearly a clamp
  const MultiMaterialWedge corner{{{0.0, 0.5 * pi, stiff}, {0.5 * pi, 2.0 * pi, soft}}, true, {}};
  EXPECT_LT(singularity_exponent(corner), 0.9);
  const MultiMaterialWedge none{{{0.0, 0.5 * pi, soft}, {0.5 * pi, 2.0 * pi, soft}}, true, {}};
  EXPECT_EQ(singularity_exponent(none), 1.0);
}

} // namespace
} // namespace spricka::test_wedge
