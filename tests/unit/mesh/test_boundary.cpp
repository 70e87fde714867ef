// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary.hpp"
#include "mesh/generate/generate.hpp"
#include "meshes.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <array>
#include <span>

namespace spricka::test_boundary {
namespace {

model::Mesh block(int nx, int ny) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.nx = nx;
  spec.ny = ny;
  mesh::generate_block(mesh, base::NetId(std::size_t{0}), "", spec);
  return mesh;
}

TEST(Boundary, BodyLiesOnTheLeft) {
  const model::Mesh mesh = block(3, 2);
  const auto chains = mesh::chains(mesh, mesh::boundary_faces(mesh));
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_TRUE(chains[0].closed);
  double twice_area = 0.0;
  for (const model::Face& face : chains[0].faces) {
    const auto n = test::nodes_of(mesh, face);
    const base::Vec3& a = mesh.x[n[0].index()];
    const base::Vec3& b = mesh.x[n[1].index()];
    twice_area += a.x() * b.y() - b.x() * a.y();
  }
  EXPECT_NEAR(twice_area, 2.0, 1e-14);
}

TEST(Boundary, ConsecutiveFacesOfAChainShareANode) {
  const model::Mesh mesh = block(4, 3);
  const auto& set = test::faces(mesh, "XMAX").faces;
  const std::vector<model::Face> shuffled{set[2], set[0], set[1]};
  const auto chains = mesh::chains(mesh, shuffled);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_FALSE(chains[0].closed);
  ASSERT_EQ(chains[0].faces.size(), 3U);
  for (std::size_t i = 0; i + 1 < 3; ++i) {
    EXPECT_EQ(test::nodes_of(mesh, chains[0].faces[i])[1],
              test::nodes_of(mesh, chains[0].faces[i + 1])[0]);
  }
}

TEST(Boundary, TwoPiecesAreTwoChains) {
  const model::Mesh mesh = block(4, 1);
  const auto& set = test::faces(mesh, "YMIN").faces;
  EXPECT_EQ(mesh::chains(mesh, {set[0], set[1], set[3]}).size(), 2U);
}

TEST(Boundary, FacesWithinNeedAllTheirNodes) {
  const model::Mesh mesh = block(3, 3);
  std::vector<base::NodeId> nodes;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (mesh.x[n].y() < 1e-12 && mesh.x[n].x() < 0.8) {
      nodes.emplace_back(n);
    }
  }
  const auto found = mesh::faces_within(mesh, nodes);
  const auto& bottom = test::faces(mesh, "YMIN").faces;
  EXPECT_EQ(found, (std::vector<model::Face>{bottom[0], bottom[1]}));
  EXPECT_EQ(mesh::nodes_of_faces(mesh, found).size(), 5U);
}

// Two tetrahedra on top of a cube, with its upper corners: they meet its face at the diagonal.
TEST(Boundary, OuterFacesLeaveOutQuadrilateralsThatTrianglesMeet) {
  model::Mesh mesh;
  mesh.dim = 3;
  mesh.first = {0};
  const base::NetId net(std::size_t{0});
  std::vector<base::NodeId> n;
  for (const double z : {0.0, 1.0}) {
    for (const base::Vec2& at :
         {base::Vec2(0, 0), base::Vec2(1, 0), base::Vec2(1, 1), base::Vec2(0, 1)}) {
      n.push_back(
          model::add_node(mesh, {at.x(), at.y(), z}, static_cast<base::Label>(n.size() + 1), net));
    }
  }
  n.push_back(model::add_node(mesh, {0.5, 0.5, 2.0}, 9, net));
  model::add_element(mesh, base::ElementType::hexe8, std::span(n).first(8), 1, net);
  EXPECT_EQ(mesh::outer_faces(mesh), mesh::boundary_faces(mesh));
  model::add_element(mesh, base::ElementType::tet4, std::array{n[4], n[5], n[6], n[8]}, 2, net);
  EXPECT_EQ(mesh::outer_faces(mesh), mesh::boundary_faces(mesh)); // half of it is free
  model::add_element(mesh, base::ElementType::tet4, std::array{n[4], n[6], n[7], n[8]}, 3, net);
  EXPECT_EQ(mesh::boundary_faces(mesh).size(), 6U + 6U);
  const std::vector<model::Face> outer = mesh::outer_faces(mesh);
  EXPECT_EQ(outer.size(), 5U + 4U);
  base::Vec3 area = base::Vec3::Zero(); // of a closed surface
  for (const model::Face& face : outer) {
    const auto nodes = test::nodes_of(mesh, face);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      area += mesh.x[nodes[i].index()].cross(mesh.x[nodes[(i + 1) % nodes.size()].index()]);
    }
  }
  EXPECT_LT(area.norm(), 1e-12);
}

} // namespace
} // namespace spricka::test_boundary
