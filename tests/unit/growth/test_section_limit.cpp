// SPDX-License-Identifier: GPL-3.0-or-later
// The plastic limit of a section under force and moments.
#include "growth/section_limit.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace spricka::test_section_limit {
namespace {

using base::Vec2;
using growth::SectionPiece;

// A rectangle about the origin.
std::vector<SectionPiece> rectangle(double width, double height, int n) {
  std::vector<SectionPiece> pieces;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const Vec2 part((i + 0.5) / n - 0.5, (k + 0.5) / n - 0.5);
      pieces.push_back({{width * part.x(), height * part.y()}, width * height / (n * n)});
    }
  }
  return pieces;
}

TEST(SectionLimit, RectangleUnderForceAndMoment) {
  const double s = 3.0;
  const std::vector<SectionPiece> section = rectangle(5.0, 2.0, 200);
  const double N_p = s * 10.0;
  const double M_p = s * 0.25 * 2.0 * 25.0;
  for (const double n : {0.0, 0.2, 0.6, 1.0}) {
    const double m = 1.0 - n * n; // on the limit
    EXPECT_NEAR(growth::plastic_load_ratio(section, {n * N_p, {m * M_p, 0.0}}, s), 1.0, 1e-4) << n;
    EXPECT_NEAR(
        growth::plastic_load_ratio(section, {-0.5 * n * N_p, {0.0, 0.5 * m * M_p * 2.0 / 5.0}}, s),
        0.5, 1e-4)
        << n;
  }
}

TEST(SectionLimit, CircleUnderAMomentAskew) {
  constexpr int rings = 100;
  constexpr int sectors = 360;
  std::vector<SectionPiece> section;
  for (int i = 0; i < rings; ++i) {
    for (int k = 0; k < sectors; ++k) {
      const double r = (i + 0.5) / rings;
      const double at = 2.0 * std::numbers::pi * (k + 0.5) / sectors;
      section.push_back(
          {{r * std::cos(at), r * std::sin(at)}, 2.0 * std::numbers::pi * r / (rings * sectors)});
    }
  }
  const double M_p = 4.0 / 3.0; // s 4 R^3 / 3
  EXPECT_NEAR(growth::plastic_load_ratio(section, {0.0, {0.6 * M_p, -0.8 * M_p}}, 1.0), 1.0, 1e-3);
}

// A force beside the middle: moments about any origin give the same.
TEST(SectionLimit, DoesNotDependOnTheOrigin) {
  std::vector<SectionPiece> section = rectangle(4.0, 3.0, 60);
  const double here = growth::plastic_load_ratio(section, {2.0, {1.0, -0.7}}, 1.0);
  const Vec2 shift(10.0, -4.0);
  for (SectionPiece& piece : section) {
    piece.at += shift;
  }
  const double there =
      growth::plastic_load_ratio(section, {2.0, Vec2(1.0, -0.7) + 2.0 * shift}, 1.0);
  EXPECT_NEAR(there / here, 1.0, 1e-6);
}

TEST(SectionLimit, NothingCarriesNothing) {
  EXPECT_EQ(growth::plastic_load_ratio(rectangle(1.0, 1.0, 4), {}, 1.0), 0.0);
  EXPECT_EQ(growth::plastic_load_ratio(std::vector<SectionPiece>(), {1.0, Vec2::Zero()}, 1.0), 0.0);
}

} // namespace
} // namespace spricka::test_section_limit
