// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of nodes and faces that a crack cuts or comes near.
#include "solid_cracks.hpp"
#include "surface_hosts.hpp"

#include <array>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace spricka::test_solid_sets {
namespace {

using base::ElementType;
using base::NodeId;
using base::Vec3;
using test::axes;
using test::box;
using test::ellipse;
using test::faces_on_skin;
using test::flat_area;
using test::straight;

/// x and y from -4 to 4, z from 0 to 8.
model::Mesh raised_box(ElementType type, int n) {
  model::Mesh mesh = test::box_host(type, Vec3::Constant(8.0), n);
  for (Vec3& x : mesh.x) {
    x -= Vec3(4, 4, 0);
  }
  return mesh;
}

/// What a node set has of the face y = -4 of a box, held or loaded: z above a line of nodes.
model::Mesh with_upper_part(double from) {
  model::Mesh mesh = raised_box(ElementType::hexec20, 8);
  mesh.face_sets.clear();
  mesh.face_sets.push_back({"SKIN", mesh::boundary_faces(mesh), {}});
  model::NodeSet part{"PART", {}, {}};
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (mesh.x[n].y() < -4.0 + 1e-9 && mesh.x[n].z() > from - 1e-9) {
      part.nodes.emplace_back(n);
    }
  }
  mesh.node_sets.push_back(std::move(part));
  return mesh;
}

// The crack, half an ellipse at z = 3.7, takes away the surface round it; the border of the set at
// z = 5 lies within, that at z = 4 goes through the ends of its tube.
TEST(SolidSets, NodeSetsOfAPartOfAFaceKeepTheirBorders) {
  const mesh::SolidCrack crack =
      ellipse({0.1, -4, 3.7}, axes(Vec3::UnitX(), Vec3::UnitY()), 1.2, 0.9);
  for (const double border : {5.0, 4.0, 3.0}) {
    const model::Mesh host = with_upper_part(border);
    base::Diagnostics diagnostics;
    const auto cracked = mesh::insert_solid_cracks(host, std::vector{crack},
                                                   std::vector<mesh::TubeMeshParameters>(1),
                                                   std::vector<base::SourceSpan>(1), diagnostics);
    ASSERT_TRUE(cracked);
    EXPECT_TRUE(diagnostics.messages().empty());
    const model::Mesh& mesh = cracked->mesh;
    double lowest = 8.0;
    for (const NodeId n : mesh.node_sets[0].nodes) {
      lowest = std::min(lowest, mesh.x[n.index()].z());
    }
    EXPECT_DOUBLE_EQ(lowest, border);
    EXPECT_NEAR(flat_area(mesh, faces_on_skin(mesh, mesh.node_sets[0].nodes)), 8.0 * (8.0 - border),
                1e-9);
  }
}

/// Nodes that an element has, on the segment from a to b of a straight line.
std::set<NodeId> on_line(const model::Mesh& mesh, const Vec3& a, const Vec3& b) {
  std::set<NodeId> found;
  for (const NodeId n : mesh.nodes) {
    const Vec3& x = mesh.x[n.index()];
    const Vec3 d = (b - a).normalized();
    const double s = d.dot(x - a);
    if ((x - a - s * d).norm() < 1e-9 && s > -1e-9 && s < (b - a).norm() + 1e-9) {
      found.insert(n);
    }
  }
  return found;
}

// Nodes are held along a sharp edge, a part of it, a line on a smooth face; the crack, half an
// ellipse at z = 3.7 of the face y = -4 or a corner at x = -4, takes their elements, and its mouth
// runs across the lines.
TEST(SolidSets, NodesHeldAlongEdgesAreHeldAlongNewOnes) {
  const Vec3 corner(-4, -4, 3.7);
  const mesh::SolidCrack at_corner = ellipse(corner, axes(Vec3::UnitX(), Vec3::UnitY()), 1.2, 0.9);
  const mesh::SolidCrack at_face =
      ellipse({0.1, -4, 3.7}, axes(Vec3::UnitX(), Vec3::UnitY()), 1.2, 0.9);
  struct Line {
    const mesh::SolidCrack* crack;
    Vec3 from, to;
  };
  const std::vector<Line> lines{
      {&at_corner, {-4, -4, 0}, {-4, -4, 8}}, {&at_corner, {-4, -4, 3}, {-4, -4, 5}},
      {&at_corner, {-4, -4, 4}, {-4, -4, 8}}, {&at_face, {0, -4, 0}, {0, -4, 8}},
      {&at_face, {-4, -4, 5}, {4, -4, 5}},    {&at_face, {0, -4, 4}, {0, -4, 6}},
      {&at_face, {0, -4, 3}, {0, -4, 5}}};
  for (const ElementType type : {ElementType::hexec20, ElementType::tet10, ElementType::hexe8}) {
    for (const Line& line : lines) {
      model::Mesh host = raised_box(type, 8);
      host.node_sets.clear();
      const std::set<NodeId> before = on_line(host, line.from, line.to);
      host.node_sets.push_back({"LINE", {before.begin(), before.end()}, {}});
      mesh::SetUsage use;
      use.held.emplace_back(std::size_t{0});
      base::Diagnostics diagnostics;
      const auto cracked = mesh::insert_solid_cracks(
          mesh::SolidHostMesh(host, use), std::vector{*line.crack},
          std::vector<mesh::TubeMeshParameters>(1), std::vector<base::SourceSpan>(1), diagnostics);
      ASSERT_TRUE(cracked);
      EXPECT_TRUE(diagnostics.messages().empty());
      EXPECT_TRUE(cracked->unreplaced_set_nodes[0].empty())
          << base::element_info(type).name << line.from.transpose();
      const std::vector<NodeId>& now = cracked->mesh.node_sets[0].nodes;
      std::set<NodeId> there = on_line(cracked->mesh, line.from, line.to);
      for (const mesh::HangingNodeTie& tie : cracked->ties) { // between linear elements' nodes
        there.erase(tie.slave);
      }
      EXPECT_EQ(std::set<NodeId>(now.begin(), now.end()), there)
          << base::element_info(type).name << " " << line.from.transpose();
    }
  }
}

// Three nodes hold a body: those at its corners and on its edges stay, whatever is meshed anew.
TEST(SolidSets, SingleNodesHeldOnEdgesStay) {
  model::Mesh host = raised_box(ElementType::tet10, 4);
  host.node_sets.clear();
  mesh::SetUsage use;
  for (const Vec3& x : {Vec3(-4, -4, 0), Vec3(-4, -4, 2), Vec3(-2, -4, 0)}) {
    const std::set<NodeId> found = on_line(host, x, x + 1e-3 * Vec3::UnitX());
    ASSERT_EQ(found.size(), 1U);
    use.held.emplace_back(host.node_sets.size());
    host.node_sets.push_back({"", {found.begin(), found.end()}, {}});
  }
  const mesh::SolidCrack crack =
      ellipse({-4, -4, 1.1}, axes(Vec3::UnitX(), Vec3::UnitY()), 0.9, 0.8);
  base::Diagnostics diagnostics;
  const auto cracked = mesh::insert_solid_cracks(mesh::SolidHostMesh(host, use), std::vector{crack},
                                                 std::vector<mesh::TubeMeshParameters>(1),
                                                 std::vector<base::SourceSpan>(1), diagnostics);
  ASSERT_TRUE(cracked);
  const std::vector<bool> used = model::mark_nodes_in_use(cracked->mesh);
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_TRUE(cracked->unreplaced_set_nodes[s].empty()) << s;
    EXPECT_EQ(cracked->mesh.node_sets[s].nodes, host.node_sets[s].nodes) << s;
    EXPECT_TRUE(used[host.node_sets[s].nodes.front().index()]) << s;
  }
}

TEST(SolidSets, ABorderThroughTheEndOfATubeIsTold) {
  const mesh::SolidCrack crack =
      ellipse({0.1, -4, 4.03}, axes(Vec3::UnitX(), Vec3::UnitY()), 1.2, 0.9);
  const model::Mesh host = with_upper_part(4.0);
  base::Diagnostics diagnostics;
  const auto cracked =
      mesh::insert_solid_cracks(host, std::vector{crack}, std::vector<mesh::TubeMeshParameters>(1),
                                std::vector<base::SourceSpan>(1), diagnostics);
  ASSERT_TRUE(cracked);
  ASSERT_EQ(diagnostics.messages().size(), 1U);
  EXPECT_EQ(diagnostics.messages()[0].code, "W425");
  EXPECT_NE(diagnostics.messages()[0].text.find("PART"), std::string::npos);
  // Moved, but no further than an element's length, some 0.3.
  const double area =
      flat_area(cracked->mesh, faces_on_skin(cracked->mesh, cracked->mesh.node_sets[0].nodes));
  EXPECT_NEAR(area, 32.0, 0.5);
  // A group that nothing uses may move unsaid; the skin goes all round and has no border.
  mesh::SetUsage use;
  use.nodes = {false};
  use.faces = {true};
  base::Diagnostics quiet;
  EXPECT_TRUE(mesh::insert_solid_cracks(mesh::SolidHostMesh(host, use), std::vector{crack},
                                        std::vector<mesh::TubeMeshParameters>(1),
                                        std::vector<base::SourceSpan>(1), quiet));
  EXPECT_TRUE(quiet.messages().empty());
}

} // namespace
} // namespace spricka::test_solid_sets
