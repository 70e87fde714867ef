// SPDX-License-Identifier: GPL-3.0-or-later
// Fronts that reach a surface between their ends go on as two.
#include "growing_block.hpp"
#include "growth/free_front_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace spricka::test_split_fronts {
namespace {

using namespace spricka::test;

// A plate of thickness 2 along y, 40 wide and high.
Block plate(double low) {
  return Block({-20, low, -20}, {20, low + 2, 20}, 4);
}

struct Grown {
  std::vector<std::vector<Vec3>> aims; ///< [station][tip]
  std::string end;
  std::string reason;
};

// To its end, each station begun anew from what the one before has kept.
Grown grow(Block& block, double bend) {
  Grown grown;
  growth::GrowthState state;
  base::Diagnostics none;
  for (int k = 0; k < 200 && grown.end.empty(); ++k) {
    growth::GrowthIntegrator march(block.model, paris,
                                   std::make_unique<growth::FreeFrontShape>(block.model), state);
    growth::GrowthIntegrator again(
        block.model, paris, std::make_unique<growth::FreeFrontShape>(block.model),
        growth::growth_state_from_arrays(growth::growth_state_to_arrays(state)));
    while (!march.growth_end()) {
      const auto cracks = march.propose_next_cracks(none);
      const auto same = again.propose_next_cracks(none);
      EXPECT_EQ(cracks.has_value(), same.has_value());
      if (!cracks) {
        if (march.growth_end()) {
          break;
        }
        march.shorten_step("no front");
        again.shorten_step("no front");
        continue;
      }
      EXPECT_EQ(same->aims, cracks->aims) << "station " << k;
      std::vector<TipStation> found(march.tips().size());
      for (std::size_t tip = 0; tip < found.size(); ++tip) {
        found[tip].K_max = 1.0 + bend * cracks->aims[tip].y();
        found[tip].rate = paris(found[tip].K_max, 0.0);
      }
      again.accept_or_reject_station(found);
      if (march.accept_or_reject_station(std::move(found))) {
        grown.aims.push_back(cracks->aims);
        break;
      }
    }
    state = march.growth_state();
    grown.end = march.growth_end() ? march.growth_end()->word() : "";
    grown.reason = march.growth_end() ? march.growth_end()->reason : "";
  }
  return grown;
}

// Tips on the left, and on the right, of x = 0.
std::array<std::vector<Vec3>, 2> sides(const std::vector<Vec3>& aims) {
  std::array<std::vector<Vec3>, 2> out;
  for (const Vec3& x : aims) {
    out.at(x.x() > 0.0 ? 1 : 0).push_back(x);
  }
  return out;
}

// Two fronts, each from face to face, one the image of the other.
void expect_two_fronts(const std::vector<Vec3>& aims, double low) {
  std::array<double, 2> far{};
  for (std::size_t side = 0; side < 2; ++side) {
    const std::vector<Vec3> own = sides(aims).at(side);
    ASSERT_GE(own.size(), 8U);
    const auto [bottom, top] =
        std::ranges::minmax_element(own, {}, [](const Vec3& x) { return x.y(); });
    EXPECT_NEAR(bottom->y(), low, 1e-3);
    EXPECT_NEAR(top->y(), low + 2.0, 1e-3);
    for (const Vec3& x : own) {
      far.at(side) = std::max(far.at(side), std::abs(x.x()));
    }
  }
  EXPECT_NEAR(far[0], far[1], 0.02 * far[0]);
}

// No place of the crack closes again on the way.
void expect_no_healing(const Grown& grown) {
  double reach = 0.0;
  for (const std::vector<Vec3>& aims : grown.aims) {
    double least = 1e300;
    for (const Vec3& x : aims) {
      least = std::min(least, x.norm());
    }
    EXPECT_GE(least, 0.98 * reach);
    reach = least;
  }
}

TEST(SplitFronts, SurfaceCrackBecomesAThroughCrackWithTwoFronts) {
  Block block = plate(0.0);
  block.ellipse(Vec3::Zero(), 1.0, 1.2);
  const Grown grown = grow(block, 0.0);
  EXPECT_EQ(grown.end, "EDGE");
  ASSERT_GE(grown.aims.size(), 6U);
  expect_two_fronts(grown.aims.back(), 0.0);
  expect_no_healing(grown);
  EXPECT_GT(std::abs(grown.aims.back().front().x()), 0.95 * 20.0);
}

// Nearly all of a wide front reaches the far face at once: few of its points stay.
TEST(SplitFronts, WideSurfaceCrackBecomesAThroughCrack) {
  for (const double c : {3.0, 6.0, 9.0}) {
    Block block = plate(0.0);
    block.ellipse(Vec3::Zero(), 1.0, c);
    block.model.growth->last_length = c + 4.0;
    const Grown grown = grow(block, 0.0);
    EXPECT_EQ(grown.end, "AMAX") << grown.reason;
    expect_two_fronts(grown.aims.back(), 0.0);
    expect_no_healing(grown);
  }
}

// It goes through where little of the thickness is left, not where little of its own width is: K
// falls towards the far face, as under bending.
TEST(SplitFronts, WideSurfaceCrackGoesThroughByItsDepth) {
  Block block = plate(0.0);
  block.ellipse(Vec3::Zero(), 1.5, 14.0);
  block.model.growth->last_length = 18.0;
  block.model.growth->tolerance = 0.02;
  const Grown grown = grow(block, -0.35);
  double depth = 0.0; // of the last front in one piece
  for (const std::vector<Vec3>& aims : grown.aims) {
    const bool whole =
        std::ranges::any_of(aims, [](const Vec3& x) { return std::abs(x.x()) < 0.5; });
    for (const Vec3& x : aims) {
      depth = whole ? std::max(depth, x.y()) : depth;
    }
  }
  EXPECT_EQ(grown.end, "AMAX") << grown.reason;
  EXPECT_GT(depth, 1.6);
}

// K that rises, or falls, towards the far face.
TEST(SplitFronts, LeanAsKHasIt) {
  for (const double bend : {0.05, -0.05}) {
    Block block = plate(0.0);
    block.ellipse(Vec3::Zero(), 1.0, 1.2);
    block.model.growth->last_length = 4.0;
    block.model.growth->tolerance = 0.02;
    const Grown grown = grow(block, bend);
    EXPECT_EQ(grown.end, "AMAX");
    expect_two_fronts(grown.aims.back(), 0.0);
    expect_no_healing(grown);
  }
}

TEST(SplitFronts, CrackInThePlateGoesThroughBothFaces) {
  Block block = plate(-1.0);
  block.ellipse(Vec3::Zero(), 0.5, 0.6);
  const Grown grown = grow(block, 0.0);
  EXPECT_EQ(grown.end, "EDGE");
  expect_two_fronts(grown.aims.back(), -1.0);
}

// Waves that are too short for what rates are smoothed by, as a passage may leave them: K knows of
// them (Rice 1985), and they die away.
TEST(SplitFronts, WavesDieAway) {
  constexpr double height = 0.03;
  const double number = 3.0 * std::numbers::pi; // radians for a length: three waves in the plate
  Block block = plate(-1.0);
  block.ellipse(Vec3::Zero(), 1.0, 1.0);
  model::CrackDefinition& crack = block.model.cracks.front();
  crack.kind = model::CrackDefinitionKind::drawn;
  for (const double side : {1.0, -1.0}) {
    for (int i = -22; i <= 22; ++i) {
      const double y = side * 0.05 * i;
      crack.points.emplace_back(side * (5.0 + height * std::cos(number * y)), y, 0.0);
    }
    crack.points.emplace_back(0.0, side * 1.1, 0.0);
  }
  crack.points.pop_back();
  block.model.growth->last_length = 7.0;
  block.model.growth->tolerance = 0.02;
  growth::GrowthIntegrator march(block.model, paris,
                                 std::make_unique<growth::FreeFrontShape>(block.model), {});
  double swing = 0.0;
  double first = 0.0;
  run(march, [&](const growth::CrackGeometry& cracks, const Vec3& x) {
    double sum = 0.0;
    double low = 1e300;
    double high = 0.0;
    for (const Vec3& aim : cracks.aims) {
      sum += std::abs(aim.x()) / static_cast<double>(cracks.aims.size());
      low = std::min(low, std::abs(aim.x()));
      high = std::max(high, std::abs(aim.x()));
    }
    swing = high - low;
    first = first > 0.0 ? first : swing;
    return 1.0 - 0.5 * number * (std::abs(x.x()) - sum);
  });
  EXPECT_GT(first, 1.5 * height);
  EXPECT_LT(swing, 0.25 * first);
}

// Two fronts that the deck draws as one line, through the body and out of it between them.
TEST(SplitFronts, ThroughCrackOfTheDeckHasTwoFronts) {
  Block block = plate(0.0);
  block.ellipse(Vec3::Zero(), 5.0, 4.0);
  const Grown grown = grow(block, 0.0);
  EXPECT_EQ(grown.end, "EDGE");
  ASSERT_FALSE(grown.aims.empty());
  EXPECT_EQ(grown.aims.front().size(), 34U);
  expect_two_fronts(grown.aims.back(), 0.0);
  // What a front that turns leaves behind is kept for one: none of two begins.
  block.model.growth->direction = model::GrowthDirection::hoop;
  EXPECT_TRUE(growth::FreeFrontShape(block.model).tips().empty());
}

} // namespace
} // namespace spricka::test_split_fronts
