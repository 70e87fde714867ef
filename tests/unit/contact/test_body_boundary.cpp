// SPDX-License-Identifier: GPL-3.0-or-later
// Inside and outside of bodies in space, against boxes and balls whose distance is known.
#include "contact/surface_boundary.hpp"
#include "mesh/boundary.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"

#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::contact::test_body_boundary {
namespace {

using base::ElementType;
using base::Vec3;

model::Mesh block(ElementType type, const Vec3& size) {
  model::Mesh mesh;
  mesh.dim = 3;
  mesh::BlockSpec spec;
  spec.type = type;
  spec.origin = -0.5 * size;
  spec.size = size;
  spec.nx = 4;
  spec.ny = 3;
  spec.nz = 2;
  mesh::generate_solid_block(mesh, base::NetId(std::size_t{0}), "B.", spec);
  return mesh;
}

double distance_to_box(const Vec3& x, const Vec3& half) {
  const Vec3 off = x.cwiseAbs() - half;
  const double out = off.cwiseMax(0.0).norm();
  return out > 0.0 ? out : off.maxCoeff();
}

class BoundaryOfABox : public testing::TestWithParam<ElementType> {};

TEST_P(BoundaryOfABox, TellsDistancesInAndOut) {
  const Vec3 size(4.0, 3.0, 2.0);
  model::Mesh mesh = block(GetParam(), size);
  const Eigen::AngleAxisd turn(0.7, Vec3(1.0, 2.0, -1.0).normalized());
  for (Vec3& x : mesh.x) {
    x = turn * x;
  }
  const Vec3 shift(5.0, -3.0, 1.0);
  base::Vector u(3 * static_cast<Eigen::Index>(mesh.node_count()));
  for (Eigen::Index n = 0; n < u.size(); n += 3) {
    u.segment<3>(n) = shift;
  }
  const geometry::BodyBoundary boundary =
      make_displaced_body_boundary(model::Model(), mesh, mesh::boundary_faces(mesh), u);
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> any(-2.6, 2.6);
  for (int i = 0; i < 400; ++i) {
    const Vec3 x(any(engine), any(engine), any(engine));
    const double exact = distance_to_box(x, 0.5 * size);
    const std::optional<geometry::BoundaryDistance> found =
        boundary.signed_distance(turn * x + shift, 1.5);
    if (exact > 1.5) {
      EXPECT_FALSE(found);
      continue;
    }
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, exact, 1e-12);
    EXPECT_NEAR(found->facet, 0.0, 1e-12); // flat sides, and corners that belong to the shape
  }
}

INSTANTIATE_TEST_SUITE_P(Types, BoundaryOfABox,
                         testing::Values(ElementType::tet10, ElementType::hexec20,
                                         ElementType::hexec27, ElementType::hexe8));

// A block blown up to a ball: triangles leave the curve by no more than the boundary says.
TEST(SpaceBoundary, KnowsHowFarItsTrianglesLeaveACurve) {
  model::Mesh mesh = block(ElementType::hexec20, {2.0, 2.0, 2.0});
  for (Vec3& x : mesh.x) {
    const double r = x.cwiseAbs().maxCoeff();
    x = r > 0.0 ? Vec3(10.0 * r * x.normalized()) : x;
  }
  const geometry::BodyBoundary boundary =
      make_displaced_body_boundary(model::Model(), mesh, mesh::boundary_faces(mesh), {});
  std::mt19937 engine(6);
  std::normal_distribution<double> any;
  for (int i = 0; i < 300; ++i) {
    const Vec3 way = Vec3(any(engine), any(engine), any(engine)).normalized();
    for (const double r : {8.5, 9.5, 10.5, 12.0}) {
      const std::optional<geometry::BoundaryDistance> found =
          boundary.signed_distance(r * way, 20.0);
      ASSERT_TRUE(found);
      EXPECT_GT(found->facet, 0.0);
      EXPECT_NEAR(found->distance, r - 10.0, 1.2 * found->facet + 0.02);
    }
  }
}

} // namespace
} // namespace spricka::contact::test_body_boundary
