// SPDX-License-Identifier: GPL-3.0-or-later
#include "distorted.hpp"
#include "mesh/boundary.hpp"
#include "mesh/quality.hpp"
#include "mesh/subdivide.hpp"
#include "meshes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace spricka::test_subdivide {
namespace {

using base::ElementId;
using base::ElementType;
using base::NodeId;

const std::vector<bool> only_net{true};

// Straight through the middle of a block, corner after corner and mid after mid.
std::vector<NodeId> bottom_line(const model::Mesh& mesh, double y) {
  std::map<double, NodeId> by_x;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (mesh.x[n].y() == y) {
      by_x.emplace(mesh.x[n].x(), NodeId(n));
    }
  }
  std::vector<NodeId> line;
  line.reserve(by_x.size());
  for (const auto& [x, node] : by_x) {
    line.push_back(node);
  }
  return line;
}

class Subdivide : public testing::TestWithParam<ElementType> {};

TEST_P(Subdivide, KeepsAreaBoundaryAndSets) {
  model::Mesh mesh = test::distorted_block(GetParam());
  const model::Mesh before = mesh;
  mesh::subdivide_plane_elements(mesh, only_net);
  EXPECT_EQ(mesh.element_count(), 4 * before.element_count());
  EXPECT_NEAR(test::area(mesh), test::area(before), 1e-13 * test::area(before));
  EXPECT_TRUE(mesh::find_invalid_elements(mesh).empty());
  EXPECT_EQ(mesh::boundary_faces(mesh).size(), 2 * mesh::boundary_faces(before).size());
  const std::set<base::Label> labels(mesh.node_label.begin(), mesh.node_label.end());
  EXPECT_EQ(labels.size(), mesh.node_count());
  const std::set<base::Label> numbers(mesh.element_label.begin(), mesh.element_label.end());
  EXPECT_EQ(numbers.size(), mesh.element_count());
  for (std::size_t n = 0; n < before.node_count(); ++n) {
    EXPECT_EQ(mesh.x[n], before.x[n]);
    EXPECT_EQ(mesh.node_label[n], before.node_label[n]);
  }
  std::vector<model::Face> all;
  for (const char* side : {"XMIN", "XMAX", "YMIN", "YMAX"}) {
    const std::vector<model::Face>& now = test::faces(mesh, side).faces;
    all.insert(all.end(), now.begin(), now.end());
    EXPECT_EQ(mesh::build_face_chains(mesh, now).size(), 1U);
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, mesh::boundary_faces(mesh));
  for (std::size_t s = 0; s < mesh.element_sets.size(); ++s) {
    EXPECT_EQ(mesh.element_sets[s].elements.size(), 4 * before.element_sets[s].elements.size());
  }
}

TEST_P(Subdivide, ElementSetsCoverWhatTheirParentsCovered) {
  model::Mesh mesh = test::distorted_block(GetParam());
  const auto area_of = [](const model::Mesh& whole, const model::ElementSet& set) {
    model::Mesh part = whole;
    part.type.clear();
    part.nodes.clear();
    part.first.clear();
    for (const ElementId e : set.elements) {
      model::add_element(part, whole.type[e.index()], whole.element_nodes(e), 1, base::NetId(0));
    }
    return test::area(part);
  };
  std::vector<double> before;
  for (const model::ElementSet& set : mesh.element_sets) {
    before.push_back(area_of(mesh, set));
  }
  mesh::subdivide_plane_elements(mesh, only_net);
  mesh::subdivide_plane_elements(mesh, only_net);
  for (std::size_t s = 0; s < before.size(); ++s) {
    EXPECT_NEAR(area_of(mesh, mesh.element_sets[s]), before[s], 1e-13 * before[s]);
  }
}

TEST_P(Subdivide, PathsStayInOrder) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.type = GetParam();
  spec.size = {4.0, 2.0, 1.0};
  spec.nx = 4;
  spec.ny = 2;
  mesh::generate_block(mesh, base::NetId(0), "", spec);
  mesh.node_sets.push_back({"PATH", bottom_line(mesh, 1.0), {}});
  mesh.node_sets.push_back({"BACK", {}, {}});
  mesh.node_sets[1].nodes.assign(mesh.node_sets[0].nodes.rbegin(), mesh.node_sets[0].nodes.rend());
  mesh::subdivide_plane_elements(mesh, only_net);
  const std::vector<NodeId>& path = mesh.node_sets[0].nodes;
  EXPECT_EQ(path, bottom_line(mesh, 1.0));
  EXPECT_EQ(std::vector<NodeId>(path.rbegin(), path.rend()), mesh.node_sets[1].nodes);
}

// A set of single nodes gains none; one of a whole side and one of all nodes gain all.
TEST_P(Subdivide, NodeSetsGainWhatLiesBetweenTheirNodes) {
  model::Mesh mesh = test::distorted_block(GetParam());
  std::vector<NodeId> corners;
  std::vector<NodeId> all;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    all.emplace_back(n);
  }
  const std::span<const NodeId> first = mesh.element_nodes(ElementId(0));
  corners.push_back(first[0]);
  mesh.node_sets = {{"ONE", corners, {}},
                    {"ALL", all, {}},
                    {"SIDE", mesh::nodes_of_faces(mesh, test::faces(mesh, "YMAX").faces), {}}};
  mesh::subdivide_plane_elements(mesh, only_net);
  EXPECT_EQ(mesh.node_sets[0].nodes, corners);
  EXPECT_EQ(mesh.node_sets[1].nodes.size(), mesh.node_count());
  std::vector<NodeId> side = mesh.node_sets[2].nodes;
  std::sort(side.begin(), side.end());
  EXPECT_EQ(side, mesh::nodes_of_faces(mesh, test::faces(mesh, "YMAX").faces));
}

INSTANTIATE_TEST_SUITE_P(Types, Subdivide,
                         testing::Values(ElementType::trim3, ElementType::trimc6,
                                         ElementType::quam4, ElementType::quamc8,
                                         ElementType::quamc9),
                         [](const auto& type) {
                           return std::string(base::element_info(type.param).name);
                         });

// New nodes of a round edge lie on the quadratic arc: off the circle by the fourth power of the
// angle, whatever is divided.
TEST(Subdivide, RoundEdgesStayRound) {
  model::Mesh mesh;
  mesh::RingSpec spec;
  spec.type = ElementType::quamc8;
  spec.ri = 1.0;
  spec.ro = 2.0;
  spec.nt = 24;
  mesh::generate_ring(mesh, base::NetId(0), "", spec);
  mesh::subdivide_plane_elements(mesh, only_net);
  mesh::subdivide_plane_elements(mesh, only_net);
  const double angle = 2.0 * std::numbers::pi / spec.nt;
  for (const NodeId n : mesh::nodes_of_faces(mesh, test::faces(mesh, "INNER").faces)) {
    EXPECT_NEAR(mesh.x[n.index()].norm(), 1.0, std::pow(angle, 4) / 100.0);
  }
}

TEST(Subdivide, OtherNetsStayAsTheyAre) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  mesh::generate_block(mesh, base::NetId(0), "A.", spec);
  spec.origin = {2.0, 0.0, 0.0};
  mesh::generate_block(mesh, base::NetId(1), "B.", spec);
  const model::Mesh before = mesh;
  mesh::subdivide_plane_elements(mesh, {false, true});
  EXPECT_EQ(mesh.element_count(), 5U);
  EXPECT_EQ(mesh.element_nodes(ElementId(0)).front(), before.element_nodes(ElementId(0)).front());
  EXPECT_EQ(test::faces(mesh, "A.XMIN").faces, test::faces(before, "A.XMIN").faces);
  EXPECT_EQ(std::count(mesh.node_net.begin(), mesh.node_net.end(), base::NetId(0)), 8);
}

} // namespace
} // namespace spricka::test_subdivide
