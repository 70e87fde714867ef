// SPDX-License-Identifier: GPL-3.0-or-later
#include "cracked.hpp"
#include "model/cracks.hpp"

// Cracks near each other, lines that cannot be, patches that are finer than their host.
namespace spricka::test_patch_near {
namespace {

using base::Vec3;

constexpr double pi = std::numbers::pi;

mesh::CrackLine inside(std::vector<Vec3> points, std::size_t number) {
  mesh::CrackLine line = test::crack(std::move(points), number);
  line.embedded = true;
  return line;
}

/// Both crack faces of every crack have its length and its places.
void expect_all_crack_faces(const mesh::CrackedMesh& cracked,
                            const std::vector<mesh::CrackLine>& lines) {
  ASSERT_EQ(cracked.faces.size(), lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    double length = 0.0;
    for (std::size_t k = 1; k < lines[i].points.size(); ++k) {
      length += (lines[i].points[k] - lines[i].points[k - 1]).norm();
    }
    const auto& crack_faces = cracked.faces[i];
    ASSERT_EQ(crack_faces.left.size(), crack_faces.right.size());
    double along = 0.0;
    for (std::size_t k = 0; k < crack_faces.left.size(); ++k) {
      const bool tip = k + 1 == crack_faces.left.size() || (k == 0 && lines[i].embedded);
      EXPECT_EQ(crack_faces.left[k] == crack_faces.right[k], tip);
      EXPECT_EQ(cracked.mesh.x[crack_faces.left[k].index()],
                cracked.mesh.x[crack_faces.right[k].index()]);
      along += k == 0 ? 0.0
                      : (cracked.mesh.x[crack_faces.left[k].index()] -
                         cracked.mesh.x[crack_faces.left[k - 1].index()])
                            .norm();
    }
    EXPECT_NEAR(along, length, 1e-12 * length);
  }
}

void expect_cracks(const model::Mesh& host, const std::vector<mesh::CrackLine>& lines) {
  const auto cracked = test::insert(host, lines);
  test::expect_sound(host, cracked);
  expect_all_crack_faces(cracked, lines);
}

TEST(PatchNear, ParallelEdgeCracks) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  for (const double gap : {1.0, 0.5, 0.1, 0.01}) {
    SCOPED_TRACE(gap);
    expect_cracks(host, {test::crack({{0, 4, 0}, {3, 4, 0}}, 0),
                         test::crack({{0, 4 + gap, 0}, {2.5, 4 + gap, 0}}, 1)});
  }
}

TEST(PatchNear, TipsAcrossASmallLigament) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  for (const double gap : {1.0, 0.2, 0.02}) {
    SCOPED_TRACE(gap);
    expect_cracks(host,
                  {inside({{2, 4, 0}, {4, 4, 0}}, 0), inside({{4 + gap, 4, 0}, {7, 4.3, 0}}, 1)});
  }
}

TEST(PatchNear, CracksOfAllSizesInOneElement) {
  const model::Mesh host = test::block(10.0, 8.0, 3, 2);
  expect_cracks(host, {inside({{4, 5, 0}, {5, 5.5, 0}}, 0), inside({{4.5, 5, 0}, {4.6, 5, 0}}, 1),
                       inside({{5, 5, 0}, {5.001, 5.001, 0}}, 2)});
}

TEST(PatchNear, TwoMouthsOnOneEdge) {
  const model::Mesh host = test::block(10.0, 8.0, 2, 2);
  expect_cracks(host, {test::crack({{0, 1, 0}, {0.5, 1, 0}}, 0),
                       test::crack({{0, 2, 0}, {0.3, 2, 0}}, 1), // at a middle node
                       test::crack({{0, 2.2, 0}, {0.3, 2.4, 0}}, 2)});
}

TEST(PatchNear, RoundOneHole) {
  const model::Mesh host = test::lug(6, 36);
  std::vector<mesh::CrackLine> lines;
  for (const double degrees : {80.0, 90.0, 95.0, 140.0}) {
    const Vec3 ray(std::cos(degrees * pi / 180), std::sin(degrees * pi / 180), 0.0);
    // the arc's nodes lie on the circle at multiples of 5 degrees
    lines.push_back(test::crack({36.0 * ray, 46.0 * ray}, lines.size()));
  }
  expect_cracks(host, lines);
}

TEST(PatchNear, SharedPatchesTurnWithTheBody) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const std::vector<mesh::CrackLine> lines{test::crack({{0, 4, 0}, {3, 4, 0}}, 0),
                                           test::crack({{0, 4.5, 0}, {2, 5, 0}}, 1)};
  const auto reference = test::insert(host, lines);
  const auto turn = [](Vec3& x) {
    x = Vec3(0.6 * x.x() - 0.8 * x.y(), 0.8 * x.x() + 0.6 * x.y(), 0);
  };
  model::Mesh other = host;
  std::vector<mesh::CrackLine> turned = lines;
  std::ranges::for_each(other.x, turn);
  for (mesh::CrackLine& line : turned) {
    std::ranges::for_each(line.points, turn);
  }
  const auto found = test::insert(other, turned);
  ASSERT_EQ(found.mesh.node_count(), reference.mesh.node_count());
  EXPECT_EQ(found.mesh.nodes, reference.mesh.nodes);
  for (std::size_t n = 0; n < found.mesh.node_count(); ++n) {
    Vec3 x = reference.mesh.x[n];
    turn(x);
    EXPECT_NEAR((found.mesh.x[n] - x).norm(), 0.0, 1e-6);
  }
}

TEST(PatchNear, LinesThatCannotBe) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const auto text = [&](const std::vector<mesh::CrackLine>& lines) {
    base::Diagnostics diagnostics;
    EXPECT_FALSE(test::insert(host, lines, diagnostics).has_value());
    EXPECT_EQ(diagnostics.messages().size(), 1U);
    EXPECT_EQ(diagnostics.messages().at(0).code, "E430");
    return diagnostics.messages().at(0).text;
  };
  const auto long_one = inside({{2, 4, 0}, {6, 4, 0}}, 0);
  EXPECT_NE(text({long_one, inside({{4, 2, 0}, {4, 6, 0}}, 1)}).find("(4, 4)"), std::string::npos);
  EXPECT_NE(text({long_one, inside({{3, 4, 0}, {3, 6, 0}}, 1)}).find("(3, 4)"), std::string::npos);
  text({long_one, inside({{6, 4, 0}, {8, 5, 0}}, 1)});
  text({long_one, inside({{2, 4, 0}, {6, 4, 0}}, 1)});
  text({test::crack({{0, 4, 0}, {2, 4, 0}}, 0), test::crack({{0, 4, 0}, {2, 5, 0}}, 1)});
  EXPECT_NE(
      text({inside({{2, 4, 0}, {6, 4, 0}, {6, 6, 0}, {4, 6, 0}, {4, 3, 0}}, 0)}).find("(4, 4)"),
      std::string::npos);
  text({inside({{2, 4, 0}, {6, 4, 0}, {3, 4.1, 0}}, 0)}); // turns back
}

TEST(PatchNear, GivenRadiiMustNotReachAnotherCrack) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  model::TipMeshSettings wide;
  wide.radius = 0.4;
  base::Diagnostics diagnostics;
  EXPECT_FALSE(
      test::insert(host, {inside({{2, 4, 0}, {4, 4, 0}}, 0), inside({{4.5, 4, 0}, {7, 4, 0}}, 1)},
                   diagnostics, &wide)
          .has_value());
  ASSERT_FALSE(diagnostics.messages().empty());
  EXPECT_EQ(diagnostics.messages()[0].code, "E423");
}

/// Every tie puts its node where it lies; outside them the mesh is conforming.
void expect_tied_rim(const model::Mesh& host, const mesh::CrackedMesh& cracked) {
  const model::Mesh& mesh = cracked.mesh;
  EXPECT_TRUE(mesh::find_invalid_elements(mesh).empty());
  EXPECT_NEAR(test::area(mesh), test::area(host), 1e-12 * test::area(host));
  ASSERT_FALSE(cracked.ties.empty());
  std::set<base::NodeId> slaves;
  for (const mesh::HangingNodeTie& tie : cracked.ties) {
    EXPECT_TRUE(slaves.insert(tie.slave).second);
    Vec3 x = Vec3::Zero();
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT(tie.master[i].index(), host.node_count()); // of the host, so never a slave
      x += tie.weight[i] * mesh.x[tie.master[i].index()];
      sum += tie.weight[i];
    }
    EXPECT_NEAR(sum, 1.0, 1e-15);
    EXPECT_NEAR((x - mesh.x[tie.slave.index()]).norm(), 0.0, 1e-13);
  }
  // at least two parts for each edge: more slaves than its ends, middle and quarter ties
  EXPECT_GE(slaves.size(), 2U);
}

TEST(PatchTransition, RimLiesOnTheHostsEdges) {
  model::TipMeshSettings wishes;
  wishes.join = model::PatchCoupling::transition;
  const model::Mesh blocks = test::block(10.0, 8.0, 10, 8);
  const model::Mesh round = test::lug(6, 36);
  for (const double a : {0.02, 0.3, 3.0}) {
    expect_tied_rim(blocks,
                    test::insert(blocks, {test::crack({{0, 4.2, 0}, {a, 4.3, 0}})}, &wishes));
    expect_tied_rim(round,
                    test::insert(round, {test::crack({{0, 36, 0}, {0, 36 + 4 * a, 0}})}, &wishes));
    expect_tied_rim(blocks,
                    test::insert(blocks, {inside({{4, 4.1, 0}, {4 + a, 4.2, 0}}, 0)}, &wishes));
  }
}

} // namespace
} // namespace spricka::test_patch_near
