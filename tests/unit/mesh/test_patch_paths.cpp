// SPDX-License-Identifier: GPL-3.0-or-later
#include "cracked.hpp"
#include "model/cracks.hpp"

namespace spricka::test_patch_paths {
namespace {

using base::NodeId;
using base::Vec3;

std::vector<NodeId> on_line(const model::Mesh& mesh, double y) {
  return test::nodes_where(
      mesh, [&](const Vec3& x) { return std::abs(x.y() - y) < 1e-9; },
      [](const Vec3& x) { return x.x(); });
}

mesh::CrackLine path_crack(const model::Mesh& mesh, double y, double a, bool half) {
  mesh::CrackLine line = test::crack({{0, y, 0}, {a, y, 0}});
  line.path = on_line(mesh, y);
  line.symmetric_half = half;
  return line;
}

model::TipMeshSettings no_patch() {
  model::TipMeshSettings wishes;
  wishes.patch = false;
  return wishes;
}

TEST(PathCrack, WithoutPatchNodesAreDoubled) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const model::TipMeshSettings wishes = no_patch();
  const auto cracked = test::insert(host, {path_crack(host, 4.0, 3.0, false)}, &wishes);
  test::expect_crack_faces(cracked, 0, 3.0);
  test::expect_conforming(cracked);
  EXPECT_EQ(cracked.mesh.node_count(), host.node_count() + 6);
  EXPECT_EQ(cracked.mesh.element_count(), host.element_count());
  EXPECT_NEAR(test::area(cracked.mesh), 80.0, 1e-11);
  EXPECT_TRUE(mesh::find_invalid_elements(cracked.mesh).empty());
  EXPECT_EQ(test::expect_quarter_points(cracked, cracked.fronts[0].tip_point().node), 8);
  EXPECT_NEAR(cracked.fronts[0].size, 1.0, 1e-15);
  EXPECT_EQ(cracked.host[17], base::ElementId(std::size_t{17}));
}

TEST(PathCrack, WithoutPatchInLinearElements) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8, base::ElementType::quam4);
  const model::TipMeshSettings wishes = no_patch();
  const auto cracked = test::insert(host, {path_crack(host, 4.0, 3.0, false)}, &wishes);
  EXPECT_EQ(cracked.mesh.node_count(), host.node_count() + 3);
  test::expect_crack_faces(cracked, 0, 3.0);
}

TEST(PathCrack, WithoutPatchOnASymmetryLineNothingIsDoubled) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const model::TipMeshSettings wishes = no_patch();
  const auto cracked = test::insert(host, {path_crack(host, 0.0, 3.0, true)}, &wishes);
  EXPECT_EQ(cracked.mesh.node_count(), host.node_count());
  EXPECT_EQ(cracked.faces[0].left.size(), 7U);
  EXPECT_TRUE(cracked.faces[0].right.empty());
  EXPECT_TRUE(cracked.fronts[0].symmetric_half);
  EXPECT_EQ(test::expect_quarter_points(cracked, cracked.fronts[0].tip_point().node), 4);
  const auto above = test::insert(host, {path_crack(host, 8.0, 3.0, true)}, &wishes);
  EXPECT_TRUE(above.faces[0].left.empty());
  EXPECT_EQ(above.faces[0].right.size(), 7U);
}

TEST(PathCrack, WithoutPatchTheTipMustBeANode) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const model::TipMeshSettings wishes = no_patch();
  base::Diagnostics diagnostics;
  EXPECT_FALSE(test::insert(host, {path_crack(host, 4.0, 3.3, false)}, diagnostics, &wishes));
  ASSERT_EQ(diagnostics.error_count(), 1U);
  EXPECT_EQ(diagnostics.messages()[0].code, "E427");
}

TEST(PathCrack, APathMustFollowEdges) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  mesh::CrackLine line = path_crack(host, 4.0, 3.0, false);
  std::swap(line.path[2], line.path[6]);
  const model::TipMeshSettings wishes = no_patch();
  base::Diagnostics diagnostics;
  EXPECT_FALSE(test::insert(host, {line}, diagnostics, &wishes));
}

TEST(PathCrack, WithPatchTheTipIsWhereItShouldBe) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const auto cracked = test::insert(host, {path_crack(host, 4.0, 3.3, false)});
  test::expect_sound(host, cracked);
  test::expect_crack_faces(cracked, 0, 3.3);
}

class HalfCrack : public testing::TestWithParam<double> {};

TEST_P(HalfCrack, OnASymmetryLine) {
  for (const double y : {0.0, 8.0}) {
    SCOPED_TRACE(y);
    model::Mesh host = test::block(10.0, 8.0, 10, 8);
    host.node_sets.push_back({"LINE", on_line(host, y), {}});
    const double a = GetParam();
    const auto cracked = test::insert(host, {path_crack(host, y, a, true)});
    test::expect_sound(host, cracked);
    const auto& crack_faces = cracked.faces[0];
    const auto& crack_face = y == 0.0 ? crack_faces.left : crack_faces.right;
    EXPECT_TRUE((y == 0.0 ? crack_faces.right : crack_faces.left).empty());
    ASSERT_GE(crack_face.size(), 3U);
    for (std::size_t i = 1; i < crack_face.size(); ++i) {
      EXPECT_GT(cracked.mesh.x[crack_face[i].index()].x(),
                cracked.mesh.x[crack_face[i - 1].index()].x());
      EXPECT_NEAR(cracked.mesh.x[crack_face[i].index()].y(), y, 1e-14);
    }
    EXPECT_EQ(cracked.mesh.x[crack_face[0].index()], Vec3(0, y, 0));
    EXPECT_NEAR(cracked.mesh.x[crack_face.back().index()].x(), a, 1e-14);
    EXPECT_EQ(test::expect_quarter_points(cracked, cracked.fronts[0].tip_point().node),
              mesh::TipMeshParameters{}.sectors); // half of them, two edges each
    // the set of the line has the nodes of the line, none more, none less
    std::set<NodeId> expected;
    for (const NodeId n : std::set<NodeId>(cracked.mesh.nodes.begin(), cracked.mesh.nodes.end())) {
      if (std::abs(cracked.mesh.x[n.index()].y() - y) < 1e-9) {
        expected.insert(n);
      }
    }
    const auto& set = cracked.mesh.node_sets[0].nodes;
    EXPECT_EQ(std::set<NodeId>(set.begin(), set.end()), expected);
    const char* name = y == 0.0 ? "YMIN" : "YMAX";
    const auto chains =
        mesh::build_face_chains(cracked.mesh, test::faces(cracked.mesh, name).faces);
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_NEAR(test::chord_length(cracked.mesh, chains[0].faces), 10.0, 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(Lengths, HalfCrack, testing::Values(0.02, 0.5, 1.0, 3.3, 5.0, 8.0, 9.7));

TEST(PathCrack, HalfCrackFromInsideALine) {
  // the mouth is a corner node in the middle of a side: what lies before it stays as it is
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  mesh::CrackLine line = test::crack({{3, 0, 0}, {5.2, 0, 0}});
  line.path = on_line(host, 0.0);
  line.path.erase(line.path.begin(), line.path.begin() + 6);
  line.symmetric_half = true;
  const auto cracked = test::insert(host, {line});
  test::expect_sound(host, cracked);
  EXPECT_NEAR(test::chord_length(cracked.mesh, test::faces(cracked.mesh, "YMIN").faces), 10.0,
              1e-13);
}

TEST(CrackErrors, AreReported) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const auto code = [&](const std::vector<mesh::CrackLine>& lines,
                        const model::TipMeshSettings* wishes) {
    base::Diagnostics diagnostics;
    EXPECT_FALSE(test::insert(host, lines, diagnostics, wishes).has_value());
    return diagnostics.messages().empty() ? std::string() : diagnostics.messages()[0].code;
  };
  EXPECT_EQ(code({test::crack({{1, 4, 0}, {2, 4, 0}})}, nullptr), "E421");   // inside the body
  EXPECT_EQ(code({test::crack({{30, 40, 0}, {2, 4, 0}})}, nullptr), "E421"); // far away
  EXPECT_EQ(code({test::crack({{0, 4, 0}, {-2, 4, 0}})}, nullptr), "E425");  // away from the body
  EXPECT_EQ(code({test::crack({{0, 4, 0}, {12, 4, 0}})}, nullptr), "E425");  // through the body
  model::TipMeshSettings wide;
  wide.radius = 3.5;
  EXPECT_EQ(code({test::crack({{0, 4, 0}, {3, 4, 0}})}, &wide), "E423");
  // half cracks from both ends of a line of symmetry, whose patches would meet
  mesh::CrackLine left = test::crack({{0, 0, 0}, {4, 0, 0}});
  mesh::CrackLine right = test::crack({{10, 0, 0}, {6, 0, 0}}, 1);
  left.symmetric_half = right.symmetric_half = true;
  EXPECT_EQ(code({left, right}, nullptr), "E428");
}

TEST(CrackErrors, LinearHost) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8, base::ElementType::quam4);
  base::Diagnostics diagnostics;
  EXPECT_FALSE(test::insert(host, {test::crack({{0, 4, 0}, {3, 4, 0}})}, diagnostics).has_value());
  EXPECT_EQ(diagnostics.messages()[0].code, "E426");
}

} // namespace
} // namespace spricka::test_patch_paths
