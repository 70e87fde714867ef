// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks inside of bodies, what they share with their neighbours, and what is refused.
#include "solid_cracks.hpp"
#include "surface_hosts.hpp"
#include "tests/places.hpp"

#include <array>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace spricka::test_solid_cracks {
namespace {

using base::ElementId;
using base::ElementType;
using base::NodeId;
using base::Vec3;
using test::axes;
using test::box;
using test::ellipse;
using test::expect_closed;
using test::expect_crack;
using test::expect_sound_solid;
using test::expect_ties;
using test::insert_cracks;
using test::ring;

constexpr double pi = std::numbers::pi;

class SolidHosts : public testing::TestWithParam<std::pair<ElementType, int>> {};

TEST_P(SolidHosts, PennyInABox) {
  const auto [type, n] = GetParam();
  const model::Mesh host = box(type, n);
  const mesh::SolidCrack crack = ellipse({0.1, 0.2, 0.3}, Eigen::Matrix3d::Identity(), 0.6, 0.6);
  const auto cracked = insert_cracks(host, {crack});
  ASSERT_TRUE(cracked);
  EXPECT_NEAR(test::area(cracked->mesh), test::area(host), 1e-12 * test::area(host));
  expect_sound_solid(host, *cracked);
  expect_closed(host, *cracked);
  expect_crack(crack, *cracked, 0, pi * 0.36);
  expect_ties(*cracked);
  for (const std::string& note : cracked->notes) {
    GTEST_LOG_(INFO) << note;
  }
}

INSTANTIATE_TEST_SUITE_P(
    SolidCracks, SolidHosts,
    testing::Values(std::pair(ElementType::tet10, 4), std::pair(ElementType::tet4, 6),
                    std::pair(ElementType::penta6, 6), std::pair(ElementType::pentac15, 6),
                    std::pair(ElementType::hexe8, 8), std::pair(ElementType::hexec20, 4),
                    std::pair(ElementType::hexec20, 9), std::pair(ElementType::hexec27, 6)),
    [](const auto& at) {
      return std::string(base::element_info(at.param.first).name) + "_" +
             std::to_string(at.param.second);
    });

TEST(SolidCracks, EllipsesInRandomPlanes) {
  const int tries = test::full_size() ? 150 : 12;
  const std::array<model::Mesh, 4> hosts{box(ElementType::tet10, 4), box(ElementType::tet10, 9),
                                         box(ElementType::hexec20, 8), box(ElementType::hexe8, 7)};
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(random);
  };
  for (int i = 0; i < tries; ++i) {
    const double c = uniform(0.1, 1.2);
    const double a = c * uniform(0.15, 1.0);
    const Vec3 axis(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(uniform(-3, 3), axis.normalized()).toRotationMatrix();
    const Vec3 centre(uniform(-2, 2), uniform(-2, 2), uniform(-2, 2));
    const mesh::SolidCrack crack = ellipse(centre, turn, c, a);
    const model::Mesh& host = hosts[static_cast<std::size_t>(i) % hosts.size()];
    SCOPED_TRACE(std::to_string(i) + ": c = " + std::to_string(c) + " a = " + std::to_string(a));
    const auto cracked = insert_cracks(host, {crack});
    ASSERT_TRUE(cracked);
    // A skew face of eight nodes and the two of six in its place differ by a little.
    EXPECT_NEAR(test::area(cracked->mesh), test::area(host),
                1e-5 * std::pow(a * c, 1.5) + 1e-10 * test::area(host));
    expect_sound_solid(host, *cracked);
    expect_closed(host, *cracked);
    expect_crack(crack, *cracked, 0, pi * a * c);
    expect_ties(*cracked);
  }
}

/// A similar place: x -> scale (turn x + shift).
struct Move {
  double scale = 1.0;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();
  Vec3 operator()(const Vec3& x) const { return scale * (turn * x + shift); }
};

void expect_same_patch(const model::Mesh& host, const mesh::SolidCrack& crack, const Move& move) {
  const auto first = insert_cracks(host, {crack});
  ASSERT_TRUE(first);
  model::Mesh other = host;
  std::ranges::transform(host.x, other.x.begin(), move);
  mesh::SolidCrack there = crack;
  there.normal = move.turn * crack.normal;
  std::ranges::transform(crack.front, there.front.begin(), move);
  const auto second = insert_cracks(other, {there});
  ASSERT_TRUE(second);
  ASSERT_EQ(first->mesh.nodes, second->mesh.nodes);
  for (std::size_t n = 0; n < first->mesh.node_count(); ++n) {
    EXPECT_NEAR((move(first->mesh.x[n]) - second->mesh.x[n]).norm(), 0.0, 1e-7 * move.scale);
  }
}

TEST(SolidCracks, UnitsAndPositionDoNotChangeThePatch) {
  const Eigen::Matrix3d odd = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3d flat = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d bore =
      Eigen::AngleAxisd(0.75 * pi, Vec3::UnitZ()) * axes(Vec3::UnitX(), Vec3::UnitZ());
  struct Case {
    model::Mesh host;
    mesh::SolidCrack crack;
  };
  const std::vector<Case> cases{
      {box(ElementType::tet10, 5), ellipse({0.1, 0.2, 0.3}, odd, 0.7, 0.4)},
      {box(ElementType::hexec20, 5), ellipse({0.1, -4, 0.3}, flat, 1.0, 0.7)},
      {box(ElementType::tet10, 5), ellipse({-4, -4, 0.8}, flat, 1.6, 1.6)}, // in nodes
      {box(ElementType::tet10, 6),
       ellipse({-4, -4, 2.9}, flat, 0.8, 1.0)}, // beside a parallel face
      {ring(ElementType::hexec20, 4, 16, 3), ellipse(bore.col(0), bore, 0.6, 0.5)}};
  const Eigen::Matrix3d way =
      Eigen::AngleAxisd(1.1, Vec3(-2, 1, 1).normalized()).toRotationMatrix();
  Eigen::Matrix3d round;
  round << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const std::vector<Move> moves{{1.0, flat, {16, 16, 16}},
                                {1.0, flat, {7.3, -11.1, 23.7}},
                                {1e-3, flat, {0, 0, 0}},
                                {1.0, round, {0, 0, 0}},
                                {1000.0, way, {5, 2, 0.7}}};
  for (std::size_t c = 0; c < cases.size(); ++c) {
    for (std::size_t m = 0; m < moves.size(); ++m) {
      SCOPED_TRACE(std::to_string(c) + " " + std::to_string(m));
      expect_same_patch(cases[c].host, cases[c].crack, moves[m]);
    }
  }
}

TEST(SolidCracks, SetsAndNeighbours) {
  model::Mesh host = box(ElementType::hexec20, 6);
  model::ElementSet half{"HALF", {}, {}};
  for (std::size_t e = 0; e < host.element_count(); ++e) {
    Vec3 middle = Vec3::Zero();
    for (const NodeId n : host.element_nodes(ElementId(e)).first(8)) {
      middle += host.x[n.index()] / 8.0;
    }
    if (middle.x() > 0.0) {
      half.elements.emplace_back(e);
    }
  }
  host.element_sets.push_back(half);
  model::NodeSet all{"ALL", {}, {}};
  for (std::size_t n = 0; n < host.node_count(); ++n) {
    all.nodes.emplace_back(n);
  }
  host.node_sets.push_back(all);
  // Two near each other share a patch, one comes out, one is far away.
  std::vector<mesh::SolidCrack> cracks{
      ellipse({0, 0, 0.2}, Eigen::Matrix3d::Identity(), 0.5, 0.5),
      ellipse({0.3, 0, 0.9}, Eigen::Matrix3d::Identity(), 0.4, 0.3),
      ellipse({2, -4, 2}, Eigen::Matrix3d::Identity(), 0.4, 0.4)};
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    cracks[i].crack = base::CrackId(i);
  }
  const auto cracked = insert_cracks(host, cracks);
  ASSERT_TRUE(cracked);
  expect_sound_solid(host, *cracked);
  expect_ties(*cracked);
  expect_crack(cracks[0], *cracked, 0, 0.25 * pi);
  expect_crack(cracks[1], *cracked, 1, 0.12 * pi);
  expect_crack(cracks[2], *cracked, 2, 0.08 * pi);
  const model::Mesh& mesh = cracked->mesh;
  EXPECT_EQ(mesh.element_sets[0].elements.size(), mesh.element_count());
  for (const ElementId e : mesh.element_sets[1].elements) {
    Vec3 middle = Vec3::Zero();
    const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e.index()]).corners);
    for (const NodeId n : mesh.element_nodes(e).first(corners)) {
      middle += mesh.x[n.index()] / static_cast<double>(corners);
    }
    EXPECT_GT(middle.x(), -1e-9);
  }
  EXPECT_TRUE(cracked->unreplaced_set_nodes[0].empty());
  std::set<NodeId> used(mesh.nodes.begin(), mesh.nodes.end());
  std::set<NodeId> members(mesh.node_sets[0].nodes.begin(), mesh.node_sets[0].nodes.end());
  for (const NodeId n : used) {
    EXPECT_TRUE(members.contains(n));
  }
}

TEST(SolidCracks, RefusalsNameThePlace) {
  const model::Mesh host = box(ElementType::tet10, 4);
  std::string text;
  const auto told = [&](const mesh::SolidCrack& crack, const mesh::TubeMeshParameters& tube) {
    base::Diagnostics diagnostics;
    EXPECT_FALSE(mesh::insert_solid_cracks(host, std::vector{crack}, std::vector{tube},
                                           std::vector<base::SourceSpan>(1), diagnostics));
    EXPECT_EQ(diagnostics.messages().size(), 1U);
    text = diagnostics.messages().empty() ? "" : diagnostics.messages()[0].text;
    return diagnostics.messages().empty() ? "" : diagnostics.messages()[0].code;
  };
  const Eigen::Matrix3d flat = Eigen::Matrix3d::Identity();
  EXPECT_EQ(told(ellipse({9, 0, 0}, flat, 0.5, 0.5), {}), "E425");
  mesh::TubeMeshParameters wide;
  wide.radius = 0.6; // the front curves by 0.5
  EXPECT_EQ(told(ellipse({0, 0, 0}, flat, 0.5, 0.5), wide), "E423");
  // Its front meets the surface at acos(0.99), 8 degrees: too flat for tetrahedra, too.
  EXPECT_EQ(told(ellipse({0, -4 + 0.99, 0}, flat, 1.0, 1.0), {}), "E423");
  EXPECT_NE(text.find("at 8 degrees only"), std::string::npos) << text;
  EXPECT_NE(text.find("-4, 0)"), std::string::npos) << text;
  // Its front comes as near as a hundredth to the surface, along most of it.
  EXPECT_EQ(told(ellipse({0, 0, 3.999}, flat, 0.5, 0.5), {}), "E423");
}

// A half penny at a face; with a second body of the same net on the other side of that face it
// would be a whole one in two bodies.
TEST(SolidCracks, OfTwoBodiesThatTouchNeitherIsChosen) {
  model::Mesh host = box(ElementType::tet10, 4);
  mesh::BlockSpec below;
  below.type = ElementType::hexec20;
  below.origin = Vec3(-4.0, -10.0, -4.0);
  below.size = Vec3(8.0, 6.0, 8.0);
  below.nx = below.ny = below.nz = 5;
  mesh::generate_solid_block(host, base::NetId(std::size_t{0}), "BELOW.", below);
  const auto told = [&](const Vec3& centre) {
    base::Diagnostics diagnostics;
    const auto cracked = mesh::insert_solid_cracks(
        host, std::vector{ellipse(centre, Eigen::Matrix3d::Identity(), 1.0, 1.0)},
        std::vector<mesh::TubeMeshParameters>(1), std::vector<base::SourceSpan>(1), diagnostics);
    EXPECT_NE(cracked.has_value(), diagnostics.has_errors());
    return diagnostics.messages().empty() ? std::string() : diagnostics.messages()[0].text;
  };
  EXPECT_NE(told({0, -4, 0}).find("in another one of its net, at ("), std::string::npos);
  EXPECT_EQ(told({0, 0, 0}).find("in another one of its net, at ("), std::string::npos);
}

} // namespace
} // namespace spricka::test_solid_cracks
