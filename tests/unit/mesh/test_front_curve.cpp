// SPDX-License-Identifier: GPL-3.0-or-later
// The spline of a front against circles, ellipses and lines.
#include "mesh/front_curve.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::mesh::test_front_curve {
namespace {

using base::Vec3;
constexpr double pi = std::numbers::pi;

// An ellipse in the plane z = 0 with b = z: m points outwards where t runs clockwise.
Vec3 on_ellipse(double p, double q, double angle) {
  return {p * std::cos(angle), -q * std::sin(angle), 0.0};
}

FrontCurve ellipse(double p, double q, int count, double part = 1.0) {
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(count));
  const bool closed = part == 1.0;
  for (int i = 0; i < count; ++i) {
    points.push_back(on_ellipse(p, q, 2.0 * pi * part * i / (closed ? count : count - 1)));
  }
  return {points, std::vector<Vec3>(points.size(), Vec3::UnitZ()), closed};
}

TEST(FrontCurve, CircleHasItsLengthAxesAndCurvature) {
  const FrontCurve curve = ellipse(2.0, 2.0, 64);
  EXPECT_NEAR(curve.length(), 4.0 * pi, 1e-5);
  for (const double angle : {0.1, 1.0, 2.5, 4.0, 6.2}) {
    const FrontFrame frame = curve.at(2.0 * angle);
    const Vec3 out = on_ellipse(1.0, 1.0, angle);
    EXPECT_LT((frame.x - 2.0 * out).norm(), 1e-5);
    EXPECT_LT((frame.m - out).norm(), 1e-5);
    EXPECT_LT((frame.m.cross(frame.b) - frame.t).norm(), 1e-14);
    EXPECT_NEAR(frame.curvature(), 0.5, 1e-3);
    EXPECT_LT((frame.dm - 0.5 * frame.t).norm(), 1e-3);
    EXPECT_NEAR(curve.nearest_length(2.7 * out + 0.4 * Vec3::UnitZ()), 2.0 * angle, 1e-4);
  }
}

TEST(FrontCurve, ErrorFallsWithTheFourthPower) {
  const auto error = [](int count) {
    const FrontCurve curve = ellipse(1.0, 0.3, count);
    double worst = 0.0;
    for (int i = 0; i < 500; ++i) {
      const Vec3 x = curve.at(curve.length() * i / 500.0).x;
      // on the ellipse, by its equation
      worst = std::max(worst, std::abs(x.x() * x.x() + x.y() * x.y() / 0.09 - 1.0));
    }
    return worst;
  };
  const double coarse = error(40);
  const double fine = error(80);
  EXPECT_LT(fine, 1e-4);
  EXPECT_GT(coarse / fine, 11.0);
}

TEST(FrontCurve, OpenFrontHasNoKinkAtItsEndsAndGoesOnStraight) {
  const FrontCurve curve = ellipse(1.0, 1.0, 33, 0.25);
  EXPECT_NEAR(curve.length(), 0.5 * pi, 1e-6);
  EXPECT_NEAR(curve.at(0.0).curvature(), 1.0, 5e-3);
  const Vec3 beyond = curve.at(-0.2).x;
  EXPECT_LT((beyond - Vec3(1.0, 0.2, 0.0)).norm(), 1e-4);
  EXPECT_NEAR(curve.nearest_length({1.1, 0.2, 0.3}), -0.2, 1e-4);
}

TEST(FrontCurve, DerivativesOfTheAxesAreTheirDifferences) {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  for (int i = 0; i <= 40; ++i) { // a front that climbs and whose crack leans more and more
    const double u = 0.05 * i;
    points.emplace_back(std::cos(u), -std::sin(u), 0.1 * u * u);
    normals.push_back(Vec3(0.2 * u, 0.1, 1.0).normalized());
  }
  const FrontCurve curve(points, normals, false);
  const double d = 1e-5;
  for (const double s : {0.21, 0.77, 1.3}) {
    const FrontFrame frame = curve.at(s);
    const FrontFrame before = curve.at(s - d);
    const FrontFrame after = curve.at(s + d);
    EXPECT_LT((frame.t - (after.x - before.x) / (2.0 * d)).norm(), 1e-8);
    EXPECT_LT((frame.dt - (after.t - before.t) / (2.0 * d)).norm(), 1e-6);
    EXPECT_LT((frame.db - (after.b - before.b) / (2.0 * d)).norm(), 1e-6);
    EXPECT_LT((frame.dm - (after.m - before.m) / (2.0 * d)).norm(), 1e-6);
  }
}

TEST(FrontCurve, StraightFrontOfTwoPoints) {
  const FrontCurve curve({{0.0, 0.0, 0.0}, {0.0, 0.0, 3.0}}, {Vec3::UnitY(), Vec3::UnitY()}, false);
  EXPECT_DOUBLE_EQ(curve.length(), 3.0);
  EXPECT_LT((curve.at(1.0).m - Vec3::UnitX()).norm(), 1e-15);
  EXPECT_NEAR(curve.nearest_length({0.4, 0.2, 1.7}), 1.7, 1e-14);
}

} // namespace
} // namespace spricka::mesh::test_front_curve
