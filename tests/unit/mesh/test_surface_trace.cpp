// SPDX-License-Identifier: GPL-3.0-or-later
// Planes and fronts that meet the surface of a solid mesh, against closed forms.
#include "mesh/surface/surface_hits.hpp"
#include "mesh/surface/surface_trace.hpp"
#include "surface_hosts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::mesh::test_surface_trace {
namespace {

using base::ElementType;
using base::Vec3;

constexpr double pi = std::numbers::pi;

/// b = u x v; the front runs from u against v, so that m = b x t points out of the crack.
FrontCurve ellipse(const Vec3& centre, const Vec3& u, const Vec3& v) {
  std::vector<Vec3> points;
  constexpr int count = 96;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * pi * i / count;
    points.push_back(centre + std::cos(angle) * u - std::sin(angle) * v);
  }
  return {points, std::vector<Vec3>(count, u.cross(v).normalized()), true};
}

void expect_on_plane_and_faces(const SurfaceGeometry& surface, const CrackReferencePlane& plane,
                               const SurfaceTrace& trace) {
  for (int i = 0; i <= 50; ++i) {
    const SurfacePlace place = trace.at(trace.length() * i / 50.0);
    EXPECT_LT(std::abs(plane.height_over_crack(place.x)), 1e-12);
    EXPECT_LT((surface.place_at_coordinates(place.face, place.r).x - place.x).norm(), 1e-14);
  }
}

TEST(SurfaceTrace, StraightOverABoxAndItsEdge) {
  for (const ElementType type : {ElementType::tet4, ElementType::tet10, ElementType::hexec20}) {
    const SurfaceGeometry surface(test::box_host(type, {2.0, 2.0, 2.0}, 4));
    // Through nodes and along edges of the mesh, and across them.
    for (const double y : {1.0, 0.5, 0.813}) {
      const CrackReferencePlane plane{{1.0, y, 1.0}, Vec3::UnitY(), 0.7};
      const auto from = surface.nearest_place({0.4, y, 2.0});
      const auto to = surface.nearest_place({2.0, y, 1.3});
      const TraceResult traced = trace_crack_plane(surface, plane, from, to, Vec3::UnitX());
      ASSERT_FALSE(traced.trouble) << traced.trouble.why;
      const SurfaceTrace& line = traced.trace.front();
      EXPECT_NEAR(line.length(), 1.6 + 0.7, 1e-12);
      expect_on_plane_and_faces(surface, plane, line);
      int crossings = 0;
      for (const TracePoint& point : line.points()) {
        if (point.edge != nowhere) {
          ++crossings;
          EXPECT_LT((point.place.x - Vec3(2.0, y, 2.0)).norm(), 1e-12);
          EXPECT_LT((surface.place_on_edge(point.edge, point.t).x - point.place.x).norm(), 1e-12);
        }
      }
      EXPECT_EQ(crossings, 1);
      // The other way round: over five more edges' lengths and three more edges.
      const TraceResult round = trace_crack_plane(surface, plane, from, to, -Vec3::UnitX());
      ASSERT_FALSE(round.trouble) << round.trouble.why;
      EXPECT_NEAR(round.trace.front().length(), 8.0 - 2.3, 1e-12);
    }
  }
}

// Both ends on nodes, the plane through nodes: what a crack in a regular mesh asks for.
TEST(SurfaceTrace, FromNodeToNode) {
  for (const ElementType type : {ElementType::tet4, ElementType::tet10, ElementType::hexe8,
                                 ElementType::hexec20, ElementType::hexec27}) {
    const SurfaceGeometry surface(test::box_host(type, {2.0, 2.0, 2.0}, 4));
    for (const double noise : {0.0, 1e-14, -1e-14}) { // of ends found by iteration
      for (const double y : {0.5, 1.0}) {
        for (const double a : {0.5, 1.0}) {
          const CrackReferencePlane plane{{2.0, y, 2.0}, Vec3::UnitY(), 0.3};
          const auto from = surface.nearest_place({2.0 - a + noise, y, 2.0});
          const auto to = surface.nearest_place({2.0, y, 2.0 - a + noise});
          for (const auto& [way, length] :
               {std::pair(Vec3(Vec3::UnitX()), 2.0 * a), {-Vec3::UnitX(), 8.0 - 2.0 * a}}) {
            const TraceResult traced = trace_crack_plane(surface, plane, from, to, way);
            ASSERT_FALSE(traced.trouble) << traced.trouble.why << base::element_info(type).name;
            EXPECT_NEAR(traced.trace.front().length(), length, 1e-12);
            expect_on_plane_and_faces(surface, plane, traced.trace.front());
            EXPECT_EQ(std::ranges::count_if(traced.trace.front().points(),
                                            [](const TracePoint& p) { return p.edge != nowhere; }),
                      length > 4.0 ? 3 : 1);
          }
        }
      }
    }
  }
}

TEST(SurfaceTrace, CircleOnABore) {
  const SurfaceGeometry surface(test::hole_plate(ElementType::hexec20, {}));
  const CrackReferencePlane plane{{0.0, 0.0, 0.3}, Vec3::UnitZ(), 1.0};
  const auto at = [&](double angle) {
    return surface.nearest_place({std::cos(angle), std::sin(angle), 0.3});
  };
  const TraceResult traced = trace_crack_plane(surface, plane, at(0.2), at(2.1), Vec3::UnitY());
  ASSERT_FALSE(traced.trouble) << traced.trouble.why;
  EXPECT_NEAR(traced.trace.front().length(), 1.9, 2e-3); // chords of four a face
  expect_on_plane_and_faces(surface, plane, traced.trace.front());
}

TEST(SurfaceTrace, ObliquePlaneOnABoreIsAnEllipse) {
  test::HolePlate fine;
  fine.around = 32;
  for (const ElementType type : {ElementType::tet10, ElementType::hexec20}) {
    const SurfaceGeometry surface(test::hole_plate(type, fine));
    const Vec3 b = Vec3(0.3, 0.0, 1.0).normalized();
    const CrackReferencePlane plane{{0.0, 0.0, 0.5}, b, 1.0};
    const auto at = [&](double angle) -> Vec3 {
      return {std::cos(angle), std::sin(angle), 0.5 - 0.3 * std::cos(angle)};
    };
    const TraceResult traced = trace_crack_plane(surface, plane, surface.nearest_place(at(0.3)),
                                                 surface.nearest_place(at(2.8)), Vec3::UnitY());
    ASSERT_FALSE(traced.trouble) << traced.trouble.why;
    double length = 0.0;
    for (int i = 0; i < 1000; ++i) {
      length += (at(0.3 + 2.5 * (i + 1) / 1000.0) - at(0.3 + 2.5 * i / 1000.0)).norm();
    }
    EXPECT_NEAR(traced.trace.front().length(), length, 1e-3);
    expect_on_plane_and_faces(surface, plane, traced.trace.front());
  }
}

TEST(SurfaceTrace, DividedLinesHaveTheWantedSizesAndCornersAtEdges) {
  const SurfaceGeometry surface(test::box_host(ElementType::tet10, {2.0, 2.0, 2.0}, 2));
  const CrackReferencePlane plane{{1.0, 0.813, 1.0}, Vec3::UnitY(), 0.7};
  const TraceResult traced =
      trace_crack_plane(surface, plane, surface.nearest_place({0.4, 0.813, 2.0}),
                        surface.nearest_place({2.0, 0.813, 1.3}), Vec3::UnitX());
  ASSERT_FALSE(traced.trouble);
  const DividedTrace line =
      divide_trace_by_size(traced.trace.front(), [](const Vec3&) { return 0.1; });
  ASSERT_EQ(line.corners.size(), 16U + 7U + 1U);
  ASSERT_EQ(line.mids.size() + 1, line.corners.size());
  EXPECT_NE(line.corners[16].edge, nowhere);
  for (std::size_t i = 0; i < line.mids.size(); ++i) {
    const Vec3 a = line.corners[i].place.x;
    const Vec3 b = line.corners[i + 1].place.x;
    EXPECT_NEAR((b - a).norm(), 0.1, 1e-9);
    EXPECT_LT((0.5 * (a + b) - line.mids[i].x).norm(), 1e-9);
  }
}

TEST(InteriorFrontArcs, SemiEllipseAtAFace) {
  const double c = 0.5;
  const double a = 0.3;
  for (const ElementType type : {ElementType::tet10, ElementType::hexec20, ElementType::hexe8}) {
    const SurfaceGeometry surface(test::box_host(type, {2.0, 2.0, 2.0}, 3));
    // Its centre 0.1 below the face.
    const FrontCurve front = ellipse({1.1, 0.93, 1.9}, c * Vec3::UnitX(), a * Vec3::UnitZ());
    const InteriorFrontArcs found = find_interior_front_arcs(surface, front);
    ASSERT_FALSE(found.trouble) << found.trouble.why;
    ASSERT_EQ(found.arcs.size(), 1U);
    const double x = c * std::sqrt(1.0 - 0.01 / (a * a));
    const InteriorFrontArc& arc = found.arcs.front();
    for (const std::size_t k : {0U, 1U}) {
      const Vec3 end(1.1 + (k == 0 ? x : -x), 0.93, 2.0);
      EXPECT_LT((arc.place[k].x - end).norm(), 1e-5);
      EXPECT_LT((arc.place[k].normal - Vec3::UnitZ()).norm(), 1e-12);
      EXPECT_LT((front.at(arc.s[k]).x - arc.place[k].x).norm(), 1e-12);
    }
    EXPECT_LT(front.at(0.5 * (arc.s[0] + arc.s[1])).x.z(), 2.0);
  }
}

TEST(InteriorFrontArcs, QuarterEllipseAtAnEdgeAndWholeInside) {
  const SurfaceGeometry surface(test::box_host(ElementType::tet10, {2.0, 2.0, 2.0}, 3));
  const FrontCurve corner = ellipse({2.0, 0.93, 2.0}, 0.5 * Vec3::UnitX(), 0.3 * Vec3::UnitZ());
  const InteriorFrontArcs found = find_interior_front_arcs(surface, corner);
  ASSERT_EQ(found.arcs.size(), 1U) << found.trouble.why;
  const InteriorFrontArc& arc = found.arcs.front();
  EXPECT_LT((arc.place[0].x - Vec3(2.0, 0.93, 1.7)).norm(), 1e-5);
  EXPECT_LT((arc.place[1].x - Vec3(1.5, 0.93, 2.0)).norm(), 1e-5);
  EXPECT_LT((arc.place[0].normal - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_LT((arc.place[1].normal - Vec3::UnitZ()).norm(), 1e-12);

  const InteriorFrontArcs whole = find_interior_front_arcs(
      surface, ellipse({1.0, 0.93, 1.0}, 0.5 * Vec3::UnitX(), 0.3 * Vec3::UnitZ()));
  ASSERT_EQ(whole.arcs.size(), 1U);
  EXPECT_TRUE(whole.arcs.front().whole);
  EXPECT_TRUE(find_interior_front_arcs(
                  surface, ellipse({5.0, 0.93, 1.0}, 0.5 * Vec3::UnitX(), 0.3 * Vec3::UnitZ()))
                  .trouble);
}

TEST(InteriorFrontArcs, EllipseAroundABoreHasItsPartsInThePlate) {
  for (const ElementType type : {ElementType::tet10, ElementType::hexec20}) {
    const SurfaceGeometry surface(test::hole_plate(type, {}));
    // A circle of 0.8 about the middle of the bore's edge: from the bore to the plate's face.
    const FrontCurve front = ellipse({1.0, 0.0, 1.0}, 0.8 * Vec3::UnitX(), 0.8 * Vec3::UnitZ());
    const InteriorFrontArcs found = find_interior_front_arcs(surface, front);
    ASSERT_EQ(found.arcs.size(), 1U) << found.trouble.why;
    EXPECT_LT((found.arcs[0].place[0].x - Vec3(1.8, 0.0, 1.0)).norm(), 1e-5);
    EXPECT_LT((found.arcs[0].place[1].x - Vec3(1.0, 0.0, 0.2)).norm(), 1e-5);
    EXPECT_LT((found.arcs[0].place[1].normal + Vec3::UnitX()).norm(), 1e-2);
    // One about the axis with both sides of the hole: two fronts through the thickness.
    const InteriorFrontArcs both = find_interior_front_arcs(
        surface, ellipse({0.0, 0.0, 0.5}, 1.6 * Vec3::UnitX(), 4.0 * Vec3::UnitZ()));
    EXPECT_EQ(both.arcs.size(), 2U) << both.trouble.why;
  }
}

TEST(InteriorFrontArcs, CrackMuchSmallerThanTheFacetsOfABore) {
  // Facets of curved faces of 22.5 degrees lie 6e-4 off them.
  const SurfaceGeometry surface(test::hole_plate(ElementType::hexec20, {}));
  for (const double size : {1e-2, 1e-3, 1e-4, 1e-5}) {
    for (double angle = 0.01; angle < 0.4; angle += 0.03) {
      const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
      const Vec3 centre = surface.nearest_place(out + 0.37 * Vec3::UnitZ()).x;
      const InteriorFrontArcs found = find_interior_front_arcs(
          surface, ellipse(centre, size * out, 0.7 * size * Vec3::UnitZ()));
      ASSERT_EQ(found.arcs.size(), 1U) << found.trouble.why << " at " << angle << ' ' << size;
      EXPECT_NEAR((found.arcs[0].place[1].x - found.arcs[0].place[0].x).norm(), 1.4 * size,
                  1e-3 * size);
    }
  }
}

TEST(InteriorFrontArcs, OpenFrontIsProlongedToTheSurface) {
  const SurfaceGeometry surface(test::hole_plate(ElementType::hexe8, {}));
  // A straight through front that ends 0.01 below both faces.
  const FrontCurve front({{1.5, 0.0, 0.01}, {1.5, 0.0, 0.99}}, {Vec3::UnitY(), Vec3::UnitY()},
                         false);
  const InteriorFrontArcs found = find_interior_front_arcs(surface, front);
  ASSERT_EQ(found.arcs.size(), 1U) << found.trouble.why;
  EXPECT_NEAR(found.arcs[0].s[0], -0.01, 1e-12);
  EXPECT_NEAR(found.arcs[0].s[1], 0.99, 1e-12);
  const FrontCurve deep({{1.5, 0.0, 0.3}, {1.5, 0.0, 0.9}}, {Vec3::UnitY(), Vec3::UnitY()}, false);
  EXPECT_TRUE(find_interior_front_arcs(surface, deep).trouble);
}

} // namespace
} // namespace spricka::mesh::test_surface_trace
