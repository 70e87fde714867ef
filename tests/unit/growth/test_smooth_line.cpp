// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/smooth_line.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace spricka::growth::test_smooth_line {
namespace {

using base::Vec3;

std::vector<Vec3> arc_points(double alpha, int pieces) {
  std::vector<Vec3> points;
  for (int k = 0; k <= pieces; ++k) {
    const double t = alpha * (2.0 * k / pieces - 1.0);
    points.emplace_back(2.0 * std::sin(t), 2.0 * std::cos(t), 0.0);
  }
  return points;
}

TEST(SmoothLine, KeepsToACircleWithTheFourthOrderOfItsSpacing) {
  double before = 0.0;
  for (const int pieces : {8, 16, 32}) {
    const SmoothCurve curve(arc_points(1.0, pieces));
    double off = 0.0;
    for (int k = 0; k <= 100; ++k) {
      const double s = curve.length() * k / 100.0;
      off = std::max(off, std::abs(curve.at(s).norm() - 2.0));
      EXPECT_NEAR(curve.tangent(s).dot(curve.at(s)), 0.0, 0.1 / pieces);
      EXPECT_NEAR(curve.curvature(s), 0.5, 0.5 / pieces);
    }
    EXPECT_NEAR(curve.length(), 4.0, 0.02 / pieces);
    if (before > 0.0) {
      EXPECT_LT(off, before / 10.0);
    }
    before = off;
  }
  EXPECT_LT(before, 1e-6);
}

TEST(SmoothLine, DrawsAParabolaThroughThreePoints) {
  // chords of equal length, so that the parameter is x
  const SmoothCurve curve({{-1, 1, 0}, {0, 0, 0}, {1, 1, 0}});
  for (int k = 0; k <= 10; ++k) {
    const Vec3 x = curve.at(curve.length() * k / 10.0);
    EXPECT_NEAR(x.y(), x.x() * x.x(), 1e-12);
  }
}

TEST(SmoothLine, GoesStraightOnBeyondItsEnds) {
  const SmoothCurve curve(arc_points(0.5, 10));
  const Vec3 end = curve.at(curve.length());
  EXPECT_NEAR((curve.at(curve.length() + 0.3) - end - 0.3 * curve.tangent(curve.length())).norm(),
              0.0, 1e-12);
  EXPECT_NEAR((curve.at(-0.3) - curve.at(0.0) + 0.3 * curve.tangent(0.0)).norm(), 0.0, 1e-12);
}

TEST(SmoothLine, PolylineEndsAlongTheTangentAndHardlyKinks) {
  const SmoothCurve curve(arc_points(0.8, 12));
  const std::vector<Vec3> line = as_polyline(curve, 0.0, curve.length(), true);
  ASSERT_GT(line.size(), 10U);
  const Vec3 out = (line.back() - line[line.size() - 2]).normalized();
  EXPECT_NEAR((out - curve.tangent(curve.length())).norm(), 0.0, 1e-12);
  const Vec3 in = (line[1] - line[0]).normalized();
  EXPECT_NEAR((in - curve.tangent(0.0)).norm(), 0.0, 1e-12);
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Vec3 a = (line[i] - line[i - 1]).normalized();
    const Vec3 b = (line[i + 1] - line[i]).normalized();
    EXPECT_LT(a.cross(b).norm(), 0.07);
    EXPECT_NEAR(line[i].norm(), 2.0, 2e-3);
  }
}

} // namespace
} // namespace spricka::growth::test_smooth_line
