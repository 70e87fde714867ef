// SPDX-License-Identifier: GPL-3.0-or-later
// Fields carried along fronts: their gradients and the divergence of their stress against
// differences, on a front that bends and turns.
#include "crack/moving_field.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::crack::test_moving_field {
namespace {

using base::Vec3;

const FrontBody body{1.3, 0.9, 1.3 / (2.0 * (1.3 + 0.9)), 0.7};

// Part of a helix whose crack turns about it.
mesh::FrontCurve twisted() {
  std::vector<Vec3> x;
  std::vector<Vec3> b;
  for (int i = 0; i <= 60; ++i) {
    const double a = 0.05 * i;
    x.emplace_back(2.0 * std::cos(a), -2.0 * std::sin(a), 0.4 * a);
    b.push_back(Vec3(0.3 * std::cos(a) * a, -0.3 * std::sin(a) * a, 1.0).normalized());
  }
  return {x, b, false};
}

class Partner : public testing::TestWithParam<std::size_t> {};

TEST_P(Partner, SectionHasItsDerivatives) {
  const auto at = [&](double y, double z) {
    return section_field(GetParam(), {std::hypot(y, z), std::atan2(z, y)}, body);
  };
  const double y = -0.3;
  const double z = 0.4;
  const double h = 1e-5;
  const SectionField w = at(y, z);
  const double size = w.w_yy.norm() + w.w_zz.norm();
  EXPECT_LT((w.w_y - (at(y + h, z).w - at(y - h, z).w) / (2.0 * h)).norm(), 1e-8 * size);
  EXPECT_LT((w.w_z - (at(y, z + h).w - at(y, z - h).w) / (2.0 * h)).norm(), 1e-8 * size);
  EXPECT_LT((w.w_yy - (at(y + h, z).w_y - at(y - h, z).w_y) / (2.0 * h)).norm(), 1e-8 * size);
  EXPECT_LT((w.w_yz - (at(y, z + h).w_y - at(y, z - h).w_y) / (2.0 * h)).norm(), 1e-8 * size);
  EXPECT_LT((w.w_zz - (at(y, z + h).w_z - at(y, z - h).w_z) / (2.0 * h)).norm(), 1e-8 * size);
}

TEST_P(Partner, GradientIsThatOfTheDisplacement) {
  const FrontAxes axes(twisted());
  const Vec3 x = axes.locate_point(Vec3(1.2, -1.5, 0.5)).frame.x + Vec3(0.2, -0.1, 0.3);
  const auto displacement = [&](const Vec3& at) -> Vec3 {
    const FrontCoordinates place = axes.locate_point(at);
    return FrontAxesDerivatives(place).Q *
           section_field(GetParam(), {place.r, place.theta}, body).w;
  };
  Tensor<3> differences;
  const double h = 1e-5;
  for (int k = 0; k < 3; ++k) {
    const Vec3 step = h * Vec3::Unit(k);
    differences.col(k) = (displacement(x + step) - displacement(x - step)) / (2.0 * h);
  }
  const Tensor<3> H = front_auxiliary_field(GetParam(), axes.locate_point(x), body).H;
  EXPECT_LT((H - differences).norm(), 1e-5 * H.norm());
}

TEST_P(Partner, DivergenceIsThatOfTheStress) {
  const FrontAxes axes(twisted());
  const Vec3 x = axes.locate_point(Vec3(1.2, -1.5, 0.5)).frame.x + Vec3(0.2, -0.1, 0.3);
  const auto stress = [&](const Vec3& at) {
    return front_auxiliary_field(GetParam(), axes.locate_point(at), body).sigma;
  };
  const double h = 1e-5;
  Vec3 differences = Vec3::Zero();
  double size = 0.0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 step = h * Vec3::Unit(k);
    const Tensor<3> slope = (stress(x + step) - stress(x - step)) / (2.0 * h);
    differences += slope.col(k);
    size += slope.norm();
  }
  const Vec3 divergence = front_auxiliary_field(GetParam(), axes.locate_point(x), body).divergence;
  EXPECT_LT((divergence - differences).norm(), 2e-5 * size);
  EXPECT_GT(divergence.norm(), 1e-3 * size); // the turning of the axes is seen
}

// Beyond an open end axes turn as they do there: a stress that jumps would be a load.
TEST_P(Partner, GoesOnBeyondOpenEnds) {
  const mesh::FrontCurve curve = twisted();
  const FrontAxes axes(curve);
  for (const double s : {0.0, curve.length()}) {
    const mesh::FrontFrame end = curve.at(s);
    const Vec3 x = end.x - 0.3 * end.m + 0.2 * end.b;
    const auto stress = [&](double along) {
      return front_auxiliary_field(GetParam(), axes.locate_point(x + along * end.t), body).sigma;
    };
    const double h = 1e-6;
    EXPECT_LT((stress(h) - stress(-h)).norm(), 1e-5 * stress(h).norm());
    // no faster beyond it than before it
    const double before = s > 0.0 ? -0.2 : 0.2;
    EXPECT_LT((stress(-before) - stress(0.0)).norm(),
              2.0 * (stress(before) - stress(0.0)).norm() + 1e-2 * stress(0.0).norm());
  }
}

INSTANTIATE_TEST_SUITE_P(All, Partner, testing::Values(1U, 2U, 3U, 4U));

TEST(FrontAxes, AgreeWithTheCurve) {
  const mesh::FrontCurve curve = twisted();
  const FrontAxes axes(curve);
  for (const double s : {0.0, 0.31, 2.0, 4.444, 5.5}) {
    const mesh::FrontFrame frame = curve.at(s);
    const FrontCoordinates place = axes.locate_point(frame.x + 0.3 * frame.m - 0.2 * frame.b);
    EXPECT_NEAR(place.frame.s, s, 1e-4); // cubic between stations
    EXPECT_NEAR(place.y, 0.3, 1e-4);
    EXPECT_NEAR(place.z, -0.2, 1e-4);
    EXPECT_LT((place.frame.dm - frame.dm).norm(), 1e-2); // chords of the true ones
  }
  const mesh::FrontFrame end = curve.at(curve.length());
  const FrontCoordinates beyond = axes.locate_point(end.x + 0.1 * end.t + 0.2 * end.m);
  EXPECT_NEAR(beyond.frame.s, curve.length() + 0.1, 0.1 * 0.2); // on a bend
  EXPECT_NEAR(beyond.r, 0.2, 0.1 * 0.1);
  EXPECT_LT((beyond.frame.t - end.t).norm(), 0.1);
  EXPECT_NEAR(beyond.frame.dt.norm(), end.dt.norm(), 1e-2 * end.dt.norm());
}

TEST(FrontAxes, GoRoundAClosedFront) {
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 40;
    points.emplace_back(std::cos(a), -std::sin(a), 0.0);
  }
  const mesh::FrontCurve curve(points, std::vector<Vec3>(points.size(), Vec3::UnitZ()), true);
  const FrontAxes axes(curve);
  for (const double angle : {-0.01, 0.0, 0.005, 3.0, 6.28}) {
    const Vec3 out(std::cos(angle), -std::sin(angle), 0.0);
    const FrontCoordinates place = axes.locate_point(1.2 * out);
    EXPECT_LT((place.frame.m - out).norm(), 1e-5);
    EXPECT_NEAR(place.y, 0.2, 1e-5);
    // A circle turns evenly: what the curve's third derivatives do does not come through.
    EXPECT_LT((place.frame.dm - place.frame.t).norm(), 1e-4);
    EXPECT_LT((place.ddm + place.frame.m).norm(), 5e-3);
  }
}

} // namespace
} // namespace spricka::crack::test_moving_field
