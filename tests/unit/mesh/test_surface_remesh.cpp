// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of solids meshed anew where cracks come out: areas, rims, orientation, true places.
#include "surface_checks.hpp"
#include "surface_hosts.hpp"

#include <gtest/gtest.h>

namespace spricka::mesh::test_surface_remesh {
namespace {

using base::ElementType;
using base::Vec3;
using test::Areas;
using test::areas_of;
using test::Ellipse;
using test::expect_sound;
using test::least_angle;
using test::SurfaceCut;

TEST(SurfaceRemesh, SemiEllipseInABoxKeepsThePlaneArea) {
  for (const ElementType type :
       {ElementType::tet4, ElementType::tet10, ElementType::hexe8, ElementType::hexec20,
        ElementType::hexec27, ElementType::pentac15}) {
    for (const int n : {3, 8}) {
      const SurfaceGeometry surface(test::box_host(type, {2.0, 2.0, 2.0}, n));
      const Ellipse crack{{1.07, 0.93, 2.0}, 0.4 * Vec3(0.8, 0.6, 0.0), 0.25 * Vec3::UnitZ()};
      const SurfaceCut cut = test::cut_surface(surface, crack, 0.05);
      expect_sound(surface, cut);
      Areas areas = areas_of(surface, cut);
      ASSERT_GE(areas.host.size(), 1U);
      for (const auto& [piece, area] : areas.host) {
        EXPECT_NEAR(areas.made[piece] + areas.caps[piece], area, 1e-12 * area);
      }
      EXPECT_GT(least_angle(cut.made), 15.0);
    }
  }
}

TEST(SurfaceRemesh, CornerCrackRunsOverTheEdgeOfABox) {
  for (const ElementType type : {ElementType::tet10, ElementType::hexec20}) {
    for (const int n : {2, 6}) {
      const SurfaceGeometry surface(test::box_host(type, {2.0, 2.0, 2.0}, n));
      const Ellipse crack{{2.0, 0.93, 2.0}, 0.4 * Vec3(0.9, 0.1, 0.0), 0.25 * Vec3::UnitZ()};
      const SurfaceCut cut = test::cut_surface(surface, crack, 0.05);
      expect_sound(surface, cut);
      Areas areas = areas_of(surface, cut);
      EXPECT_GE(areas.host.size(), 2U);
      for (const auto& [piece, area] : areas.host) {
        EXPECT_NEAR(areas.made[piece] + areas.caps[piece], area, 1e-12 * area);
      }
      EXPECT_GT(least_angle(cut.made), 12.0);
    }
  }
}

TEST(SurfaceRemesh, CrackPlaneThroughNodesAndAlongEdgesOfTheHost) {
  for (const ElementType type : {ElementType::tet10, ElementType::hexec20, ElementType::pentac15}) {
    const SurfaceGeometry box(test::box_host(type, {2.0, 2.0, 2.0}, 4));
    // On a face, at an edge, with its centre in nodes.
    for (const double x : {1.0, 2.0}) {
      const Ellipse crack{{x, 1.0, 2.0}, 0.5 * Vec3::UnitX(), 0.4 * Vec3::UnitZ()};
      const SurfaceCut cut = test::cut_surface(box, crack, 0.05);
      expect_sound(box, cut);
      EXPECT_GT(least_angle(cut.made), 12.0);
    }
    const SurfaceGeometry plate(test::hole_plate(type, {}));
    const Ellipse corner{{1.0, 0.0, 1.0}, 0.5 * Vec3::UnitX(), 0.4 * Vec3::UnitZ()};
    expect_sound(plate, test::cut_surface(plate, corner, 0.05));
  }
}

TEST(SurfaceRemesh, HoleCornerCrackOnCoarseAndFineBores) {
  for (const ElementType type :
       {ElementType::tet10, ElementType::hexec20, ElementType::hexe8, ElementType::pentac15}) {
    for (const int around : {8, 16, 32}) {
      test::HolePlate plate;
      plate.around = around;
      if (type == ElementType::hexe8 && around == 8) {
        continue; // an octagon: its mouth runs over other edges
      }
      const SurfaceGeometry surface(test::hole_plate(type, plate));
      const Vec3 out(std::cos(0.3), std::sin(0.3), 0.0);
      const Ellipse crack{out + Vec3::UnitZ(), 0.5 * out, 0.4 * Vec3::UnitZ()};
      const SurfaceCut cut = test::cut_surface(surface, crack, 0.05);
      expect_sound(surface, cut);
      Areas areas = areas_of(surface, cut);
      for (const auto& [piece, area] : areas.host) {
        // of the plate's face the rim of the bore belongs to its area
        EXPECT_NEAR(areas.made[piece] + areas.caps[piece], area, 2e-3 * area)
            << base::element_info(type).name << ' ' << around;
      }
      EXPECT_GT(least_angle(cut.made), 8.0) << base::element_info(type).name << ' ' << around;
    }
  }
}

TEST(SurfaceRemesh, CavityThatGoesAllRoundABore) {
  for (const ElementType type : {ElementType::tet10, ElementType::hexec20}) {
    test::HolePlate plate;
    plate.radius = 0.3;
    const SurfaceGeometry surface(test::hole_plate(type, plate));
    // Two fronts, one on each side of the hole.
    const Ellipse crack{{0.05, 0.0, 1.0}, 0.8 * Vec3::UnitX(), 0.6 * Vec3::UnitZ()};
    const SurfaceCut cut = test::cut_surface(surface, crack, 0.06);
    expect_sound(surface, cut);
    EXPECT_EQ(cut.made.caps.size(), 4U);
    EXPECT_GT(least_angle(cut.made), 8.0);
  }
}

TEST(SurfaceRemesh, CrackBelowTheSurfaceLeavesItWhole) {
  const SurfaceGeometry surface(test::box_host(ElementType::tet10, {2.0, 2.0, 2.0}, 3));
  const Ellipse crack{{1.07, 0.93, 1.6}, 0.3 * Vec3::UnitX(), 0.3 * Vec3::UnitZ()};
  const SurfaceCut cut = test::cut_surface(surface, crack, 0.05);
  expect_sound(surface, cut);
  Areas areas = areas_of(surface, cut);
  for (const auto& [piece, area] : areas.host) {
    EXPECT_NEAR(areas.made[piece], area, 1e-12 * area);
  }
}

TEST(SurfaceRemesh, UnitAndPlaceDoNotChangeTheMesh) {
  for (const ElementType type : {ElementType::tet10, ElementType::hexec20}) {
    const auto cut_at = [&](double unit, const Vec3& off) {
      test::HolePlate plate;
      model::Mesh mesh = test::hole_plate(type, plate);
      for (Vec3& x : mesh.x) {
        x = unit * x + off;
      }
      const SurfaceGeometry surface(mesh);
      const Vec3 out(std::cos(0.3), std::sin(0.3), 0.0);
      const Ellipse crack{unit * (out + Vec3::UnitZ()) + off, unit * 0.5 * out,
                          unit * 0.4 * Vec3::UnitZ()};
      return test::cut_surface(surface, crack, unit * 0.05);
    };
    const SurfaceCut one = cut_at(1.0, Vec3::Zero());
    const SurfaceCut two = cut_at(25.4, Vec3(3.0, -7.0, 11.0));
    ASSERT_EQ(one.made.trouble.why, "");
    ASSERT_EQ(one.made.triangles.size(), two.made.triangles.size());
    for (std::size_t t = 0; t < one.made.triangles.size(); ++t) {
      EXPECT_EQ(one.made.triangles[t].points, two.made.triangles[t].points);
      EXPECT_EQ(one.made.triangles[t].edges, two.made.triangles[t].edges);
    }
  }
}

TEST(SurfaceRemesh, TroubleIsSaidWithItsPlace) {
  const SurfaceGeometry surface(test::box_host(ElementType::tet10, {2.0, 2.0, 2.0}, 3));
  // The tube's end reaches over the edge of the body.
  const SurfaceCut near = test::cut_surface(
      surface, {{1.75, 0.93, 2.0}, 0.23 * Vec3::UnitX(), 0.2 * Vec3::UnitZ()}, 0.05);
  EXPECT_NE(near.made.trouble.why, "");
  EXPECT_TRUE(near.made.triangles.empty());
  EXPECT_LT((near.made.trouble.at - Vec3(1.98, 0.93, 2.0)).norm(), 0.1);
}

} // namespace
} // namespace spricka::mesh::test_surface_remesh
