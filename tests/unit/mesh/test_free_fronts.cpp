// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks in solids without a tube of tip elements: tetrahedra up to the front, by wish or where no
// tube fits.
#include "mesh/generate/generate.hpp"
#include "mesh/quality.hpp"
#include "mesh/tube/insert_solid.hpp"
#include "shape/topology.hpp"

#include "tests/unit/mesh/meshes.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace spricka::test_free_fronts {
namespace {

using base::ElementId;
using base::ElementType;
using base::NodeId;
using base::Vec3;

constexpr double pi = std::numbers::pi;

/// From -4 to 4.
model::Mesh block(ElementType type, int n) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.type = type;
  spec.origin = Vec3::Constant(-4.0);
  spec.size = Vec3::Constant(8.0);
  spec.nx = spec.ny = spec.nz = n;
  mesh::generate_solid_block(mesh, base::NetId(std::size_t{0}), "", spec);
  return mesh;
}

/// In a plane z = const, half axes c along x and a along y.
mesh::SolidCrack disc(const Vec3& centre, double c, double a) {
  mesh::SolidCrack crack;
  crack.crack = base::CrackId(std::size_t{0});
  crack.net = base::NetId(std::size_t{0});
  for (int i = 0; i < 160; ++i) {
    const double t = -2.0 * pi * i / 160;
    crack.front.emplace_back(centre + Vec3(c * std::cos(t), a * std::sin(t), 0));
  }
  return crack;
}

mesh::TubeMeshParameters no_tube() {
  mesh::TubeMeshParameters wish;
  wish.tube = false;
  return wish;
}

struct Attempt {
  std::optional<mesh::CrackedMesh> cracked;
  base::Diagnostics diagnostics;
};

Attempt cut(const model::Mesh& host, const mesh::SolidCrack& crack,
            const mesh::TubeMeshParameters& wish) {
  Attempt made;
  made.cracked = mesh::insert_solid_cracks(host, std::vector{crack}, std::vector{wish},
                                           std::vector<base::SourceSpan>(1), made.diagnostics);
  for (const base::Diagnostic& d : made.diagnostics.messages()) {
    GTEST_LOG_(INFO) << d.code << " " << d.text;
  }
  return made;
}

/// Edges from one corner on the front to one that is not: the part of the way that the mid node
/// stands at, of those that are quarter points how many there are in all.
std::pair<std::size_t, std::size_t> quarter_points(const mesh::CrackedMesh& cracked) {
  const model::Mesh& mesh = cracked.mesh;
  std::set<NodeId> front;
  for (const mesh::FrontPoint& point : cracked.fronts[0].points) {
    front.insert(point.node);
  }
  std::set<NodeId> seen;
  std::pair<std::size_t, std::size_t> count{0, 0};
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(ElementId(e));
    for (int m = 0; mesh.type[e] == ElementType::tet10 && m < 6; ++m) {
      const auto ends = shape::edge_corners(mesh.type[e], m);
      NodeId a = nodes[static_cast<std::size_t>(ends[0])];
      NodeId b = nodes[static_cast<std::size_t>(ends[1])];
      const NodeId mid = nodes[static_cast<std::size_t>(4 + m)];
      if (front.contains(a) == front.contains(b) || !seen.insert(mid).second) {
        continue;
      }
      if (front.contains(b)) {
        std::swap(a, b);
      }
      const double part = (mesh.x[mid.index()] - mesh.x[a.index()]).norm() /
                          (mesh.x[b.index()] - mesh.x[a.index()]).norm();
      EXPECT_TRUE(std::abs(part - 0.25) < 1e-6 || std::abs(part - 0.5) < 1e-6) << part;
      ++(part < 0.3 ? count.first : count.second);
    }
  }
  return count;
}

void expect_whole(const model::Mesh& host, const mesh::CrackedMesh& cracked, double area) {
  const model::Mesh& mesh = cracked.mesh;
  EXPECT_TRUE(mesh::find_mesh_faults(mesh).bad.empty());
  EXPECT_NEAR(test::area(mesh), test::area(host), 1e-9 * test::area(host));
  ASSERT_EQ(cracked.faces.size(), 1U);
  const mesh::CrackFaceNodes& faces = cracked.faces[0];
  for (const auto* sides : {&faces.left_sides, &faces.right_sides}) {
    double sum = 0.0;
    for (const model::Face& side : *sides) {
      const mesh::FaceNodes nodes = mesh::face_nodes(mesh, side);
      const Vec3& a = mesh.x[nodes.all[0].index()];
      sum +=
          0.5 * (mesh.x[nodes.all[1].index()] - a).cross(mesh.x[nodes.all[2].index()] - a).norm();
    }
    EXPECT_NEAR(sum, area, 0.01 * area); // the front has chords
  }
  // Nodes of the front are one, all others of the faces two, at one place.
  std::set<NodeId> front;
  for (const mesh::FrontPoint& point : cracked.fronts[0].points) {
    front.insert(point.node);
  }
  std::set<NodeId> single;
  for (std::size_t i = 0; i < faces.left.size(); ++i) {
    EXPECT_EQ(mesh.x[faces.left[i].index()], mesh.x[faces.right[i].index()]);
    if (faces.left[i] == faces.right[i]) {
      single.insert(faces.left[i]);
    }
  }
  EXPECT_TRUE(std::ranges::includes(single, front));
  EXPECT_EQ(single.size(), 2 * front.size() - (cracked.fronts[0].points[0].at_surface ? 1 : 0));
}

TEST(FreeFronts, AreMeshedByWish) {
  for (const ElementType type : {ElementType::tet10, ElementType::hexec20}) {
    const model::Mesh host = block(type, 4);
    for (const auto& [crack, area] : {std::pair(disc({0.1, 0.2, 0.3}, 1.0, 1.0), pi),
                                      {disc({0, 0, 0.3}, 1.0, 0.4), 0.4 * pi},
                                      {disc({0, -4, 0.1}, 1.0, 1.0), 0.5 * pi},
                                      {disc({-4, -4, 0.1}, 1.0, 0.7), 0.175 * pi}}) {
      const Attempt made = cut(host, crack, no_tube());
      ASSERT_TRUE(made.cracked);
      EXPECT_TRUE(made.diagnostics.messages().empty());
      expect_whole(host, *made.cracked, area);
      const auto [quarter, half] = quarter_points(*made.cracked);
      EXPECT_LT(half, (quarter + half) / 50);
      for (const std::string& note : made.cracked->notes) {
        GTEST_LOG_(INFO) << note;
      }
    }
  }
}

TEST(FreeFronts, MayHaveStraightEdges) {
  const model::Mesh host = block(ElementType::tet10, 4);
  mesh::TubeMeshParameters wish = no_tube();
  wish.quarter_point = false;
  const Attempt made = cut(host, disc({0.1, 0.2, 0.3}, 1.0, 1.0), wish);
  ASSERT_TRUE(made.cracked);
  EXPECT_EQ(quarter_points(*made.cracked).first, 0U);
}

// A front that meets the surface at 18 degrees: no tube fits, tetrahedra do, and it is told.
TEST(FreeFronts, StandInForATube) {
  for (const ElementType type : {ElementType::tet10, ElementType::hexec20}) {
    const model::Mesh host = block(type, 4);
    const Attempt made = cut(host, disc({0, -4 + 0.95, 0.1}, 1.0, 1.0), {});
    ASSERT_TRUE(made.cracked);
    ASSERT_EQ(made.diagnostics.messages().size(), 1U);
    EXPECT_EQ(made.diagnostics.messages()[0].code, "W423");
    EXPECT_NE(made.diagnostics.messages()[0].text.find("at 18 degrees only"), std::string::npos);
    const double segment = std::acos(0.95) - 0.95 * std::sqrt(1 - 0.95 * 0.95); // beyond the face
    expect_whole(host, *made.cracked, pi - segment);
  }
}

// The deck's own radius does not fit: that is a mistake, not a case for another mesh.
TEST(FreeFronts, DoNotTakeThePlaceOfATubeThatIsAskedFor) {
  mesh::TubeMeshParameters wide;
  wide.radius = 0.6; // the front curves by 0.5
  const Attempt made = cut(block(ElementType::tet10, 4), disc({0, 0, 0.1}, 0.5, 0.5), wide);
  EXPECT_FALSE(made.cracked);
  ASSERT_FALSE(made.diagnostics.messages().empty());
  EXPECT_EQ(made.diagnostics.messages()[0].code, "E423");
}

} // namespace
} // namespace spricka::test_free_fronts
