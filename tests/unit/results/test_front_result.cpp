// SPDX-License-Identifier: GPL-3.0-or-later
// K between the points of a front: the cubic through four smooth values. Which points have what.
#include "results/k_quantities.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::results::test_front_result {
namespace {

constexpr double pi = std::numbers::pi;

double cubic(double s) {
  return 2.0 - s + 0.7 * s * s - 0.2 * s * s * s;
}

const KQuantity& quantity(std::string_view word, int dim = 3) {
  const KQuantity* const found = find_k_quantity(word, dim);
  EXPECT_NE(found, nullptr) << word;
  return *found;
}

TEST(FrontValue, IsExactForACubicUpToTheEnds) {
  FrontResult front;
  front.length = 3.0;
  for (const double s : {0.0, 0.2, 0.7, 1.1, 2.0, 3.0}) {
    FrontPointResult& place = front.points.emplace_back();
    place.s = s;
    place.x = {s, 0.0, 0.0};
    place.K1 = -1.0; // a mean over the hat is no value of the curve
    place.T = 3.0 * s;
    place.smooth = {cubic(s), 0.0, 0.0};
  }
  for (const double s : {0.0, 0.1, 0.5, 1.0, 1.7, 2.5, 3.0}) {
    EXPECT_NEAR(*front_value_at_length(front, quantity("K1"), s), cubic(s), 1e-12);
    EXPECT_NEAR(front_value_near(front, quantity("K1"), {s, 1.0, 0.0}), cubic(s), 1e-12);
    EXPECT_NEAR(*front_value_at_length(front, quantity("T"), s), 3.0 * s, 1e-12);
  }
}

TEST(FrontValue, GoesRoundAClosedFront) {
  FrontResult front;
  front.is_loop = front.has_angles = true;
  front.length = 2.0 * pi;
  constexpr int points = 24;
  for (int i = 0; i < points; ++i) {
    FrontPointResult& place = front.points.emplace_back();
    place.s = 2.0 * pi * i / points;
    place.phi = std::remainder(place.s, 2.0 * pi);
    place.smooth = {0.0, std::cos(place.s), 0.0};
  }
  // Chords would cut the curve by h^2/8, 9e-3.
  for (double phi = -pi; phi < pi; phi += 0.05) {
    EXPECT_NEAR(*front_value_at_angle(front, quantity("K2"), phi), std::cos(phi), 2e-4);
  }
}

TEST(FrontValue, TakesWhatThereIsOnAShortFront) {
  FrontResult front;
  front.length = 1.0;
  for (const double s : {0.0, 1.0}) {
    FrontPointResult& place = front.points.emplace_back();
    place.s = s;
    place.smooth = {1.0 + s, 0.0, 0.0};
  }
  EXPECT_NEAR(*front_value_at_length(front, quantity("K1"), 0.25), 1.25, 1e-14);
}

TEST(FrontValue, OfATipIsThatOfItsPoint) {
  FrontResult front;
  front.a = 2.0;
  FrontPointResult& point = front.points.emplace_back();
  point.K1 = 3.0;
  point.bar[1].mesh = 0.25;
  point.bar[1].edge = 0.5;
  EXPECT_TRUE(front.is_tip());
  EXPECT_EQ(&front.single_point(), &front.points[0]);
  EXPECT_EQ(front.single_point().number, 1);
  EXPECT_EQ(quantity("K1", 2).extract_value(front), 3.0);
  EXPECT_EQ(quantity("K2.BAR", 2).extract_value(front), 0.75);
  EXPECT_EQ(k_quantities[0].extract_value(front), 2.0);
  EXPECT_EQ(front_value_near(front, quantity("K1"), {1.0, 0.0, 0.0}), 3.0);
  EXPECT_FALSE(front_value_at_length(front, quantity("K1"), 0.0));
}

TEST(KQuantity, IsGivenWhereItsConditionHolds) {
  FrontResult front;
  front.points.resize(2);
  const FrontPointResult& inside = front.points[0];
  FrontPointResult& end = front.points[1];
  end.at_surface = true;
  const KQuantity& bar = quantity("K3.BAR");
  EXPECT_FALSE(bar.is_given(front));
  EXPECT_FALSE(bar.is_given(front, inside));
  front.missing_bar_reason.clear();
  EXPECT_TRUE(bar.is_given(front));
  EXPECT_TRUE(bar.is_given(front, inside));
  EXPECT_FALSE(bar.is_given(front, end));
  EXPECT_TRUE(quantity("K3").is_given(front, end));
  for (const KQuantity& q : k_quantities) {
    if (q.given == KQuantityCondition::with_angles || q.given == KQuantityCondition::with_opening) {
      EXPECT_FALSE(q.is_given(front)) << q.name;
    }
  }
  front.has_angles = true;
  for (FrontPointResult& point : front.points) {
    EXPECT_FALSE(k_quantities.back().is_given(front)); // all points have the opening, or none does
    point.opening.emplace();
  }
  for (const KQuantity& q : k_quantities) {
    EXPECT_TRUE(q.is_given(front)) << q.name;
  }
}

// K between two materials is the number 0, and no answer; G is one.
TEST(KQuantity, OfKIsNotGivenBetweenTwoMaterials) {
  FrontResult front;
  front.two_materials = true;
  front.points.emplace_back();
  for (const char* word : {"K1", "K2", "T"}) {
    EXPECT_FALSE(quantity(word, 2).is_given(front)) << word;
    EXPECT_TRUE(quantity(word, 2).is_given_or_zero(front)) << word;
  }
  EXPECT_TRUE(quantity("G", 2).is_given(front));
  EXPECT_FALSE(quantity("K1.BAR", 2).is_given_or_zero(front));
}

} // namespace
} // namespace spricka::results::test_front_result
