// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary.hpp"
#include "mesh/generate/generate.hpp"
#include "meshes.hpp"

#include <gtest/gtest.h>

namespace spricka {
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

} // namespace
} // namespace spricka
