// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/round.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::contact::test_round {
namespace {

using base::Vec3;
constexpr double pi = std::numbers::pi;

// Points and normals of a shape over a part of it, in an oblique frame.
struct Samples {
  std::vector<Vec3> points;
  std::vector<PointNormal> normals;
  double extent = 0.0;
};

Samples sampled(const AnalyticShape& shape, double angle, double length) {
  Samples all;
  const Vec3 e1 = shape.axis.unitOrthogonal();
  const Vec3 e2 = shape.axis.cross(e1);
  Vec3 low = Vec3::Constant(1e300);
  Vec3 high = -low;
  for (int i = 0; i <= 8; ++i) {
    for (int k = 0; k <= 5; ++k) {
      const double t = angle * i / 8.0;
      const double z = length * k / 5.0;
      const Vec3 radial = std::cos(t) * e1 + std::sin(t) * e2;
      Vec3 x;
      if (shape.kind == AnalyticShapeKind::sphere) {
        const double up = 0.4 * k / 5.0;
        x = shape.point + shape.radius * (std::cos(up) * radial + std::sin(up) * shape.axis);
      } else if (shape.kind == AnalyticShapeKind::plane) {
        x = shape.point + length * (i / 8.0 * e1 + k / 5.0 * e2);
      } else {
        x = shape.point + z * shape.axis + (shape.radius + shape.slope * z) * radial;
      }
      all.points.push_back(x);
      all.normals.push_back({x, outer_normal(shape, x)});
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
  }
  all.extent = (high - low).norm();
  return all;
}

AnalyticShape shape_of(AnalyticShapeKind kind, double sense) {
  AnalyticShape shape;
  shape.kind = kind;
  shape.point = {3.0, -7.0, 11.0};
  shape.axis = Vec3(0.3, -0.2, 0.9).normalized();
  shape.radius = 5.0;
  shape.slope = kind == AnalyticShapeKind::cone ? 0.2 : 0.0;
  shape.sense = sense;
  return shape;
}

class Fit : public testing::TestWithParam<std::tuple<AnalyticShapeKind, double, double>> {};

TEST_P(Fit, FindsTheShapeOfItsPoints) {
  const auto [kind, sense, angle] = GetParam();
  const AnalyticShape shape = shape_of(kind, sense);
  const Samples samples = sampled(shape, angle, 4.0);
  const std::optional<AnalyticShape> found =
      fit_analytic_shape(samples.points, samples.normals, samples.extent);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, kind);
  EXPECT_TRUE(found->exact);
  for (const PointNormal& at : samples.normals) {
    EXPECT_LT(std::abs(signed_distance(*found, at.x)), 1e-11);
    EXPECT_LT((outer_normal(*found, at.x) - at.normal).norm(), 1e-10);
    const Vec3 off = at.x + 0.1 * at.normal; // the distance of a plane may have either sign
    EXPECT_NEAR(std::abs(signed_distance(*found, off)), 0.1, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Fit,
    testing::Combine(testing::Values(AnalyticShapeKind::plane, AnalyticShapeKind::cylinder,
                                     AnalyticShapeKind::cone, AnalyticShapeKind::sphere),
                     testing::Values(1.0, -1.0), testing::Values(2.0 * pi, 0.5 * pi, 0.7)));

TEST(Fit, NothingThatIsNone) {
  Samples samples = sampled(shape_of(AnalyticShapeKind::cylinder, 1.0), 2.0, 4.0);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-0.01, 0.01);
  for (Vec3& x : samples.points) {
    x += Vec3(off(random), off(random), off(random));
  }
  EXPECT_FALSE(fit_analytic_shape(samples.points, samples.normals, samples.extent));
}

TEST(Fit, RoundOffOfThePointsLeavesTheSameNumbers) {
  const Samples samples = sampled(shape_of(AnalyticShapeKind::cylinder, -1.0), 2.0, 4.0);
  std::vector<Vec3> fewer(samples.points.begin(), samples.points.end() - 7);
  const std::optional<AnalyticShape> one =
      fit_analytic_shape(samples.points, samples.normals, samples.extent);
  const std::optional<AnalyticShape> two =
      fit_analytic_shape(fewer, samples.normals, samples.extent);
  ASSERT_TRUE(one && two);
  EXPECT_LT((one->point - two->point).norm(), 4e-12);
  EXPECT_LT(std::abs(one->radius - two->radius), 4e-12);
}

class DistancesFromCrack : public testing::TestWithParam<AnalyticShapeKind> {};

TEST_P(DistancesFromCrack, GradientIsItsSlope) {
  const AnalyticShape shape = shape_of(GetParam(), 1.0);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-4.0, 4.0);
  constexpr double h = 1e-5;
  for (int i = 0; i < 20; ++i) {
    const Vec3 x = shape.point + Vec3(at(random), at(random), at(random));
    for (int c = 0; c < 3; ++c) {
      const Vec3 step = h * Vec3::Unit(c);
      const double slope =
          (signed_distance(shape, x + step) - signed_distance(shape, x - step)) / (2 * h);
      EXPECT_NEAR(distance_gradient(shape, x)[c], slope, 1e-7);
    }
  }
}

TEST_P(DistancesFromCrack, AlongARayItEndsOnTheShape) {
  const AnalyticShape shape = shape_of(GetParam(), 1.0);
  const Samples samples = sampled(shape, 2.0, 4.0);
  for (const PointNormal& at : samples.normals) {
    const Vec3 n = (at.normal + 0.3 * at.normal.unitOrthogonal()).normalized();
    const std::optional<double> g = distance_along_direction(shape, at.x - 0.05 * n, n);
    ASSERT_TRUE(g);
    EXPECT_NEAR(*g, 0.05, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, DistancesFromCrack,
                         testing::Values(AnalyticShapeKind::plane, AnalyticShapeKind::cylinder,
                                         AnalyticShapeKind::cone, AnalyticShapeKind::sphere));

TEST(Place, AngleAndLengthOfACylinder) {
  AnalyticShape bore;
  bore.kind = AnalyticShapeKind::cylinder;
  bore.radius = 2.0;
  const CylindricalCoordinates place = cylindrical_coordinates(bore, {0.0, 2.0, 3.0});
  EXPECT_NEAR(place.angle, 0.5 * pi, 1e-15);
  EXPECT_DOUBLE_EQ(place.along, 3.0);
}

} // namespace
} // namespace spricka::contact::test_round
