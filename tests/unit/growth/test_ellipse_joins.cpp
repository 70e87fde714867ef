// SPDX-License-Identifier: GPL-3.0-or-later
// Ellipses that meet and go on as one: K is the same all round here, so that all ends grow alike
// and where they end is known; on a surface nearly so, as K counts there ten degrees inside.
#include "growing_block.hpp"
#include "growth/elliptical_front.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

namespace spricka::test_ellipse_joins {
namespace {

using namespace spricka::test;

constexpr double last_length = 2.5; // of all ends
constexpr double grown = 1.5;       // from 1
constexpr double nearly = 0.03;

struct Grown {
  growth::GrowthState state;
  growth::CrackGeometry last;
  std::string end;
  std::size_t met = 0; ///< times

  [[nodiscard]] const model::PlanarCrack& plane() const {
    return last.solids[growth::is_merged(last.solids[0]) ? 1 : 0].plane;
  }
};

Grown grow(Block& block) {
  block.model.growth->last_length = last_length;
  growth::GrowthIntegrator march(block.model, paris,
                                 std::make_unique<growth::EllipticalFront>(block.model), {});
  Grown out;
  run(march, [&](const growth::CrackGeometry& cracks, const Vec3&) {
    out.last = cracks;
    return 1.0;
  });
  for (const growth::SolvedStation& station : march.growth_state().stations) {
    out.met += station.met > 0 ? 1 : 0;
  }
  out.end = march.growth_end()->word();
  out.state = march.growth_state();
  return out;
}

void expect_one(const Grown& both) {
  EXPECT_EQ(both.end, "AMAX");
  EXPECT_EQ(both.met, 1U);
  EXPECT_NE(growth::is_merged(both.last.solids[0]), growth::is_merged(both.last.solids[1]));
}

// What is kept makes the same cracks and places again.
void expect_kept(const Block& block, const Grown& before) {
  growth::EllipticalFront ways(block.model);
  ways.resume_from(before.state);
  const growth::CrackGeometry again = ways.current_cracks();
  ASSERT_EQ(again.aims.size(), before.last.aims.size());
  for (std::size_t i = 0; i < again.aims.size(); ++i) {
    EXPECT_EQ(again.aims[i], before.last.aims[i]);
    EXPECT_EQ(again.fronts[i], before.last.fronts[i]);
    EXPECT_EQ(ways.initial_tip_extent(i),
              growth::EllipticalFront(block.model).initial_tip_extent(i));
  }
}

TEST(EllipsesThatMeet, ReachAsFarAsBoth) {
  for (const double turned : {0.0, 0.5 * std::numbers::pi, std::numbers::pi}) {
    for (const double normal : {1.0, -1.0}) {
      SCOPED_TRACE(turned);
      Block block({-20, -20, -20}, {20, 20, 20}, 4);
      block.ellipse({-1.3, 0, 0}, 1.0, 1.0, "C1");
      block.ellipse({1.3, 0, 0}, 1.0, 1.0, "C2");
      // which axis is called A of a circle, and where it looks, is all the same
      block.model.cracks[1].plane.along = Vec3(std::cos(turned), std::sin(turned), 0.0);
      block.model.cracks[1].plane.normal *= normal;
      const Grown both = grow(block);
      expect_one(both);
      ASSERT_EQ(both.last.aims.size(), 8U);
      EXPECT_NEAR(both.plane().place.norm(), 0.0, 1e-9);
      const bool swapped = std::abs(both.plane().along.y()) > 0.5;
      EXPECT_NEAR(swapped ? both.plane().a : both.plane().c, 1.3 + last_length, 1e-6);
      EXPECT_NEAR(swapped ? both.plane().c : both.plane().a, last_length, 1e-6);
      expect_kept(block, both);
    }
  }
}

TEST(EllipsesThatMeet, OnASurface) {
  Block block({-20, 0, -20}, {20, 20, 20}, 4);
  block.ellipse({-1.3, 0, 0}, 1.0, 1.0, "C1");
  block.ellipse({1.3, 0, 0}, 1.0, 1.0, "C2");
  const Grown both = grow(block);
  expect_one(both);
  ASSERT_EQ(both.last.aims.size(), 6U);
  EXPECT_NEAR(both.plane().place.norm(), 0.0, 1e-9);
  EXPECT_NEAR(both.plane().c, 1.3 + last_length, nearly);
  EXPECT_NEAR(both.plane().a, last_length, nearly);
  expect_kept(block, both);
}

// A surface crack that a corner crack meets becomes a part of it: the centre stays in the corner.
TEST(EllipsesThatMeet, InACorner) {
  Block block({0, 0, -20}, {20, 20, 20}, 4);
  block.ellipse({0, 0, 0}, 1.0, 1.0, "C1");
  block.ellipse({3, 0, 0}, 1.0, 1.0, "C2");
  const Grown both = grow(block);
  expect_one(both);
  ASSERT_EQ(both.last.aims.size(), 5U);
  EXPECT_NEAR(both.plane().place.norm(), 0.0, 1e-9);
  EXPECT_NEAR(both.plane().c, 3.0 + 1.0 + grown, nearly);
  EXPECT_NEAR(both.plane().a, last_length, nearly);
  expect_kept(block, both);
}

// A crack inside the body that a surface crack meets opens to the surface.
TEST(EllipsesThatMeet, BelowASurface) {
  Block block({-20, 0, -20}, {20, 20, 20}, 4);
  block.ellipse({0, 3, 0}, 1.0, 1.0, "C1");
  block.ellipse({0, 0, 0}, 1.0, 1.0, "C2");
  const Grown both = grow(block);
  expect_one(both);
  EXPECT_NEAR(both.plane().place.norm(), 0.0, 1e-9);
  EXPECT_NEAR(both.plane().a, 3.0 + 1.0 + grown, nearly);
  EXPECT_NEAR(both.plane().c, last_length, nearly);
  expect_kept(block, both);
}

TEST(EllipsesThatMeet, EndWhereThereIsNoSuchEllipse) {
  Block planes({-20, -20, -20}, {20, 20, 20}, 4);
  planes.ellipse({-1.3, 0, 0}, 1.0, 1.0, "C1");
  planes.ellipse({1.3, 0, 0.01}, 1.0, 1.0, "C2");
  EXPECT_EQ(grow(planes).end, "LINK-UP");
  Block askew({-20, -20, -20}, {20, 20, 20}, 4);
  askew.ellipse({-1.3, 0, 0}, 1.0, 1.0, "C1");
  askew.ellipse({1.3, 0, 0}, 1.0, 1.0, "C2");
  askew.model.cracks[1].plane.along = Vec3(0.8, 0.6, 0.0);
  EXPECT_EQ(grow(askew).end, "LINK-UP");
  Block corners({0, 0, -20}, {4, 20, 20}, 4);
  corners.ellipse({0, 0, 0}, 1.0, 1.0, "C1");
  corners.ellipse({4, 0, 0}, 1.0, 1.0, "C2");
  EXPECT_EQ(grow(corners).end, "LINK-UP");
}

} // namespace
} // namespace spricka::test_ellipse_joins
