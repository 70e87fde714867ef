// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of solid meshes: edges, smooth pieces, nearest places, lines that meet it.
#include "mesh/surface/surface_geometry.hpp"
#include "mesh/surface/surface_hits.hpp"
#include "surface_hosts.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::mesh::test_surface_geometry {
namespace {

using base::ElementType;
using base::Vec2;
using base::Vec3;

constexpr std::array solids{ElementType::tet4,     ElementType::tet10, ElementType::penta6,
                            ElementType::pentac15, ElementType::hexe8, ElementType::hexec20,
                            ElementType::hexec27};

std::vector<FeatureChain> feature_chains(const SurfaceGeometry& surface) {
  std::vector<std::size_t> which;
  for (std::size_t e = 0; e < surface.edges().size(); ++e) {
    if (surface.edges()[e].feature) {
      which.push_back(e);
    }
  }
  return chain_edges(surface.edges(), which, {});
}

TEST(SurfaceGeometry, BoxHasSixPiecesAndTwelveEdges) {
  for (const ElementType type : solids) {
    const SurfaceGeometry surface(test::box_host(type, {1.0, 2.0, 3.0}, 2));
    EXPECT_EQ(surface.piece_count(), 6U);
    const std::vector<FeatureChain> chains = feature_chains(surface);
    ASSERT_EQ(chains.size(), 12U);
    for (const FeatureChain& chain : chains) {
      EXPECT_EQ(chain.edges.size(), 2U);
      EXPECT_FALSE(chain.closed());
    }
    // V - E + F = 2 of a closed surface.
    std::set<base::NodeId> corners;
    for (const SurfaceEdge& edge : surface.edges()) {
      EXPECT_EQ(edge.count, 2);
      corners.insert(edge.ends.begin(), edge.ends.end());
    }
    EXPECT_EQ(corners.size() + surface.faces().size(), surface.edges().size() + 2);
  }
}

TEST(SurfaceGeometry, BoreIsOnePieceHoweverCoarse) {
  for (const ElementType type : solids) {
    // Sixteen facets turn by 22.5 degrees; the square outline has four sides.
    const SurfaceGeometry surface(test::hole_plate(type, {}));
    EXPECT_EQ(surface.piece_count(), 7U) << base::element_info(type).name;
    const std::vector<FeatureChain> chains = feature_chains(surface);
    EXPECT_EQ(std::ranges::count_if(chains, &FeatureChain::closed), 2);
    EXPECT_EQ(chains.size(), 14U);
  }
  // Curved faces of 45 degrees are smooth by their true normals; linear ones are a polygon.
  test::HolePlate coarse;
  coarse.around = 8;
  EXPECT_EQ(SurfaceGeometry(test::hole_plate(ElementType::hexec20, coarse)).piece_count(), 7U);
  EXPECT_EQ(SurfaceGeometry(test::hole_plate(ElementType::hexe8, coarse)).piece_count(), 14U);
}

TEST(SurfaceGeometry, BordersOfKeptSetsAreFeatures) {
  model::Mesh mesh = test::box_host(ElementType::hexec20, Vec3::Ones(), 2);
  model::FaceSet half{"HALF", {}, {}};
  for (const model::FaceSet& set : mesh.face_sets) {
    if (set.name == "ZMAX") {
      half.faces.assign(set.faces.begin(), set.faces.begin() + 2);
    }
  }
  mesh.face_sets.push_back(half);
  const std::array kept{base::FaceSetId(mesh.face_sets.size() - 1)};
  EXPECT_EQ(SurfaceGeometry(mesh, kept).piece_count(), 7U);
}

TEST(SurfaceGeometry, NearestPlaceOfABox) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> in(-1.0, 4.0);
  for (const ElementType type : solids) {
    const Vec3 size(1.0, 2.0, 3.0);
    const SurfaceGeometry surface(test::box_host(type, size, 3));
    for (int i = 0; i < 100; ++i) {
      const Vec3 x(in(random), in(random), in(random));
      const SurfacePlace place = surface.nearest_place(x);
      Vec3 nearest = x.cwiseMax(0.0).cwiseMin(size);
      if (nearest == x) { // inside: to the nearest side
        double least = 1e9;
        for (int k = 0; k < 6; ++k) {
          const double away = k < 3 ? x[k] : size[k - 3] - x[k - 3];
          if (away < least) {
            least = away;
            nearest = x;
            nearest[k % 3] = k < 3 ? 0.0 : size[k - 3];
          }
        }
      }
      EXPECT_LT((place.x - nearest).norm(), 1e-12);
      EXPECT_LT((surface.place_at_coordinates(place.face, place.r).x - nearest).norm(), 1e-12);
    }
  }
}

TEST(SurfaceGeometry, NearestPlaceOnABoreIsWhereItsNormalMeetsThePoint) {
  const SurfaceGeometry surface(test::hole_plate(ElementType::hexec20, {}));
  for (double angle = 0.03; angle < 6.2; angle += 0.1) {
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    const SurfacePlace place = surface.nearest_place(0.9 * out + Vec3(0.0, 0.0, 0.37));
    // Quadratic arcs of 22.5 degrees lie within 1e-4 of the circle, their normals within 1e-2.
    EXPECT_NEAR(place.x.head<2>().norm(), 1.0, 1e-4);
    EXPECT_LT((place.normal + out).norm(), 1e-2);
    const Vec3 away = 0.9 * out + Vec3(0.0, 0.0, 0.37) - place.x;
    EXPECT_LT(away.cross(place.normal).norm(), 1e-7);
  }
}

TEST(SurfaceHits, LinesThroughAPlateWithAHole) {
  for (const ElementType type : {ElementType::tet10, ElementType::hexec20, ElementType::hexe8}) {
    const SurfaceGeometry surface(test::hole_plate(type, {}));
    const Vec3 d = Vec3(1.0, 0.05, 0.02).normalized();
    const std::vector<SurfaceHit> found =
        intersect_line_with_surface(surface, Vec3(-6.0, 0.1, 0.4), d, 12.0);
    ASSERT_EQ(found.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(found[i].leaves(d), i % 2 == 1);
      EXPECT_LT((Vec3(-6.0, 0.1, 0.4) + found[i].along * d - found[i].place.x).norm(), 1e-12);
    }
    EXPECT_NEAR(found[0].place.x.x(), -4.0, 1e-12);
    EXPECT_NEAR(found[3].place.x.x(), 4.0, 1e-12);
    // on the bore, within the sagitta of linear facets
    EXPECT_NEAR(found[1].place.x.head<2>().norm(), 1.0, type == ElementType::hexe8 ? 0.02 : 1e-4);
  }
}

TEST(SurfaceHits, AnEdgeOrACornerCountsOnce) {
  const SurfaceGeometry surface(test::box_host(ElementType::tet10, Vec3::Ones(), 2));
  // through nodes and edges of the mesh, straight and along diagonals
  for (const Vec2& at : {Vec2(0.5, 0.5), Vec2(0.25, 0.5), Vec2(0.3, 0.3), Vec2(0.25, 0.25)}) {
    const auto found =
        intersect_line_with_surface(surface, {at.x(), at.y(), -1.0}, Vec3::UnitZ(), 3.0);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_FALSE(found[0].leaves(Vec3::UnitZ()));
    EXPECT_NEAR(found[1].along, 2.0, 1e-12);
  }
}

TEST(SurfaceHits, InsideIsWhereTheBodyIs) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> wide(-5.0, 5.0);
  std::uniform_real_distribution<double> deep(-0.5, 1.5);
  const SurfaceGeometry surface(test::hole_plate(ElementType::tet10, {}));
  int in = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 x(wide(random), wide(random), deep(random));
    const bool body = x.head<2>().norm() > 1.0 && x.head<2>().cwiseAbs().maxCoeff() < 4.0 &&
                      x.z() > 0.0 && x.z() < 1.0;
    EXPECT_EQ(is_inside_body(surface, x), body) << x.transpose();
    in += body ? 1 : 0;
  }
  EXPECT_GT(in, 50);
}

TEST(SurfaceGeometry, NearestMayBeAskedAmongSomeFacesOnly) {
  const SurfaceGeometry surface(test::box_host(ElementType::tet10, Vec3::Ones(), 2));
  std::vector<std::size_t> top;
  for (std::size_t f = 0; f < surface.faces().size(); ++f) {
    if (surface.place_at_coordinates(f, {1.0 / 3.0, 1.0 / 3.0}).normal.z() > 0.9) {
      top.push_back(f);
    }
  }
  EXPECT_LT((surface.nearest_place({0.3, 0.4, 0.1}, top).x - Vec3(0.3, 0.4, 1.0)).norm(), 1e-12);
}

} // namespace
} // namespace spricka::mesh::test_surface_geometry
