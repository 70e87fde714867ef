// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary.hpp"
#include "mesh/cut/coincidence.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace spricka::mesh::test_coincidence {
namespace {

using base::NodeId;
using base::Vec3;

// nx times ny quadrilaterals of side 1 from (x0, 0) on, turned by `angle` about the origin.
void add_block(model::Mesh& mesh, double x0, int nx, int ny, double angle = 0.0) {
  const auto first = static_cast<std::size_t>(mesh.node_count());
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) {
      const double x = x0 + i;
      const double y = j;
      model::add_node(mesh,
                      Vec3(std::cos(angle) * x - std::sin(angle) * y,
                           std::sin(angle) * x + std::cos(angle) * y, 0.0),
                      static_cast<base::Label>(mesh.node_count() + 1), base::NetId(std::size_t{0}));
    }
  }
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const std::size_t n = first + static_cast<std::size_t>(j * (nx + 1) + i);
      const auto up = static_cast<std::size_t>(nx + 1);
      const std::array<NodeId, 4> nodes{NodeId(n), NodeId(n + 1), NodeId(n + 1 + up),
                                        NodeId(n + up)};
      model::add_element(mesh, base::ElementType::quam4, nodes,
                         static_cast<base::Label>(mesh.element_count() + 1),
                         base::NetId(std::size_t{0}));
    }
  }
}

model::Mesh empty_mesh() {
  model::Mesh mesh;
  mesh.first.assign(1, 0);
  return mesh;
}

TEST(Coincidence, TwoBlocksSideBySideHaveASeamOfTheirCommonSides) {
  for (const double angle : {0.0, 0.7}) {
    model::Mesh mesh = empty_mesh();
    add_block(mesh, 0.0, 3, 5, angle);
    add_block(mesh, 3.0, 2, 5, angle);
    EXPECT_EQ(find_coincident_faces(mesh, boundary_faces(mesh)).size(), 5U) << angle;
    EXPECT_TRUE(find_coincident_elements(mesh).empty());
  }
}

TEST(Coincidence, OneBlockAndBlocksApartHaveNone) {
  model::Mesh mesh = empty_mesh();
  add_block(mesh, 0.0, 4, 4);
  add_block(mesh, 4.01, 4, 4);
  EXPECT_TRUE(find_coincident_faces(mesh, boundary_faces(mesh)).empty());
  EXPECT_TRUE(find_coincident_elements(mesh).empty());
}

TEST(Coincidence, BlocksThatMeetInACornerAreNoSeam) {
  model::Mesh mesh = empty_mesh();
  add_block(mesh, 0.0, 2, 2);
  const std::size_t before = mesh.node_count();
  add_block(mesh, 2.0, 2, 2);
  for (std::size_t n = before; n < mesh.node_count(); ++n) {
    mesh.x[n].y() += 2.0;
  }
  EXPECT_TRUE(find_coincident_faces(mesh, boundary_faces(mesh)).empty());
}

TEST(Coincidence, AMeshReadTwiceIsFoundElementByElement) {
  model::Mesh mesh = empty_mesh();
  add_block(mesh, 0.0, 3, 2, 0.3);
  add_block(mesh, 0.0, 3, 2, 0.3);
  const auto pairs = find_coincident_elements(mesh);
  ASSERT_EQ(pairs.size(), 6U);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(pairs[i].first.index(), i);
    EXPECT_EQ(pairs[i].second.index(), i + 6);
  }
}

} // namespace
} // namespace spricka::mesh::test_coincidence
