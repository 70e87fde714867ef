// SPDX-License-Identifier: GPL-3.0-or-later
#include "cracked.hpp"
#include "mesh/cut/crack_region.hpp"
#include "model/cracks.hpp"

namespace spricka::test_patch {
namespace {

using base::Vec3;

constexpr double pi = std::numbers::pi;

TEST(Patch, EdgeCrackInABlock) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const auto cracked = test::insert(host, {test::crack({{0, 4, 0}, {3.3, 4, 0}})});
  test::expect_sound(host, cracked);
  test::expect_crack_faces(cracked, 0, 3.3);
  ASSERT_EQ(cracked.fronts.size(), 1U);
  const mesh::CrackFront& front = cracked.fronts[0];
  EXPECT_NEAR((front.tip_point().x - Vec3(3.3, 4, 0)).norm(), 0.0, 1e-15 * 8);
  EXPECT_NEAR((front.tip_point().growth - Vec3(1, 0, 0)).norm(), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(front.a, 3.3);
  EXPECT_EQ(test::expect_quarter_points(cracked, front.tip_point().node),
            2 * mesh::TipMeshParameters{}.sectors); // two edges each
  for (const char* name : {"XMIN", "XMAX", "YMIN", "YMAX"}) {
    EXPECT_NEAR(test::chord_length(cracked.mesh, test::faces(cracked.mesh, name).faces),
                test::chord_length(host, test::faces(host, name).faces), 1e-13);
  }
  // the left crack face is above
  double above = 0.0;
  for (std::size_t e = 0; e < cracked.mesh.element_count(); ++e) {
    const auto nodes = cracked.mesh.element_nodes(base::ElementId(e));
    if (std::find(nodes.begin(), nodes.end(), cracked.faces[0].left[1]) != nodes.end()) {
      for (const base::NodeId n : nodes) {
        above += cracked.mesh.x[n.index()].y() - 4.0;
      }
    }
  }
  EXPECT_GT(above, 0.0);
}

TEST(Patch, HostNodesAndRimStay) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const auto cracked = test::insert(host, {test::crack({{0, 4, 0}, {1.5, 4, 0}})});
  for (std::size_t n = 0; n < host.node_count(); ++n) {
    EXPECT_EQ(host.x[n], cracked.mesh.x[n]);
    EXPECT_EQ(host.node_label[n], cracked.mesh.node_label[n]);
  }
  for (std::size_t e = 0; e < cracked.mesh.element_count(); ++e) {
    if (cracked.host[e].valid()) {
      const auto a = cracked.mesh.element_nodes(base::ElementId(e));
      const auto b = host.element_nodes(cracked.host[e]);
      EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
    }
  }
}

TEST(Patch, HostsOfTrianglesAndLagrangeQuadrilaterals) {
  for (const auto type : {base::ElementType::trimc6, base::ElementType::quamc9}) {
    const model::Mesh host = test::block(10.0, 8.0, 10, 8, type);
    const auto cracked = test::insert(host, {test::crack({{0, 3.7, 0}, {2.0, 4.1, 0}})});
    test::expect_sound(host, cracked);
  }
}

TEST(Patch, MuchShorterThanAnElement) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  for (const double y : {4.0, 4.5, 4.3, 4.9999}) { // corner, mid node, in between, near a corner
    SCOPED_TRACE(y);
    const auto cracked = test::insert(host, {test::crack({{0, y, 0}, {0.02, y, 0}})});
    test::expect_sound(host, cracked);
    test::expect_crack_faces(cracked, 0, 0.02);
    EXPECT_NEAR(test::chord_length(cracked.mesh, test::faces(cracked.mesh, "XMIN").faces), 8.0,
                1e-13);
  }
}

TEST(Patch, LengthsFromAHundredthToTheLigament) {
  const model::Mesh host = test::lug();
  for (const double a : {0.03, 0.36, 1.8, 3.6, 7.2, 10.8, 18.0, 28.8, 40.0, 48.0}) {
    SCOPED_TRACE(a);
    const auto cracked = test::insert(host, {test::crack({{0, 36, 0}, {0, 36 + a, 0}})});
    test::expect_sound(host, cracked);
    test::expect_crack_faces(cracked, 0, a);
    test::expect_quarter_points(cracked, cracked.fronts[0].tip_point().node);
    EXPECT_LT(cracked.fronts[0].radius, 0.5 * (50.5 - a));
  }
}

TEST(Patch, BoreKeepsItsCurve) {
  const model::Mesh host = test::lug(4, 24);
  const auto cracked = test::insert(host, {test::crack({{0, 36, 0}, {0, 37, 0}})});
  const auto& before = test::faces(host, "BORE").faces;
  const auto& after = test::faces(cracked.mesh, "BORE").faces;
  EXPECT_GT(after.size(), before.size());
  EXPECT_NEAR(test::curve_length(cracked.mesh, after), test::curve_length(host, before),
              1e-12 * 226.0);
  // still in order round the bore, with a gap at the mouth only
  const auto chains = mesh::build_face_chains(cracked.mesh, after);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_FALSE(chains[0].closed);
  const auto first = test::nodes_of(cracked.mesh, chains[0].faces.front())[0];
  const auto last = test::nodes_of(cracked.mesh, chains[0].faces.back())[1];
  EXPECT_NE(first, last);
  EXPECT_EQ(cracked.mesh.x[first.index()], cracked.mesh.x[last.index()]);
}

TEST(Patch, MouthAwayFromNodesOnACoarseArc) {
  const model::Mesh host = test::lug(4, 24);
  for (const double degrees : {77.0, 91.3, 200.0, 305.0}) {
    SCOPED_TRACE(degrees);
    const Vec3 ray(std::cos(degrees * pi / 180), std::sin(degrees * pi / 180), 0.0);
    const auto cracked = test::insert(host, {test::crack({36.0 * ray, 39.0 * ray})});
    test::expect_sound(host, cracked);
    test::expect_crack_faces(cracked, 0, 3.0);
    // the arc's chords leave the circle by some thousandths: the crack starts on the mesh
    EXPECT_NEAR((cracked.fronts[0].tip_point().x - 39.0 * ray).norm(), 0.0, 0.01);
  }
}

TEST(Patch, ShortAgainstTheBulgeOfItsEdge) {
  const model::Mesh host = test::lug(10, 15);
  const Vec3 out = Vec3(std::cos(0.4), std::sin(0.4), 0.0);
  for (const double a : {0.03, 0.3}) {
    SCOPED_TRACE(a);
    // from the head inwards: the body lies beyond the chord of its edge
    test::expect_sound(host, test::insert(host, {test::crack({86.5 * out, (86.5 - a) * out})}));
    // from the bore, almost along it: the room is that to the arc, not to its chords
    const Vec3 along = Vec3(std::cos(1.6), std::sin(1.6), 0.0);
    test::expect_sound(host,
                       test::insert(host, {test::crack({36.0 * out, 36.0 * out + a * along})}));
  }
}

TEST(Patch, NeighboursShareTheRimBetweenThem) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const auto cracked = test::insert(
      host, {test::crack({{0, 2, 0}, {1.5, 2, 0}}, 0), test::crack({{0, 6, 0}, {1.5, 6, 0}}, 1)});
  test::expect_sound(host, cracked);
  std::size_t kept = 0;
  for (std::size_t e = 0; e < cracked.mesh.element_count(); ++e) {
    kept += cracked.host[e] == base::ElementId(std::size_t{30}) ||
                    cracked.host[e] == base::ElementId(std::size_t{40})
                ? 1U
                : 0U;
  }
  EXPECT_EQ(kept, 0U); // the cavities touch at y = 4
}

TEST(Patch, ObliqueCracks) {
  const model::Mesh host = test::block(10.0, 8.0, 20, 16);
  for (const double degrees : {-75.0, -40.0, 20.0, 60.0, 80.0}) {
    SCOPED_TRACE(degrees);
    const Vec3 d(std::cos(degrees * pi / 180), std::sin(degrees * pi / 180), 0.0);
    const Vec3 start(0.0, 4.1, 0.0);
    const auto cracked = test::insert(host, {test::crack({start, start + 2.0 * d})});
    test::expect_sound(host, cracked);
    test::expect_crack_faces(cracked, 0, 2.0);
    EXPECT_NEAR((cracked.fronts[0].tip_point().growth - d).norm(), 0.0, 1e-14);
  }
}

TEST(Patch, KinkedCrack) {
  const model::Mesh host = test::block(10.0, 8.0, 20, 16);
  const auto cracked =
      test::insert(host, {test::crack({{0, 4, 0}, {2, 4, 0}, {3, 4.5, 0}, {3.5, 5.2, 0}})});
  test::expect_sound(host, cracked);
  test::expect_crack_faces(cracked, 0, 2.0 + std::sqrt(1.25) + std::sqrt(0.74));
  EXPECT_NEAR((cracked.fronts[0].tip_point().growth - Vec3(0.5, 0.7, 0).normalized()).norm(), 0.0,
              1e-12);
  bool kink = false;
  for (const base::NodeId n : cracked.faces[0].left) {
    kink = kink || (cracked.mesh.x[n.index()] - Vec3(2, 4, 0)).norm() < 1e-12;
  }
  EXPECT_TRUE(kink);
}

TEST(Patch, DoubleSidedLug) {
  const model::Mesh host = test::lug();
  const auto cracked = test::insert(host, {test::crack({{0, 36, 0}, {0, 46.8, 0}}, 0),
                                           test::crack({{0, -36, 0}, {0, -46.8, 0}}, 1)});
  test::expect_sound(host, cracked);
  ASSERT_EQ(cracked.fronts.size(), 2U);
  test::expect_crack_faces(cracked, 0, 10.8);
  test::expect_crack_faces(cracked, 1, 10.8);
  EXPECT_EQ(mesh::build_face_chains(cracked.mesh, test::faces(cracked.mesh, "BORE").faces).size(),
            2U);
}

TEST(Patch, UnitsAndPlaceDoNotChangeTheMesh) {
  for (const double a : {1.8, 10.8, 28.8}) {
    const model::Mesh host = test::lug();
    const auto line = test::crack({{0, 36, 0}, {0, 36 + a, 0}});
    const auto reference = test::insert(host, {line});
    for (const double scale : {0.001, 1.0 / 25.4, 1e6}) {
      for (const double shift : {0.0, 100.0}) {
        model::Mesh other = host;
        mesh::CrackLine moved = line;
        for (Vec3& x : other.x) {
          x = scale * (x + Vec3(shift, shift, 0.0));
        }
        for (Vec3& x : moved.points) {
          x = scale * (x + Vec3(shift, shift, 0.0));
        }
        const auto cracked = test::insert(other, {moved});
        EXPECT_EQ(cracked.mesh.nodes, reference.mesh.nodes);
        EXPECT_EQ(cracked.faces[0].left, reference.faces[0].left);
      }
    }
  }
}

TEST(Patch, ATurnedBodyGetsTheSameMesh) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const auto line = test::crack({{0, 4, 0}, {3.3, 4, 0}});
  const auto reference = test::insert(host, {line});
  model::Mesh other = host;
  mesh::CrackLine turned = line;
  const auto turn = [](Vec3& x) {
    x = Vec3(0.6 * x.x() - 0.8 * x.y(), 0.8 * x.x() + 0.6 * x.y(), 0.0);
  };
  std::for_each(other.x.begin(), other.x.end(), turn);
  std::for_each(turned.points.begin(), turned.points.end(), turn);
  EXPECT_EQ(test::insert(other, {turned}).mesh.nodes, reference.mesh.nodes);
}

TEST(Patch, SameInputSameMesh) {
  const model::Mesh host = test::lug();
  const auto line = test::crack({{0, 36, 0}, {0, 40, 0}});
  const auto a = test::insert(host, {line});
  const auto b = test::insert(host, {line});
  EXPECT_EQ(a.mesh.nodes, b.mesh.nodes);
  EXPECT_EQ(a.mesh.x, b.mesh.x);
}

TEST(Patch, WishesAreObeyed) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  model::TipMeshSettings wishes;
  wishes.radius = 0.9;
  wishes.size = 0.25;
  wishes.rings = 3;
  wishes.sectors = 12;
  wishes.quarter_point = false;
  const auto cracked = test::insert(host, {test::crack({{0, 4, 0}, {3, 4, 0}})}, &wishes);
  test::expect_sound(host, cracked);
  int tip_elements = 0;
  const Vec3 tip(3, 4, 0);
  std::set<long> radii;
  for (std::size_t e = 0; e < cracked.mesh.element_count(); ++e) {
    const auto nodes = cracked.mesh.element_nodes(base::ElementId(e));
    tip_elements +=
        std::count(nodes.begin(), nodes.end(), cracked.fronts[0].tip_point().node) > 0 ? 1 : 0;
    if (cracked.mesh.type[e] == base::ElementType::quamc8 && !cracked.host[e].valid()) {
      radii.insert(std::lround(1e9 * (cracked.mesh.x[nodes[0].index()] - tip).norm()));
      radii.insert(std::lround(1e9 * (cracked.mesh.x[nodes[1].index()] - tip).norm()));
    }
  }
  EXPECT_EQ(tip_elements, 12);
  ASSERT_EQ(radii.size(), 3U);
  EXPECT_EQ(*radii.begin(), 250000000);
  EXPECT_EQ(*radii.rbegin(), 900000000);
}

TEST(Patch, TipMeshFollowsTheRoomThereIs) {
  const model::Mesh host = test::block(10.0, 8.0, 10, 8);
  const auto radius = [&](double a) {
    return mesh::choose_tip_mesh(host, test::crack({{0, 4, 0}, {a, 4, 0}}), nullptr).radius;
  };
  EXPECT_NEAR(radius(1.0), 0.4, 1e-9);
  EXPECT_NEAR(radius(2.0), 0.8, 1e-9);
  EXPECT_NEAR(radius(9.5), 0.2, 1e-9); // 0.5 of ligament
}

/// The mesh at the tip of one crack, of length 2, in elements of 1 / n.
mesh::TipMeshParameters tip_mesh_in_net(int n, const model::TipMeshSettings* settings = nullptr) {
  const model::Mesh host = test::block(10.0, 8.0, 10 * n, 8 * n);
  return mesh::choose_tip_mesh(host, test::crack({{0, 4, 0}, {2, 4, 0}}), settings);
}

TEST(Patch, TipMeshIsTheSameInAllNetsThatAreNotFiner) {
  const mesh::TipMeshParameters usual = tip_mesh_in_net(1);
  const mesh::TipMeshParameters next = tip_mesh_in_net(3); // outermost ring 0.307, edges 0.333
  for (const mesh::TipMeshParameters& tip : {usual, next}) {
    EXPECT_EQ(tip.finer, 1.0);
    EXPECT_EQ(tip.rings, 5);
    EXPECT_EQ(tip.sectors, 24);
  }
  EXPECT_EQ(usual.size, next.size);
}

TEST(Patch, TipMeshFollowsAFinerNet) {
  for (const int n : {6, 12}) {
    const mesh::TipMeshParameters tip = tip_mesh_in_net(n);
    EXPECT_EQ(tip.radius, tip_mesh_in_net(1).radius);
    // Its outermost ring is as thick as the edges are long, but for whole numbers of rings.
    const double growth = std::pow(1.5, 1.0 / tip.finer);
    EXPECT_NEAR(tip.size * std::pow(growth, tip.rings - 1), 1.0 / n, 0.2 / n);
    EXPECT_NEAR(2.0 * pi * tip.radius / tip.sectors, 0.68 / n, 0.05 / n);
  }
  EXPECT_NEAR(tip_mesh_in_net(12).finer, 2.0 * tip_mesh_in_net(6).finer, 1e-6);
}

TEST(Patch, TipMeshThatTheDeckGivesDoesNotFollow) {
  model::TipMeshSettings settings;
  settings.finer = 3.0; // finer than the net asks for: it stands as it is
  EXPECT_EQ(tip_mesh_in_net(6, &settings).finer, 3.0);
  settings.finer = 0.5;
  EXPECT_NEAR(tip_mesh_in_net(6, &settings).finer, 0.5 * tip_mesh_in_net(6).finer, 1e-12);
  settings.finer = 1.0;
  settings.sizes_given = true;
  EXPECT_EQ(tip_mesh_in_net(6, &settings).rings, 5);
  settings.sizes_given = false;
  settings.tolerance = 1e-3;
  EXPECT_EQ(tip_mesh_in_net(6, &settings).sectors, 24);
}

TEST(Patch, RegionHoldsEveryCavityAndALayer) {
  const model::Mesh host = test::lug();
  std::vector<mesh::CrackLine> lines;
  std::vector<mesh::TipMeshParameters> tips;
  for (const double a : {1.8, 10.8}) {
    lines.push_back(test::crack({{0, 36, 0}, {0, 36 + a, 0}}));
    tips.push_back(mesh::choose_tip_mesh(host, lines.back(), nullptr));
  }
  const auto region = mesh::possible_cavity_elements(host, lines, tips);
  EXPECT_TRUE(std::is_sorted(region.begin(), region.end()));
  const std::set<base::ElementId> in(region.begin(), region.end());
  for (const mesh::CrackLine& line : lines) {
    const auto cracked = test::insert(host, {line});
    std::set<base::ElementId> gone(region.begin(), region.end());
    std::size_t kept = 0;
    for (const base::ElementId e : cracked.host) {
      if (e.valid()) {
        ++kept;
        gone.erase(e);
      }
    }
    EXPECT_EQ(kept + gone.size(), host.element_count()); // all that went is in the region
  }
  EXPECT_LT(region.size(), host.element_count() / 3);
}

} // namespace
} // namespace spricka::test_patch
