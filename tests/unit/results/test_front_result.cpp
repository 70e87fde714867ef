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

// The K that counts, and raw K behind it.
TEST(RawK, StaysBehindKWithoutItsEstimatedErrorAndComesBackToTheBit) {
  FrontResult front;
  for (const bool at_surface : {true, false, false, false}) {
    FrontPointResult& place = front.points.emplace_back();
    place.at_surface = at_surface;
    place.K1 = 0.1;
    place.K2 = 0.3;
    place.smooth = {0.11, 0.31, 0.0};
    for (KErrorBar& bar : place.bar) {
      bar.best = 0.7;
      bar.of_best = true;
    }
  }
  front.points[2].bar[0].best = -0.2;         // faces that do not overlap have no K1 below 0
  front.points[3].bar[0].best = std::nan(""); // no number, no correction
  front.points[3].bar[1].of_best = front.points[3].bar[2].of_best = false;
  const FrontResult before = front;
  take_out_estimated_errors(front);
  EXPECT_TRUE(front.is_corrected());
  EXPECT_EQ(front.points[0].K1, 0.1); // a number of the mesh
  EXPECT_EQ(front.points[0].smooth[0], 0.7);
  EXPECT_EQ(front.points[1].K2, 0.7);
  EXPECT_EQ(front.points[1].smooth[1], 0.7);
  EXPECT_EQ(front.points[2].K1, 0.0);
  EXPECT_FALSE(front.points[3].raw.has_value());
  const KQuantity& raw = quantity("K2.RAW");
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    FrontPointResult& place = front.points[i];
    EXPECT_EQ(raw.extract_value(front, place), 0.3);
    EXPECT_EQ(place.raw_K(), before.points[i].K());
    EXPECT_EQ(place.raw_smooth_K(), before.points[i].smooth);
    put_back_raw_K(place);
    EXPECT_EQ(place.K(), before.points[i].K());
    EXPECT_EQ(place.smooth, before.points[i].smooth);
    EXPECT_FALSE(place.raw || place.raw_smooth);
  }
}

} // namespace
} // namespace spricka::results::test_front_result
