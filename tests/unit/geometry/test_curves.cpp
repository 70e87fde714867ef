// SPDX-License-Identifier: GPL-3.0-or-later
// Cubic splines, curves by their arc length, segments and polylines, against closed forms.
#include "geometry/polyline.hpp"
#include "geometry/spline_curve.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::geometry::test_curves {
namespace {

using base::Vec2;
using base::Vec3;
constexpr double pi = std::numbers::pi;

template <class Value, class F>
CubicSpline<Value> through(const std::vector<double>& knots, const F& f,
                           SplineEndCondition ends = SplineEndCondition::not_a_knot) {
  std::vector<Value> values;
  for (const double x : knots) {
    values.push_back(f(x));
  }
  if (ends == SplineEndCondition::periodic) {
    values.back() = values.front();
  }
  return CubicSpline<Value>(knots, values, ends);
}

// A cubic is its own spline with all of its derivatives, beyond the knots too.
TEST(CubicSpline, ReproducesCubics) {
  const Vec2 c0(1.0, 0.3);
  const Vec2 c1(-2.0, 0.7);
  const Vec2 c2(0.5, -1.1);
  const Vec2 c3(0.3, 0.2);
  const auto cubic = [&](double x) -> Vec2 { return c0 + x * (c1 + x * (c2 + x * c3)); };
  for (const std::vector<double>& knots :
       {std::vector{-1.0, 0.2, 0.9, 2.5, 3.0}, std::vector{-1.0, 0.0, 2.0, 3.0}}) {
    const CubicSpline<Vec2> spline = through<Vec2>(knots, cubic);
    const CubicSpline<double> number =
        through<double>(knots, [&](double x) { return cubic(x).y(); });
    for (double x = -1.5; x < 3.5; x += 0.1) {
      const SplinePosition at = spline.locate(x);
      EXPECT_LT((spline.value(x) - cubic(x)).norm(), 1e-12);
      EXPECT_LT((spline.first_derivative(at) - (c1 + x * (2.0 * c2 + 3.0 * x * c3))).norm(), 1e-12);
      EXPECT_LT((spline.second_derivative(at) - (2.0 * c2 + 6.0 * x * c3)).norm(), 1e-11);
      EXPECT_NEAR(number.value(x), cubic(x).y(), 1e-12);
    }
  }
}

TEST(CubicSpline, IsAParabolaThroughThreePointsAndALineThroughTwo) {
  const CubicSpline<double> parabola({0.0, 1.0, 3.0}, {0.0, 1.0, 9.0});
  EXPECT_NEAR(parabola.value(2.0), 4.0, 1e-14);
  EXPECT_NEAR(parabola.value(-1.0), 1.0, 1e-14);
  const CubicSpline<Vec3> line({0.0, 2.0}, {Vec3(1.0, 2.0, 3.0), Vec3(3.0, 2.0, -1.0)});
  EXPECT_LT((line.value(3.0) - Vec3(4.0, 2.0, -3.0)).norm(), 1e-14);
}

// Knots are met exactly, value and both derivatives do not jump at any, and the derivatives are
// those of the value.
TEST(CubicSpline, IsTwiceContinuouslyDifferentiable) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (const SplineEndCondition ends :
       {SplineEndCondition::not_a_knot, SplineEndCondition::periodic}) {
    std::vector<double> knots{-0.3};
    for (int i = 0; i < 9; ++i) {
      knots.push_back(knots.back() + 0.2 + number(random));
    }
    const auto any = [&](double) { return Vec3(number(random), number(random), number(random)); };
    const CubicSpline<Vec3> spline = through<Vec3>(knots, any, ends);
    const std::size_t n = spline.interval_count();
    for (std::size_t i = 0; i < n; ++i) {
      const SplinePosition end{i, spline.interval_width(i)};
      EXPECT_EQ(spline.value({i, 0.0}), spline.values()[i]);
      EXPECT_EQ(spline.value(end), spline.values()[i + 1]);
      if (i + 1 < n || ends == SplineEndCondition::periodic) {
        const SplinePosition next{(i + 1) % n, 0.0};
        EXPECT_LT((spline.first_derivative(end) - spline.first_derivative(next)).norm(), 1e-12);
        EXPECT_LT((spline.second_derivative(end) - spline.second_derivative(next)).norm(), 1e-11);
      }
      const double d = 1e-4;
      const double u = 0.37 * spline.interval_width(i);
      const Vec3 before = spline.value({i, u - d});
      const Vec3 here = spline.value({i, u});
      const Vec3 after = spline.value({i, u + d});
      EXPECT_LT((spline.first_derivative({i, u}) - (after - before) / (2.0 * d)).norm(), 1e-5);
      EXPECT_LT((spline.second_derivative({i, u}) - (after - 2.0 * here + before) / (d * d)).norm(),
                1e-5);
    }
  }
}

TEST(CubicSpline, PeriodicOneConvergesToTheSineWithTheFourthPowerAndIsRepeated) {
  const auto error = [](int count) {
    std::vector<double> knots;
    for (int i = 0; i <= count; ++i) {
      knots.push_back(2.0 * pi * (i + 0.2 * std::sin(2.0 * pi * i / count)) / count);
    }
    const auto sine = [](double x) { return std::sin(x); };
    const CubicSpline<double> spline = through<double>(knots, sine, SplineEndCondition::periodic);
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
      const double x = -4.0 + 0.05 * i;
      worst = std::max(worst, std::abs(spline.value(x) - std::sin(x)));
    }
    return worst;
  };
  const double fine = error(40);
  EXPECT_LT(fine, 1e-5);
  EXPECT_GT(error(20) / fine, 11.0);
}

// Points of a circle of radius 2 from -angle to angle.
std::vector<Vec3> arc_points(double angle, int pieces) {
  std::vector<Vec3> points;
  for (int k = 0; k <= pieces; ++k) {
    const double t = angle * (2.0 * k / pieces - 1.0);
    points.emplace_back(2.0 * std::sin(t), 2.0 * std::cos(t), 0.0);
  }
  return points;
}

TEST(SplineCurve, KeepsToACircleWithTheFourthOrderOfItsSpacing) {
  for (const bool closed : {false, true}) {
    double before = 0.0;
    for (const int pieces : {8, 16, 32}) {
      std::vector<Vec3> points = arc_points(closed ? pi : 1.0, pieces);
      if (closed) {
        points.pop_back();
      }
      const SplineCurve curve(points, closed, 4);
      double off = 0.0;
      for (int k = 0; k <= 100; ++k) {
        const double s = curve.length() * k / 100.0;
        off = std::max(off, std::abs(curve.at(s).norm() - 2.0));
        EXPECT_NEAR(curve.tangent(s).dot(curve.at(s)), 0.0, 0.4 / pieces);
        EXPECT_NEAR(curve.curvature(s), 0.5, 1.0 / pieces);
      }
      EXPECT_NEAR(curve.length(), closed ? 4.0 * pi : 4.0, 0.2 / pieces);
      if (before > 0.0) {
        EXPECT_LT(off, before / 10.0);
      }
      before = off;
    }
    EXPECT_LT(before, 2e-5);
  }
}

TEST(SplineCurve, RunsWithUnitSpeedWhateverThePartsOfItsLength) {
  const SplineCurve one(arc_points(1.2, 12), false);
  const SplineCurve four(arc_points(1.2, 12), false, 4);
  EXPECT_NEAR(one.length(), four.length(), 1e-10);
  const double d = 1e-4;
  for (double s = 0.05; s < one.length() - 0.05; s += 0.31) {
    const Vec3 difference = (one.at(s + d) - one.at(s - d)) / (2.0 * d);
    EXPECT_NEAR(difference.norm(), 1.0, 1e-7);
    EXPECT_LT((difference - one.tangent(s)).norm(), 1e-7);
    EXPECT_LT((one.at(s) - four.at(s)).norm(), 1e-10);
  }
}

TEST(SplineCurve, DrawsAParabolaThroughThreePoints) {
  // chords of equal length, so that the parameter is x
  const SplineCurve curve({{-1, 1, 0}, {0, 0, 0}, {1, 1, 0}}, false, 4);
  for (int k = 0; k <= 10; ++k) {
    const Vec3 x = curve.at(curve.length() * k / 10.0);
    EXPECT_NEAR(x.y(), x.x() * x.x(), 1e-12);
  }
}

TEST(SplineCurve, GoesStraightOnBeyondItsEndsAndRoundWhereItIsClosed) {
  const SplineCurve open(arc_points(0.5, 10), false);
  const double end = open.length();
  EXPECT_LT((open.at(end + 0.3) - open.at(end) - 0.3 * open.tangent(end)).norm(), 1e-12);
  EXPECT_LT((open.at(-0.3) - open.at(0.0) + 0.3 * open.tangent(0.0)).norm(), 1e-12);
  EXPECT_EQ(open.curvature(-0.1), 0.0);
  EXPECT_EQ(open.curvature(end + 0.1), 0.0);
  std::vector<Vec3> points = arc_points(pi, 24);
  points.pop_back();
  const SplineCurve closed(points, true);
  EXPECT_LT((closed.at(0.7) - closed.at(0.7 - 2.0 * closed.length())).norm(), 1e-12);
}

// A place beside the curve, at right angles to it, belongs to the length that it stands at.
TEST(SplineCurve, FindsTheNearestLength) {
  const SplineCurve curve(arc_points(1.0, 12), false);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-0.4, 0.4);
  for (double s = 0.01; s < curve.length(); s += 0.13) {
    const Vec3 t = curve.tangent(s);
    const Vec3 across = t.cross(Vec3::UnitZ());
    const Vec3 x = curve.at(s) + number(random) * across + number(random) * Vec3::UnitZ();
    EXPECT_NEAR(curve.nearest_length(x), s, 1e-9);
  }
  const double end = curve.length();
  EXPECT_NEAR(curve.nearest_length(curve.at(end + 0.2)), end + 0.2, 1e-12);
  EXPECT_NEAR(curve.nearest_length(curve.at(-0.2)), -0.2, 1e-12);
}

// No other point of a segment is nearer.
template <int dim> void check_segments() {
  std::srand(5);
  for (int i = 0; i < 200; ++i) {
    const shape::Point<dim> a = shape::Point<dim>::Random();
    const shape::Point<dim> b = shape::Point<dim>::Random();
    const shape::Point<dim> x = 2.0 * shape::Point<dim>::Random();
    const NearestSegmentPoint on = nearest_point(x, a, b);
    EXPECT_NEAR(on.distance, (a + on.part * (b - a) - x).norm(), 1e-15);
    EXPECT_EQ(on.distance, distance_to_segment(x, a, b));
    EXPECT_EQ(on.part, nearest_segment_parameter(x, a, b));
    for (const double part : {0.0, on.part - 1e-3, on.part + 1e-3, 1.0}) {
      if (part >= 0.0 && part <= 1.0) {
        EXPECT_GE((a + part * (b - a) - x).norm(), on.distance - 1e-15);
      }
    }
    const NearestSegmentPoint at_point = nearest_point(x, a, a);
    EXPECT_EQ(at_point.part, 0.0);
    EXPECT_EQ(at_point.distance, (x - a).norm());
  }
}

TEST(Segment, HasItsNearestPointInThePlaneAndInSpace) {
  check_segments<2>();
  check_segments<3>();
}

TEST(Polyline, FindsTheFirstOfTheNearestPlaces) {
  const std::vector<Vec3> line{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const NearestPolylinePoint on = nearest_point(Vec3(1.5, 0.25, 1.0), line);
  EXPECT_EQ(on.piece, 0U);
  EXPECT_DOUBLE_EQ(on.part, 0.75);
  EXPECT_DOUBLE_EQ(on.distance, std::hypot(0.25, 1.0));
  EXPECT_LT((on.interpolate(line) - Vec3(1.5, 0.0, 0.0)).norm(), 1e-15);
  const NearestPolylinePoint corner = nearest_point(Vec3(3.0, -1.0, 0.0), line);
  EXPECT_EQ(corner.piece, 0U);
  EXPECT_EQ(corner.part, 1.0);
  EXPECT_EQ(nearest_point(Vec2(1.0, 1.0), std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}}).piece, 0U);
  EXPECT_GT(nearest_point(Vec2(1.0, 1.0), std::vector<Vec2>{{0, 0}}).distance, 1e300);
}

TEST(Polyline, HasDirectionsLengthsAndPlacesByLength) {
  const std::vector<Vec2> open{{0, 0}, {3, 0}, {3, 4}};
  EXPECT_EQ(polyline_direction_at(open, 0), Vec2(1, 0));
  EXPECT_EQ(polyline_direction_at(open, 2), Vec2(0, 1));
  EXPECT_LT((polyline_direction_at(open, 1) - Vec2(0.6, 0.8)).norm(), 1e-15);
  EXPECT_EQ(arc_lengths(open), (std::vector<double>{0.0, 3.0, 7.0}));
  EXPECT_EQ(polyline_length(open), 7.0);
  EXPECT_EQ(polyline_length(std::vector<Vec2>{}), 0.0);
  const std::vector<double> arc = arc_lengths(open);
  for (const auto& [s, x] : {std::pair(1.5, Vec2(1.5, 0)), std::pair(4.0, Vec2(3, 1)),
                             std::pair(-1.0, Vec2(0, 0)), std::pair(9.0, Vec2(3, 4))}) {
    EXPECT_LT((position_at_length(arc, s).interpolate(open) - x).norm(), 1e-15);
  }
  EXPECT_EQ(position_at_length(arc, 3.0).piece, 1U);
  const std::vector<Vec3> closed{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
  const Vec3 across = Vec3(1.0, -1.0, 0.0).normalized();
  EXPECT_LT((polyline_direction_at(closed, 0) - across).norm(), 1e-15);
  EXPECT_LT((polyline_direction_at(closed, 4) - across).norm(), 1e-15);
}

TEST(Outline, IsClosedByTheSideToItsFirstCorner) {
  const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_DOUBLE_EQ(distance_to_outline(Vec2(0.25, 1.0), square), 0.25);
  EXPECT_DOUBLE_EQ(distance_to_outline(Vec2(-1.0, 1.0), square), 1.0);
  EXPECT_DOUBLE_EQ(distance_to_outline(Vec2(3.0, 3.0), square), std::sqrt(2.0));
  EXPECT_GT(distance_to_outline(Vec2(0.0, 0.0), std::vector<Vec2>{}), 1e300);
}

} // namespace
} // namespace spricka::geometry::test_curves
