// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/tube.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::test_tube_sizes {
namespace {

using base::Vec3;

/// The front of a penny-shaped crack of radius 2 in a body that is far larger.
struct Penny {
  static constexpr double radius = 2.0;
  mesh::FrontCurve front = circle();
  mesh::TubeClearanceAlongFront room{.free = [](double) { return 100.0 * radius; },
                                     .width = [](double) { return 2.0 * radius; }};

  static mesh::FrontCurve circle() {
    constexpr int count = 64;
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / count;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    return {points, std::vector<Vec3>(count, Vec3::UnitZ()), true};
  }
};

// A quarter of the radius of curvature for each element: K at the front's points is the mean over
// such a length.
TEST(TubeSizes, ElementsAlongAPennyAreAQuarterOfItsRadiusLong) {
  const Penny penny;
  const mesh::TubeSizes sizes = mesh::choose_tube_sizes(penny.front, penny.room, {});
  const std::vector<double> stations = sizes.stations(true);
  const double around = 2.0 * std::numbers::pi / 0.25;
  EXPECT_GE(static_cast<double>(stations.size()), around);
  EXPECT_LT(static_cast<double>(stations.size()), around + 1.0);
  for (std::size_t i = 1; i < stations.size(); ++i) {
    EXPECT_LE(stations[i] - stations[i - 1], 0.25 * Penny::radius * (1.0 + 1e-3));
  }
}

TEST(TubeSizes, GivenLengthIsNotExceededAndFinerDividesIt) {
  const Penny penny;
  for (const double finer : {1.0, 2.0}) {
    mesh::TubeMeshParameters given;
    given.length = 0.3;
    given.finer = finer;
    const mesh::TubeSizes sizes = mesh::choose_tube_sizes(penny.front, penny.room, given);
    EXPECT_EQ(static_cast<double>(sizes.stations(true).size()),
              std::ceil(penny.front.length() * finer / 0.3 - 1e-9));
  }
}

// Where wanted lengths change along the front each element has its share of them.
TEST(TubeSizes, ElementsOfAnOpenFrontFollowTheWantedLengths) {
  mesh::TubeSizes sizes;
  for (int i = 0; i <= 1000; ++i) {
    sizes.s.push_back(0.01 * i);
    sizes.length.push_back(0.2 + 0.1 * sizes.s.back());
  }
  const std::vector<double> stations = sizes.stations(false);
  const double wanted = std::log(1.2 / 0.2) / 0.1; // integral of one over the length
  ASSERT_EQ(static_cast<double>(stations.size()) - 1.0, std::ceil(wanted));
  EXPECT_EQ(stations.front(), 0.0);
  EXPECT_NEAR(stations.back(), 10.0, 1e-12);
  for (std::size_t i = 1; i < stations.size(); ++i) {
    const double share = std::log((0.2 + 0.1 * stations[i]) / (0.2 + 0.1 * stations[i - 1])) / 0.1;
    EXPECT_NEAR(share, wanted / std::ceil(wanted), 1e-3);
  }
}

// Across a thin slice a front needs a point that is not on the surface.
TEST(TubeSizes, AShortOpenFrontHasAPointInside) {
  mesh::TubeSizes sizes;
  sizes.s = {0.0, 0.5, 1.0};
  sizes.length = {8.0, 8.0, 8.0};
  const std::vector<double> stations = sizes.stations(false);
  ASSERT_EQ(stations.size(), 3U);
  EXPECT_NEAR(stations[1], 0.5, 1e-12);
}

} // namespace
} // namespace spricka::test_tube_sizes
