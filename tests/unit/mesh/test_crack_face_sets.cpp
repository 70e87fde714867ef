// SPDX-License-Identifier: GPL-3.0-or-later
#include "cracked.hpp"
#include "mesh/cut/crack_face_sets.hpp"
#include "mesh/cut/patch.hpp"
#include "mesh/cut/tip_mesh.hpp"

#include <cmath>

namespace spricka::test_crack_face_sets {
namespace {

using base::NodeId;
using base::Vec3;

constexpr double mouth = 5.0; // a node of the lower edge

bool below(const Vec3& x) {
  return x.y() < 1e-9;
}

// Sets along the lower edge that end at the mouth, go across it, or touch it in one node; a line of
// nodes that the crack runs along.
model::Mesh with_sets() {
  model::Mesh mesh = test::block(10.0, 8.0, 10, 8);
  const auto add = [&](const char* name, auto&& where) {
    mesh.node_sets.push_back(
        {name, test::nodes_where(mesh, where, [](const Vec3& x) { return x.x() + x.y(); }), {}});
  };
  add("LEFT", [](const Vec3& x) { return below(x) && x.x() < mouth + 1e-9; });
  add("RIGHT", [](const Vec3& x) { return below(x) && x.x() > mouth - 1e-9; });
  add("ALONG", [](const Vec3& x) { return below(x); });
  add("POINT", [](const Vec3& x) { return below(x) && std::abs(x.x() - mouth) < 1e-9; });
  add("LINE", [](const Vec3& x) { return std::abs(x.x() - mouth) < 1e-9; });
  add("HALF", [](const Vec3& x) { return x.x() < mouth + 1e-9; });
  return mesh;
}

struct Held {
  bool left = false, right = false;
};

Held held(const mesh::CrackedMesh& cracked, const std::string& name, std::size_t at) {
  const auto set = std::ranges::find(cracked.mesh.node_sets, name, &model::NodeSet::name);
  const auto has = [&](NodeId n) { return std::ranges::find(set->nodes, n) != set->nodes.end(); };
  return {has(cracked.faces[0].left[at]), has(cracked.faces[0].right[at])};
}

void expect_sides(const mesh::CrackedMesh& cracked) {
  for (const auto& [name, left, right] :
       {std::tuple("LEFT", true, false), std::tuple("RIGHT", false, true),
        std::tuple("ALONG", true, true), std::tuple("POINT", true, true),
        std::tuple("LINE", true, true)}) {
    const Held found = held(cracked, name, 0);
    EXPECT_EQ(found.left, left) << name;
    EXPECT_EQ(found.right, right) << name;
  }
  const mesh::NodeSetsOnCrackFaces membership(cracked.mesh, cracked.faces);
  for (const model::NodeSet& set : cracked.mesh.node_sets) {
    const bool line = set.name == "LINE"; // a patch has taken the rest of it
    for (const auto& choice : line
                                  ? std::vector<mesh::NodeSetsOnCrackFaces::ChosenCoincidentNodes>()
                                  : membership.choose_nodes_belonging_to_set(set.nodes)) {
      EXPECT_EQ(choice.alone, set.name == "POINT") << set.name;
    }
  }
}

// The crack goes up: its left face is the body's left part.
TEST(CrackFaceSets, ASetThatEndsAtAMouthHasTheFaceOnItsSide) {
  const model::Mesh host = with_sets();
  expect_sides(test::insert(host, {test::crack({{mouth, 0, 0}, {mouth, 1.3, 0}})}));
}

// Nodes of the net's own mesh are doubled: the same, and middle nodes follow their corners.
TEST(CrackFaceSets, NodesOfTheNetsOwnMeshAlike) {
  const model::Mesh host = with_sets();
  mesh::CrackLine line = test::crack({{mouth, 0, 0}, {mouth, 3.0, 0}});
  line.path = host.node_sets[4].nodes;
  const mesh::HostMesh around(host);
  mesh::TipMeshParameters tip = mesh::choose_tip_mesh(around, line, nullptr);
  tip.patch = false;
  base::Diagnostics diagnostics;
  const base::SourceSpan span;
  const auto cracked = mesh::insert_cracks(around, std::span(&line, 1), std::span(&tip, 1),
                                           std::span(&span, 1), diagnostics);
  ASSERT_TRUE(cracked.has_value());
  expect_sides(*cracked);
  for (std::size_t i = 0; i + 1 < cracked->faces[0].left.size(); ++i) {
    const Held half = held(*cracked, "HALF", i);
    EXPECT_TRUE(half.left) << i;
    EXPECT_FALSE(half.right) << i;
    const Held path = held(*cracked, "LINE", i);
    EXPECT_TRUE(path.left && path.right) << i;
  }
}

} // namespace
} // namespace spricka::test_crack_face_sets
