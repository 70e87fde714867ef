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

TEST(SmoothLine, PolylineEndsAlongTheTangentAndHardlyKinks) {
  const geometry::SplineCurve curve(arc_points(0.8, 12), false);
  const std::vector<Vec3> line = polyline_of_curve(curve, 0.0, curve.length(), true);
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
