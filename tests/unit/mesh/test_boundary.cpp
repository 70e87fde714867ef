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
  const auto chains = mesh::build_face_chains(mesh, mesh::boundary_faces(mesh));
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
  const auto chains = mesh::build_face_chains(mesh, shuffled);
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
  EXPECT_EQ(mesh::build_face_chains(mesh, {set[0], set[1], set[3]}).size(), 2U);
}

TEST(Boundary, FacesWithinNeedAllTheirNodes) {
  const model::Mesh mesh = block(3, 3);
  std::vector<base::NodeId> nodes;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (mesh.x[n].y() < 1e-12 && mesh.x[n].x() < 0.8) {
      nodes.emplace_back(n);
    }
  }
  const auto found = mesh::boundary_faces_with_all_nodes_in(mesh, nodes);
  const auto& bottom = test::faces(mesh, "YMIN").faces;
  EXPECT_EQ(found, (std::vector<model::Face>{bottom[0], bottom[1]}));
  EXPECT_EQ(mesh::nodes_of_faces(mesh, found).size(), 5U);
}

/// A cube whose upper corners are nodes 4 to 7, round its upper face, and node 8 above; more nodes
/// may follow.
struct Cube {
  model::Mesh mesh;
  std::vector<base::NodeId> n;

  Cube() {
    mesh.dim = 3;
    mesh.first = {0};
    for (const double z : {0.0, 1.0}) {
      for (const base::Vec2& at :
           {base::Vec2(0, 0), base::Vec2(1, 0), base::Vec2(1, 1), base::Vec2(0, 1)}) {
        add({at.x(), at.y(), z});
      }
    }
    add({0.5, 0.5, 2.0});
    model::add_element(mesh, base::ElementType::hexe8, std::span(n).first(8), 1, net);
  }
  void add(const base::Vec3& x) {
    n.push_back(model::add_node(mesh, x, static_cast<base::Label>(n.size() + 1), net));
  }
  void add_tetrahedron(std::array<std::size_t, 4> at) {
    model::add_element(mesh, base::ElementType::tet4,
                       std::array{n[at[0]], n[at[1]], n[at[2]], n[at[3]]},
                       static_cast<base::Label>(mesh.element_count() + 1), net);
  }
  /// The surface's area vector, which vanishes if it is closed.
  [[nodiscard]] base::Vec3 area() const {
    base::Vec3 sum = base::Vec3::Zero();
    for (const model::Face& face : mesh::outer_surface_faces(mesh)) {
      const auto nodes = test::nodes_of(mesh, face);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        sum += mesh.x[nodes[i].index()].cross(mesh.x[nodes[(i + 1) % nodes.size()].index()]);
      }
    }
    return sum;
  }

  const base::NetId net{std::size_t{0}};
};

// Two tetrahedra on top of a cube, with its upper corners: they meet its face at the diagonal.
TEST(Boundary, OuterFacesLeaveOutQuadrilateralsThatTrianglesMeet) {
  Cube cube;
  EXPECT_EQ(mesh::outer_surface_faces(cube.mesh), mesh::boundary_faces(cube.mesh));
  cube.add_tetrahedron({4, 5, 6, 8});
  EXPECT_EQ(mesh::outer_surface_faces(cube.mesh),
            mesh::boundary_faces(cube.mesh)); // half of it is free
  cube.add_tetrahedron({4, 6, 7, 8});
  EXPECT_EQ(mesh::boundary_faces(cube.mesh).size(), 6U + 6U);
  EXPECT_EQ(mesh::outer_surface_faces(cube.mesh).size(), 5U + 4U);
  EXPECT_LT(cube.area().norm(), 1e-12);
}

// Four round a node in the middle of the face.
TEST(Boundary, OuterFacesLeaveOutQuadrilateralsThatFourTrianglesMeet) {
  Cube cube;
  cube.add({0.5, 0.5, 1.0});
  cube.add_tetrahedron({4, 5, 9, 8});
  cube.add_tetrahedron({5, 6, 9, 8});
  cube.add_tetrahedron({6, 7, 9, 8});
  EXPECT_EQ(mesh::outer_surface_faces(cube.mesh),
            mesh::boundary_faces(cube.mesh)); // a quarter is free
  cube.add_tetrahedron({7, 4, 9, 8});
  EXPECT_EQ(mesh::outer_surface_faces(cube.mesh).size(), 5U + 4U);
  EXPECT_LT(cube.area().norm(), 1e-12);
}

} // namespace
} // namespace spricka::test_boundary
