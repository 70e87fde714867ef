// SPDX-License-Identifier: GPL-3.0-or-later
#include "cracked.hpp"
#include "mesh/cut/mouth.hpp"

namespace spricka::test_patch_embedded {
namespace {

using base::Vec3;

mesh::CrackLine inside(std::vector<Vec3> points) {
  mesh::CrackLine line = test::crack(std::move(points));
  line.embedded = true;
  return line;
}

/// Crack faces of the first crack: one place, two nodes everywhere but at both tips.
void expect_two_tips(const mesh::CrackedMesh& cracked, double length) {
  ASSERT_EQ(cracked.fronts.size(), 2U);
  const auto& crack_faces = cracked.faces[0];
  const auto& x = cracked.mesh.x;
  ASSERT_EQ(crack_faces.left.size(), crack_faces.right.size());
  EXPECT_EQ(crack_faces.left.front(), cracked.fronts[0].tip_point().node);
  EXPECT_EQ(crack_faces.right.front(), cracked.fronts[0].tip_point().node);
  EXPECT_EQ(crack_faces.left.back(), cracked.fronts[1].tip_point().node);
  EXPECT_EQ(crack_faces.right.back(), cracked.fronts[1].tip_point().node);
  double along = 0.0;
  for (std::size_t k = 1; k < crack_faces.left.size(); ++k) {
    EXPECT_EQ(x[crack_faces.left[k].index()], x[crack_faces.right[k].index()]);
    EXPECT_EQ(crack_faces.left[k] == crack_faces.right[k], k + 1 == crack_faces.left.size());
    along += (x[crack_faces.left[k].index()] - x[crack_faces.left[k - 1].index()]).norm();
  }
  EXPECT_NEAR(along, length, 1e-12 * length);
  for (const mesh::CrackFront& front : cracked.fronts) {
    EXPECT_NEAR(front.a, 0.5 * length, 1e-12 * length);
    EXPECT_EQ(test::expect_quarter_points(cracked, front.tip_point().node),
              2 * mesh::TipMeshParameters{}.sectors);
  }
  EXPECT_EQ(cracked.fronts[0].number, 1);
  EXPECT_EQ(cracked.fronts[1].number, 2);
}

TEST(PatchEmbedded, SlantCrackHasTwoTipsThatLookAway) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const Vec3 from(3.7, 3.1, 0);
  const Vec3 to(6.1, 4.9, 0);
  const auto cracked = test::insert(host, {inside({from, to})});
  test::expect_sound(host, cracked);
  expect_two_tips(cracked, 3.0);
  const Vec3 along = (to - from).normalized();
  EXPECT_NEAR((cracked.fronts[0].tip_point().growth + along).norm(), 0.0, 1e-14);
  EXPECT_NEAR((cracked.fronts[1].tip_point().growth - along).norm(), 0.0, 1e-14);
  EXPECT_NEAR((cracked.fronts[0].tip_point().x - from).norm(), 0.0, 1e-14 * 8);
  EXPECT_NEAR((cracked.fronts[1].tip_point().x - to).norm(), 0.0, 1e-14 * 8);
}

TEST(PatchEmbedded, KinkedCrack) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const auto cracked = test::insert(host, {inside({{3, 4, 0}, {4, 4, 0}, {5, 5, 0}, {6.5, 5, 0}})});
  test::expect_sound(host, cracked);
  expect_two_tips(cracked, 2.5 + std::sqrt(2.0));
}

TEST(PatchEmbedded, CrackMuchShorterThanAnElement) {
  const model::Mesh host = test::block(10.0, 8.0, 5, 4);
  for (const double length : {0.5, 0.05, 0.005}) {
    const auto cracked = test::insert(host, {inside({{4.3, 3.3, 0}, {4.3 + length, 3.3, 0}})});
    test::expect_sound(host, cracked);
    expect_two_tips(cracked, length);
  }
}

TEST(PatchEmbedded, WhereAStartLies) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  using mesh::CrackStartLocation;
  EXPECT_EQ(mesh::locate_crack_start(host, {0, 4, 0}, test::net0), CrackStartLocation::boundary);
  EXPECT_EQ(mesh::locate_crack_start(host, {5, 4, 0}, test::net0),
            CrackStartLocation::inside); // on a node
  EXPECT_EQ(mesh::locate_crack_start(host, {5.2, 4.1, 0}, test::net0), CrackStartLocation::inside);
  EXPECT_EQ(mesh::locate_crack_start(host, {-0.5, 4, 0}, test::net0), CrackStartLocation::outside);
}

TEST(PatchEmbedded, RefusesWhatIsNoEmbeddedCrack) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const auto code = [&](std::vector<Vec3> points) {
    base::Diagnostics diagnostics;
    EXPECT_FALSE(test::insert(host, {inside(std::move(points))}, diagnostics).has_value());
    return diagnostics.messages().empty() ? std::string() : diagnostics.messages().front().code;
  };
  EXPECT_EQ(code({{0.01, 4, 0}, {3, 4, 0}}), "E421"); // meant to start on the boundary
  EXPECT_EQ(code({{-2, 4, 0}, {3, 4, 0}}), "E421");   // outside
  EXPECT_EQ(code({{3, 4, 0}, {10, 4, 0}}), "E423");   // a tip on the boundary
  EXPECT_EQ(code({{3, 4, 0}, {12, 4, 0}}), "E425");   // through it
}

} // namespace
} // namespace spricka::test_patch_embedded
