// SPDX-License-Identifier: GPL-3.0-or-later
// Series of ever finer meshes: the power of the error, plateaus, errors that pass through zero.
#include "program/study/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace spricka::program::test_convergence {
namespace {

constexpr double sizes[] = {2.0, 1.4, 1.0, 0.7, 0.5};

std::vector<MeshSizeAndError> by_law(double factor, double power, double floor = 0.0) {
  std::vector<MeshSizeAndError> points;
  for (const double size : sizes) {
    points.push_back({size, factor * std::pow(size, power) + floor});
  }
  return points;
}

TEST(Convergence, the_power_of_a_law_is_found) {
  for (const double power : {0.5, 1.0, 2.0, 4.0, 6.3}) {
    const auto slope = fit_convergence_rate(by_law(0.03, power), 0.0);
    ASSERT_TRUE(slope);
    EXPECT_NEAR(slope->power, power, 1e-4);
    EXPECT_NEAR(slope->factor, 0.03, 1e-5);
    EXPECT_EQ(slope->points, 5U);
  }
}

TEST(Convergence, differences_to_the_finest_mesh_give_the_same_power) {
  for (const double power : {1.0, 2.0, 4.0}) {
    std::vector<MeshSizeAndError> points = by_law(0.03, power);
    const double last = points.back().error;
    for (MeshSizeAndError& point : points) {
      point.error -= last;
    }
    const auto slope = fit_convergence_rate(points, 0.0, points.back().size);
    ASSERT_TRUE(slope);
    EXPECT_EQ(slope->points, 4U);
    EXPECT_NEAR(slope->power, power, 1e-4);
    // Taken for errors they would seem to fall faster.
    const auto taken = fit_convergence_rate(std::span(points).first(4), 0.0);
    ASSERT_TRUE(taken);
    EXPECT_GT(taken->power, power + 0.2);
  }
}

TEST(Convergence, two_points_or_points_below_the_floor_make_no_slope) {
  const std::vector<MeshSizeAndError> points = by_law(1e-3, 2.0);
  EXPECT_FALSE(fit_convergence_rate(std::span(points).first(2), 0.0));
  EXPECT_FALSE(fit_convergence_rate(points, 1e-3)); // sizes 2 and 1.4 alone are above it
  EXPECT_TRUE(fit_convergence_rate(points, 0.9e-3));
}

TEST(Convergence, an_error_that_passes_through_zero_is_not_trusted) {
  std::vector<MeshSizeAndError> points = by_law(1e-3, 2.0);
  points[2].error = 1e-9; // luck
  const std::vector<double> lasting = error_envelope(points);
  EXPECT_DOUBLE_EQ(lasting[2], points[3].error);
  EXPECT_DOUBLE_EQ(lasting[0], points[0].error);
  EXPECT_DOUBLE_EQ(lasting[4], points[4].error);
}

TEST(Convergence, a_plateau_begins_where_errors_stop_falling) {
  EXPECT_FALSE(find_error_plateau(by_law(1e-3, 4.0)));
  EXPECT_FALSE(find_error_plateau(by_law(1e-3, 0.6)));
  const auto plateau = find_error_plateau(by_law(1e-3, 4.0, 1e-3));
  ASSERT_TRUE(plateau);
  EXPECT_EQ(plateau->first, 3U); // 1.24e-3 and 1.06e-3
  EXPECT_NEAR(plateau->level, 1.24e-3, 1e-5);
  EXPECT_FALSE(find_error_plateau(std::vector<MeshSizeAndError>{{2.0, 1e-15}, {1.0, 2e-15}}))
      << "round-off";
}

} // namespace
} // namespace spricka::program::test_convergence
