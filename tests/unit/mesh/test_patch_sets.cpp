// SPDX-License-Identifier: GPL-3.0-or-later
#include "cracked.hpp"

namespace spricka::test_patch_sets {
namespace {

using base::NodeId;
using base::Vec3;

model::Mesh with_sets() {
  model::Mesh mesh = test::block(10.0, 8.0, 10, 8);
  const auto by_y = [](const Vec3& x) { return x.y(); };
  mesh.node_sets.push_back({"EDGE",
                            test::nodes_where(
                                mesh, [](const Vec3& x) { return x.x() < 1e-9; }, by_y),
                            {}});
  mesh.node_sets.push_back({"ALL",
                            test::nodes_where(
                                mesh, [](const Vec3&) { return true; }, by_y),
                            {}});
  mesh.node_sets.push_back({"UPPER",
                            test::nodes_where(
                                mesh, [](const Vec3& x) { return x.y() > 5.9; }, by_y),
                            {}});
  model::ElementSet upper{"UP", {}, {}};
  for (std::size_t e = 40; e < 80; ++e) {
    upper.elements.emplace_back(e);
  }
  mesh.element_sets.push_back(upper);
  return mesh;
}

const model::NodeSet& node_set(const model::Mesh& mesh, const std::string& name) {
  return *std::find_if(mesh.node_sets.begin(), mesh.node_sets.end(),
                       [&](const model::NodeSet& s) { return s.name == name; });
}

std::set<NodeId> used_nodes(const model::Mesh& mesh) {
  return {mesh.nodes.begin(), mesh.nodes.end()};
}

TEST(PatchSets, NodesOnABoundarySetJoinIt) {
  const model::Mesh host = with_sets();
  const auto cracked = test::insert(host, {test::crack({{0, 4.3, 0}, {1.0, 4.3, 0}})});
  const auto used = used_nodes(cracked.mesh);
  std::set<NodeId> expected;
  for (const NodeId n : used) {
    if (cracked.mesh.x[n.index()].x() < 1e-12) {
      expected.insert(n);
    }
  }
  const auto& set = node_set(cracked.mesh, "EDGE").nodes;
  EXPECT_EQ(std::set<NodeId>(set.begin(), set.end()), expected); // both mouth nodes too
  EXPECT_EQ(set.size(), expected.size());
  EXPECT_TRUE(expected.contains(cracked.faces[0].left[0]));
  EXPECT_TRUE(expected.contains(cracked.faces[0].right[0]));
}

TEST(PatchSets, SetOfAllNodesTakesAllNewOnes) {
  const model::Mesh host = with_sets();
  const auto cracked = test::insert(host, {test::crack({{0, 4.3, 0}, {1.0, 4.3, 0}})});
  const auto& set = node_set(cracked.mesh, "ALL").nodes;
  EXPECT_EQ(std::set<NodeId>(set.begin(), set.end()), used_nodes(cracked.mesh));
}

TEST(PatchSets, SetsFarAwayAreUntouched) {
  const model::Mesh host = with_sets();
  const auto cracked = test::insert(host, {test::crack({{0, 2.3, 0}, {1.0, 2.3, 0}})});
  EXPECT_EQ(node_set(cracked.mesh, "UPPER").nodes, node_set(host, "UPPER").nodes);
}

TEST(PatchSets, NewElementsBelongToTheSetsWhereTheyLie) {
  const model::Mesh host = with_sets();
  const auto cracked = test::insert(host, {test::crack({{0, 4.0, 0}, {2.0, 4.0, 0}})});
  const auto& up = cracked.mesh.element_sets[1].elements;
  const std::set<base::ElementId> in(up.begin(), up.end());
  for (std::size_t e = 0; e < cracked.mesh.element_count(); ++e) {
    const auto nodes = cracked.mesh.element_nodes(base::ElementId(e));
    double y = 0.0;
    const auto corners = static_cast<std::size_t>(base::element_info(cracked.mesh.type[e]).corners);
    for (std::size_t i = 0; i < corners; ++i) {
      y += cracked.mesh.x[nodes[i].index()].y() / static_cast<double>(corners);
    }
    EXPECT_EQ(in.contains(base::ElementId(e)), y > 4.0);
  }
}

TEST(PatchSets, PropertyAndNetAreInherited) {
  model::Mesh host = with_sets();
  std::fill(host.property.begin(), host.property.end(), base::PropertyId(std::size_t{3}));
  const auto cracked = test::insert(host, {test::crack({{0, 4.0, 0}, {2.0, 4.0, 0}})});
  for (std::size_t e = 0; e < cracked.mesh.element_count(); ++e) {
    EXPECT_EQ(cracked.mesh.property[e], base::PropertyId(std::size_t{3}));
    EXPECT_EQ(cracked.mesh.element_net[e], test::net0);
  }
}

TEST(PatchSets, PropertiesBesideThePatchAreKept) {
  model::Mesh host = with_sets();
  for (std::size_t e = 0; e < host.element_count(); ++e) { // a seam at x = 3
    host.property[e] = base::PropertyId(e % 10 < 3 ? std::size_t{0} : std::size_t{1});
  }
  const auto cracked = test::insert(host, {test::crack({{0, 4.0, 0}, {1.5, 4.0, 0}})});
  test::expect_sound(host, cracked);
  for (std::size_t e = 0; e < cracked.mesh.element_count(); ++e) {
    const auto nodes = cracked.mesh.element_nodes(base::ElementId(e));
    double x = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      x += cracked.mesh.x[nodes[i].index()].x() / 3.0;
    }
    EXPECT_EQ(cracked.mesh.property[e].value, x < 3.0 ? 0 : 1);
  }
  base::Diagnostics diagnostics;
  EXPECT_FALSE(
      test::insert(host, {test::crack({{0, 4.0, 0}, {3.5, 4.0, 0}})}, diagnostics).has_value());
  ASSERT_EQ(diagnostics.error_count(), 1U);
  EXPECT_EQ(diagnostics.messages()[0].code, "E424");
}

} // namespace
} // namespace spricka::test_patch_sets
