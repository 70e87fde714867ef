// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"
#include "fe/dependence.hpp"
#include "mesh/boundary.hpp"
#include "mesh/generate/generate.hpp"
#include "mesh/tube/insert_solid.hpp"
#include "model/model.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

// Where the tetrahedra of a crack's patch meet a host of hexahedra or pentahedra: constant stresses
// pass through any plane faces, linear ones (whose displacements are quadratic) through
// parallelograms.
namespace spricka::fe::test_solid_joins {
namespace {

using base::ElementType;
using base::NodeId;
using base::Vec3;

constexpr double E = 1e3;
constexpr double nu = 0.3;

using Map = std::function<Vec3(const Vec3&)>;

/// A block with a penny in its middle, and what ties its patch to it.
struct Cracked {
  model::Model model;
  std::vector<Tie> ties;
  std::vector<base::ElementId> kept; ///< elements of the host that stay
  std::set<NodeId> surface;          ///< of the block
};

Cracked cracked_block(ElementType type, const Map& map) {
  Cracked made;
  made.model = test::plane_model(E, nu, model::StressState::solid);
  model::Mesh& host = made.model.mesh;
  host.dim = 3;
  mesh::BlockSpec spec;
  spec.type = type;
  spec.origin = Vec3::Constant(-4.0);
  spec.size = Vec3::Constant(8.0);
  spec.nx = spec.ny = spec.nz = 4;
  mesh::generate_solid_block(host, base::NetId(std::size_t{0}), "", spec);
  host.property.assign(host.element_count(), base::PropertyId(std::size_t{0}));
  std::ranges::transform(host.x, host.x.begin(), map);
  const auto skin = mesh::nodes_of_faces(host, mesh::boundary_faces(host));
  made.surface.insert(skin.begin(), skin.end());
  mesh::SolidCrack crack;
  crack.crack = base::CrackId(std::size_t{0});
  crack.net = base::NetId(std::size_t{0});
  crack.normal = Vec3::UnitZ();
  constexpr int points = 60;
  for (int i = 0; i < points; ++i) {
    const double t = -2.0 * std::numbers::pi * i / points;
    crack.front.emplace_back(Vec3(0.1, -0.2, 0.1) + 0.3 * Vec3(std::cos(t), std::sin(t), 0.0));
  }
  base::Diagnostics diagnostics;
  const std::vector<mesh::TubeMeshParameters> tubes(1);
  const std::vector<base::SourceSpan> spans(1);
  auto result = mesh::insert_solid_cracks(host, std::span(&crack, 1), tubes, spans, diagnostics);
  if (!result) {
    ADD_FAILURE() << diagnostics.messages().front().text;
    return made;
  }
  for (std::size_t e = 0; e < result->mesh.element_count(); ++e) {
    if (result->host[e].valid()) {
      made.kept.emplace_back(e);
    }
  }
  for (const mesh::HangingNodeTie& rim : result->ties) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto freedom = [&](NodeId n) { return static_cast<std::int32_t>(3 * n.index() + c); };
      Tie& tie = made.ties.emplace_back();
      tie.terms.push_back({freedom(rim.slave), 1.0});
      for (std::size_t i = 0; i < rim.master.size(); ++i) {
        tie.terms.push_back({freedom(rim.master[i]), -rim.weight[i]});
      }
    }
  }
  made.model.mesh = std::move(result->mesh);
  return made;
}

/// The largest force on nodes inside the block that elements of the host have, where displacements
/// are those of a field and nodes that follow others have handed their forces on; over the largest
/// force that one such element has on a node.
double force_left(const Cracked& cracked, const std::function<Vec3(const Vec3&)>& field) {
  const model::Mesh& mesh = cracked.model.mesh;
  const auto at = [](NodeId n) { return 3 * static_cast<Eigen::Index>(n.index()); };
  base::Vector u(3 * static_cast<Eigen::Index>(mesh.node_count()));
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    u.segment<3>(at(NodeId(n))) = field(mesh.x[n]);
  }
  const ConstraintTransformation ties(
      cracked.ties,
      std::vector<model::FreedomRole>(3 * mesh.node_count(), model::FreedomRole::local));
  ties.set_dependent_displacements(u, 1.0);
  base::Vector force = base::Vector::Zero(u.size());
  add_internal_force(cracked.model, mesh, test::every_element(mesh), u, force);
  base::Matrix left = force;
  ties.transfer_forces_to_masters(left);
  double scale = 0.0;
  double worst = 0.0;
  for (const base::ElementId e : cracked.kept) {
    base::Vector own = base::Vector::Zero(u.size());
    add_internal_force(cracked.model, mesh, std::span(&e, 1), u, own);
    scale = std::max(scale, own.cwiseAbs().maxCoeff());
    for (const NodeId n : mesh.element_nodes(e)) {
      if (!cracked.surface.contains(n)) {
        worst = std::max(worst, left.col(0).segment<3>(at(n)).norm());
      }
    }
  }
  return worst / scale;
}

/// A bar's displacements under s_xx = y, with x along the first axis of `turn`.
Vec3 bent(const Eigen::Matrix3d& turn, const Vec3& place) {
  const Vec3 x = turn.transpose() * place;
  return turn *
         Vec3(x.x() * x.y(), -0.5 * (x.x() * x.x() + nu * x.y() * x.y() - nu * x.z() * x.z()),
              -nu * x.y() * x.z()) /
         E;
}

Vec3 sheared(const Vec3& x) {
  return {x.x() + 0.2 * x.y(), x.y() + 0.1 * x.z(), x.z() - 0.15 * x.x()};
}

/// Plane faces, some of which are trapezia.
Vec3 tapered(const Vec3& x) {
  return {x.x() * (1.0 + 0.08 * x.y()), x.y(), x.z()};
}

class SolidJoins : public testing::TestWithParam<ElementType> {};

TEST_P(SolidJoins, LetLinearStressesPass) {
  const Cracked cracked = cracked_block(GetParam(), sheared);
  ASSERT_FALSE(cracked.ties.empty());
  const Eigen::Matrix3d odd = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (const Eigen::Matrix3d& turn : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), odd}) {
    EXPECT_LT(force_left(cracked, [&](const Vec3& x) { return bent(turn, x); }), 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(Hosts, SolidJoins,
                         testing::Values(ElementType::hexec20, ElementType::hexec27,
                                         ElementType::pentac15),
                         [](const auto& at) {
                           return std::string(base::element_info(at.param).name);
                         });

// Of hexahedra: diagonals of the pentahedra would become curves.
TEST(SolidJoinsOfHexahedra, LetConstantStressesPassTrapezia) {
  const Cracked cracked = cracked_block(ElementType::hexec20, tapered);
  ASSERT_FALSE(cracked.ties.empty());
  const auto stretched = [](const Vec3& x) { return Vec3(1e-3 * (x + Vec3::Constant(x.sum()))); };
  EXPECT_LT(force_left(cracked, stretched), 1e-11);
}

} // namespace
} // namespace spricka::fe::test_solid_joins
