// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/new_surface.hpp"
#include "mesh/surface/surface_region.hpp"
#include "shape/quadrature.hpp"
#include "surface_cracks.hpp"

#include <map>
#include <set>

#include <gtest/gtest.h>

/// What every surface meshed anew must keep.
namespace spricka::test {

using namespace spricka::mesh;

/// [piece] area of the removed faces, of the new triangles, of the caps (straight edges).
struct Areas {
  std::map<std::size_t, double> host, made, caps;
};

inline Areas areas_of(const SurfaceGeometry& surface, const SurfaceCut& cut) {
  Areas areas;
  for (const std::size_t f : cut.region.faces) {
    areas.host[surface.smooth_piece_index(f)] += surface.face(f).area(9);
  }
  for (const RemeshedTriangle& t : cut.made.triangles) {
    for (const auto& [r, weight] : shape::triangle_rule(6)) {
      areas.made[surface.smooth_piece_index(t.face)] +=
          weight * triangle_normal(cut.made, t, r).norm();
    }
  }
  for (const std::vector<int>& cap : cut.made.caps) {
    Vec3 sum = Vec3::Zero();
    const auto x = [&](std::size_t i) -> const Vec3& {
      return cut.made.points[static_cast<std::size_t>(cap[i % cap.size()])].place.x;
    };
    for (std::size_t i = 1; i + 1 < cap.size(); ++i) {
      sum += 0.5 * (x(i) - x(0)).cross(x(i + 1) - x(0));
    }
    areas.caps[surface.smooth_piece_index(
        cut.made.points[static_cast<std::size_t>(cap[0])].place.face)] += sum.norm();
  }
  return areas;
}

inline double least_angle(const RemeshedSurface& made) {
  double least = 10.0;
  for (const RemeshedTriangle& t : made.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto x = [&](std::size_t i) -> const Vec3& {
        return made.points[static_cast<std::size_t>(t.points[i % 3])].place.x;
      };
      const Vec3 a = (x(k + 1) - x(k)).normalized();
      const Vec3 b = (x(k + 2) - x(k)).normalized();
      least = std::min(least, std::acos(std::clamp(a.dot(b), -1.0, 1.0)));
    }
  }
  return least * 180.0 / std::numbers::pi;
}

/// All that any new surface must keep.
inline void expect_sound(const SurfaceGeometry& surface, const SurfaceCut& cut) {
  ASSERT_EQ(cut.trouble, "");
  ASSERT_EQ(cut.made.trouble.why, "") << cut.made.trouble.at.transpose();
  const RemeshedSurface& made = cut.made;
  // The rim is that of the host, with its middles.
  std::map<std::set<base::NodeId>, base::NodeId> rim;
  for (const RemeshedEdge& e : made.edges) {
    const auto& a = made.points[static_cast<std::size_t>(e.points[0])];
    const auto& b = made.points[static_cast<std::size_t>(e.points[1])];
    if (e.kind == RemeshedEdgeKind::rim) {
      EXPECT_TRUE(rim.insert({{a.host, b.host}, e.host_mid}).second);
    }
    EXPECT_LT((surface.nearest_place(e.mid.x).x - e.mid.x).norm(), 1e-9);
    EXPECT_LT((surface.place_at_coordinates(e.mid.face, e.mid.r).x - e.mid.x).norm(), 1e-12);
    if (e.kind == RemeshedEdgeKind::mouth) {
      EXPECT_LT(std::abs(cut.region.plane.height_over_crack(e.mid.x)), 1e-9);
      EXPECT_LT(std::abs(cut.region.plane.height_over_crack(a.place.x)), 1e-9);
    }
  }
  const SmoothSurfacePatches patches(surface, cut.region.faces);
  EXPECT_EQ(rim.size(), patches.rim_edges().size());
  for (const std::size_t e : patches.rim_edges()) {
    const SurfaceEdge& edge = surface.edges()[e];
    const auto at = rim.find({edge.ends[0], edge.ends[1]});
    ASSERT_NE(at, rim.end());
    EXPECT_EQ(at->second, edge.mid);
  }
  for (const RemeshedPoint& point : made.points) {
    EXPECT_LT((surface.nearest_place(point.place.x).x - point.place.x).norm(), 1e-9);
  }
  // Every edge of a mouth, and nothing folded.
  for (std::size_t m = 0; m < made.mouths.size(); ++m) {
    EXPECT_EQ(made.mouths[m].size(), cut.region.mouths[m].line.corners.size());
  }
  for (const RemeshedTriangle& t : made.triangles) {
    const Vec3 out =
        surface
            .nearest_place((made.points[static_cast<std::size_t>(t.points[0])].place.x +
                            made.points[static_cast<std::size_t>(t.points[1])].place.x +
                            made.points[static_cast<std::size_t>(t.points[2])].place.x) /
                           3.0)
            .normal;
    for (const auto& [r, weight] : shape::triangle_rule(5)) {
      EXPECT_GT(triangle_normal(made, t, r).normalized().dot(out), 0.5);
    }
  }
}

} // namespace spricka::test
