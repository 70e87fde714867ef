// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/quality.hpp"
#include "mesh/surface/crack_relief.hpp"
#include "mesh/tube/insert_solid.hpp"
#include "surface_hosts.hpp"

#include "tests/unit/mesh/meshes.hpp"
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

/// Cracks that have turned out of their plane, cut into blocks.
namespace spricka::test_turned_cracks {
namespace {

using base::ElementType;
using base::Vec3;

constexpr double pi = std::numbers::pi;

/// A cube of side 8 about the origin.
model::Mesh cube(ElementType type, int n) {
  return test::moved(test::box_host(type, Vec3::Constant(8.0), n),
                     [](const Vec3& x) { return Vec3(x - Vec3::Constant(4.0)); });
}

/// Behind a straight edge crack in z = 0 up to x = 0, through the cube along y: strips as long as
/// `step`, each turned by so much against the one before it [rad].
mesh::SolidCrack bent_edge_crack(double step, const std::vector<double>& turns) {
  constexpr int pieces = 60;
  mesh::SolidCrack crack;
  crack.net = base::NetId(0);
  crack.crack = base::CrackId(std::size_t{0});
  crack.closed = false;
  mesh::NonPlanarCrackSurface::PastAndPresentFronts fronts;
  double angle = 0.0;
  Vec3 tip = Vec3::Zero();
  const auto line = [&] {
    std::vector<Vec3> points;
    for (int i = 0; i <= pieces; ++i) { // t = m x b = -y
      points.emplace_back(tip + Vec3(0.0, 5.0 - 10.0 * i / pieces, 0.0));
    }
    return points;
  };
  fronts.points.push_back(line());
  for (const double turn : turns) {
    angle += turn;
    tip += step * Vec3(std::cos(angle), 0.0, std::sin(angle));
    fronts.points.push_back(line());
  }
  crack.front = fronts.points.back();
  fronts.normals.assign(crack.front.size(), Vec3(-std::sin(angle), 0.0, std::cos(angle)));
  crack.relief = std::make_shared<const mesh::NonPlanarCrackSurface>(std::move(fronts));
  return crack;
}

/// A circle of radius 1 in z = 0 that has grown by `step`, up or down by an angle that changes as
/// the cosine all round.
mesh::SolidCrack bent_penny(double step, double angle, double slow = 1.0) {
  constexpr int pieces = 120;
  mesh::SolidCrack crack;
  crack.net = base::NetId(0);
  crack.crack = base::CrackId(std::size_t{0});
  mesh::NonPlanarCrackSurface::PastAndPresentFronts fronts;
  fronts.points.resize(2);
  for (int i = 0; i < pieces; ++i) {
    const double phi = -2.0 * pi * i / pieces;
    const Vec3 m(std::cos(phi), std::sin(phi), 0.0);
    const double turn = angle * std::cos(phi);
    fronts.points[0].push_back(m);
    const double by = step * (slow + (1.0 - slow) * std::pow(std::cos(phi), 2));
    fronts.points[1].emplace_back(m + by * (std::cos(turn) * m + std::sin(turn) * Vec3::UnitZ()));
    fronts.normals.emplace_back(std::cos(turn) * Vec3::UnitZ() - std::sin(turn) * m);
  }
  crack.front = fronts.points[1];
  for (auto& line : fronts.points) {
    line.push_back(line.front());
  }
  fronts.normals.push_back(fronts.normals.front());
  crack.relief = std::make_shared<const mesh::NonPlanarCrackSurface>(std::move(fronts));
  return crack;
}

std::optional<mesh::CrackedMesh> insert(const model::Mesh& host, const mesh::SolidCrack& crack) {
  base::Diagnostics diagnostics;
  const std::vector<mesh::SolidCrack> cracks{crack};
  const std::vector<mesh::TubeMeshParameters> tubes(1);
  const std::vector<base::SourceSpan> spans(1);
  auto result = mesh::insert_solid_cracks(host, cracks, tubes, spans, diagnostics);
  for (const auto& d : diagnostics.messages()) {
    ADD_FAILURE() << d.code << " " << d.text << "; " << d.hint;
  }
  return result;
}

double area_of(const model::Mesh& mesh, const std::vector<model::Face>& sides) {
  double sum = 0.0;
  for (const model::Face& side : sides) {
    const auto nodes = test::nodes_of(mesh, side);
    const auto x = [&](std::size_t i) { return mesh.x[nodes[i].index()]; };
    const bool quad = nodes.size() == 8;
    sum += 0.5 * (x(1) - x(0)).cross(x(2) - x(0)).norm();
    sum += quad ? 0.5 * (x(2) - x(0)).cross(x(3) - x(0)).norm() : 0.0;
  }
  return sum;
}

void expect_crack(const model::Mesh& host, const mesh::SolidCrack& crack, double area,
                  const mesh::CrackedMesh& cracked) {
  EXPECT_TRUE(mesh::find_mesh_faults(cracked.mesh).bad.empty());
  EXPECT_NEAR(test::area(cracked.mesh), test::area(host), 1e-7 * test::area(host));
  const mesh::CrackFaceNodes& faces = cracked.faces[0];
  EXPECT_NEAR(area_of(cracked.mesh, faces.left_sides), area, 0.01 * area);
  EXPECT_NEAR(area_of(cracked.mesh, faces.right_sides), area, 0.01 * area);
  for (const base::NodeId n : faces.left) {
    EXPECT_NEAR(crack.relief->crack_height_over_plane(cracked.mesh.x[n.index()]), 0.0, 0.06)
        << cracked.mesh.x[n.index()].transpose();
  }
}

TEST(TurnedCracks, HeightsOfStrips) {
  const mesh::SolidCrack crack = bent_edge_crack(0.5, {0.5, -0.2});
  const mesh::NonPlanarCrackSurface& relief = *crack.relief;
  EXPECT_NEAR(relief.crack_height_over_plane({-2.0, 1.0, 0.3}), -0.3, 1e-12);
  EXPECT_NEAR(relief.crack_height_over_plane({0.2, 1.0, 0.0}), 0.2 * std::tan(0.5), 1e-12);
  const double x1 = 0.5 * std::cos(0.5);
  const double z1 = 0.5 * std::sin(0.5);
  EXPECT_NEAR(relief.crack_height_over_plane({x1 + 2.0, -1.0, 0.0}), z1 + 2.0 * std::tan(0.3),
              1e-12);
  EXPECT_NEAR(
      (relief.crack_height_gradient({x1 + 0.1, 0.7, 0.0}) - Vec3(std::tan(0.3), 0, 0)).norm(), 0.0,
      1e-12);
  EXPECT_NEAR(relief.distance_to_kink({0.0, 0.3, 0.1}, 0.4), 0.1, 0.02);
  EXPECT_NEAR(relief.narrowest_strip_width(), 0.5, 1e-9);
  // elsewhere it is the same
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const auto place = [&](const Vec3& x) { return Vec3(2.0 * (turn * x) + Vec3(1, 2, 3)); };
  const mesh::NonPlanarCrackSurface there =
      relief.transformed(place, [&](const Vec3& d) { return Vec3(turn * d); });
  for (const Vec3& x : {Vec3(0.2, 1.0, 0.4), Vec3(1.3, -2.0, 0.1), Vec3(-1.0, 0.0, 0.0)}) {
    EXPECT_NEAR(there.crack_height_over_plane(place(x)), 2.0 * relief.crack_height_over_plane(x),
                1e-9);
  }
}

class TurnedIn : public testing::TestWithParam<std::pair<ElementType, int>> {};

TEST_P(TurnedIn, ThroughACube) {
  const model::Mesh host = cube(GetParam().first, GetParam().second);
  for (const auto& turns :
       {std::vector{0.1}, {0.6}, {-0.9}, {0.5, -0.1}, {0.6, 0.1, -0.1, 0.05, 0.05}}) {
    SCOPED_TRACE(turns.size());
    const mesh::SolidCrack crack = bent_edge_crack(0.4, turns);
    const auto cracked = insert(host, crack);
    if (cracked) {
      expect_crack(host, crack, 8.0 * (4.0 + 0.4 * static_cast<double>(turns.size())), *cracked);
    }
  }
}

TEST_P(TurnedIn, WithinACube) {
  const model::Mesh host = cube(GetParam().first, GetParam().second);
  for (const double angle : {0.2, 0.9}) {
    const mesh::SolidCrack crack = bent_penny(0.2, angle);
    const auto cracked = insert(host, crack);
    if (cracked) {
      // of a strip 0.2 wide whose outer radius is 1 + 0.2 cos(angle cos(phi))
      const double area = pi + 0.4 * pi * (1.0 + 0.1 * std::cyl_bessel_j(0.0, angle));
      expect_crack(host, crack, area, *cracked);
    }
  }
}

TEST(TurnedCracks, TubesKeepAheadOfTheBend) {
  // As an inclined penny does: a fifth as far where it does not turn as where it turns most.
  const model::Mesh host = cube(ElementType::tet10, 7);
  const mesh::SolidCrack crack = bent_penny(0.1, 0.92, 0.19);
  const auto cracked = insert(host, crack);
  ASSERT_TRUE(cracked);
  const mesh::CrackFront& front = cracked->fronts.front();
  for (const mesh::FrontPoint& point : front.points) {
    const double bend = crack.relief->distance_to_kink(point.x, 0.04);
    EXPECT_LT(point.radius, 0.5 * bend + 1e-3);
    // m is straight on from the strip behind
    const Vec3 behind = point.x - 0.5 * point.radius * point.growth;
    EXPECT_NEAR(crack.relief->crack_height_over_plane(behind), 0.0, 0.02 * point.radius);
  }
}

TEST(TurnedCracks, AtAFace) {
  const model::Mesh host = cube(ElementType::tet10, 7);
  constexpr int pieces = 120;
  mesh::SolidCrack crack;
  crack.net = base::NetId(0);
  crack.crack = base::CrackId(std::size_t{0});
  crack.closed = false;
  mesh::NonPlanarCrackSurface::PastAndPresentFronts fronts;
  fronts.points.resize(2);
  for (int i = -12; i <= pieces + 12; ++i) {
    const double phi = pi - pi * i / pieces; // t = m x b runs clockwise
    const double u = std::clamp(phi, 0.0, pi);
    const Vec3 x(2.0 * std::cos(u), std::sin(u) - 4.0, 0.0);
    const Vec3 m = Vec3(std::cos(u), 2.0 * std::sin(u), 0.0).normalized();
    const double turn = 0.77 * std::cos(u);
    const double by = 0.1 + 0.033 * std::pow(std::cos(u), 2);
    const Vec3 beyond(0.0, phi < 0.0 ? phi : phi > pi ? pi - phi : 0.0, 0.0);
    fronts.points[0].push_back(x + beyond);
    fronts.points[1].push_back(x + beyond +
                               by * (std::cos(turn) * m + std::sin(turn) * Vec3::UnitZ()));
    fronts.normals.emplace_back(std::cos(turn) * Vec3::UnitZ() - std::sin(turn) * m);
  }
  crack.front = fronts.points[1];
  crack.relief = std::make_shared<const mesh::NonPlanarCrackSurface>(std::move(fronts));
  const auto cracked = insert(host, crack);
  ASSERT_TRUE(cracked);
  EXPECT_EQ(cracked->fronts.front().kind, mesh::CrackConfiguration::surface);
  // half of the ellipse and the strip before it
  double area = pi;
  for (int i = 0; i < 1000; ++i) {
    const double u = pi * (i + 0.5) / 1000;
    const double by = 0.1 + 0.033 * std::pow(std::cos(u), 2);
    area += by * std::hypot(2.0 * std::sin(u), std::cos(u)) * pi / 1000;
  }
  expect_crack(host, crack, area, *cracked);
}

INSTANTIATE_TEST_SUITE_P(Hosts, TurnedIn,
                         testing::Values(std::pair{ElementType::hexec20, 4},
                                         std::pair{ElementType::hexe8, 9},
                                         std::pair{ElementType::tet10, 5}));

} // namespace
} // namespace spricka::test_turned_cracks
