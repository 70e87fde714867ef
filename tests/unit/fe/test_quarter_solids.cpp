// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/element.hpp"
#include "fe/stress.hpp"
#include "mesh/generate/generate.hpp"
#include "mesh/quality.hpp"
#include "model/model.hpp"
#include "shape/topology.hpp"
#include "tests/unit/fe/field.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Solids with mid nodes at quarter points, the elements of crack fronts: K01 and K02 hold for them
// too, round a single node and along a line of nodes.
namespace spricka::fe::test_quarter_solids {
namespace {

using base::ElementType;
using base::NodeId;
using base::Vec3;

constexpr double E = 1e6;
constexpr double nu = 0.25;

enum class Tip { point, front };

struct Case {
  ElementType type;
  Tip tip;
};

// Edges that end at one tip node have their mid nodes next to it; edges of the front itself keep
// theirs.
void make_quarter_points(model::Mesh& mesh, const std::vector<bool>& tip) {
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(base::ElementId(e));
    const int corners = base::element_info(mesh.type[e]).corners;
    for (int m = 0; m < shape::edge_count(mesh.type[e]); ++m) {
      const auto [a, b] = shape::edge_corners(mesh.type[e], m);
      const NodeId p = nodes[static_cast<std::size_t>(a)];
      const NodeId q = nodes[static_cast<std::size_t>(b)];
      if (tip[p.index()] != tip[q.index()]) {
        const Vec3& near = mesh.x[tip[p.index()] ? p.index() : q.index()];
        const Vec3& far = mesh.x[tip[p.index()] ? q.index() : p.index()];
        mesh.x[nodes[static_cast<std::size_t>(corners + m)].index()] = 0.75 * near + 0.25 * far;
      }
    }
  }
}

// A cube of 2 x 2 x 2 cells whose inner node, or inner line of nodes, is the tip.
model::Model quarter_cube(const Case& c) {
  model::Model model = test::plane_model(E, nu, model::StressState::solid);
  model::Mesh& mesh = model.mesh;
  mesh.dim = 3;
  mesh::BlockSpec spec;
  spec.type = c.type;
  spec.nx = spec.ny = spec.nz = 2;
  mesh::generate_solid_block(mesh, base::NetId(0), "", spec);
  mesh.property.assign(mesh.element_count(), base::PropertyId(0));
  model::NodeSet rim;
  std::vector<bool> tip(mesh.node_count());
  const Vec3 middle(0.5, 0.5, 0.5);
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    const Vec3& x = mesh.x[n];
    if (std::min(x.minCoeff(), (1.0 - x.array()).minCoeff()) < 1e-9) {
      rim.nodes.emplace_back(n);
    }
    const Vec3 off = x - middle;
    tip[n] = c.tip == Tip::point ? off.norm() < 1e-9 : off.head<2>().norm() < 1e-9;
  }
  make_quarter_points(mesh, tip);
  for (Vec3& x : mesh.x) { // no longer a cube, but every edge as straight as it was
    x = Vec3(x.x() + 0.2 * x.y(), x.y() + 0.1 * x.z(), x.z() - 0.15 * x.x());
  }
  mesh.node_sets.push_back(rim);
  return model;
}

class QuarterSolids : public testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(K01, QuarterSolids,
                         testing::Values(Case{ElementType::tet10, Tip::point},
                                         Case{ElementType::tet10, Tip::front},
                                         Case{ElementType::pentac15, Tip::point},
                                         Case{ElementType::pentac15, Tip::front},
                                         Case{ElementType::hexec20, Tip::point},
                                         Case{ElementType::hexec20, Tip::front}),
                         [](const auto& c) {
                           return std::string(base::element_info(c.param.type).name) +
                                  (c.param.tip == Tip::point ? "_point" : "_front");
                         });

TEST_P(QuarterSolids, are_accepted) {
  const mesh::MeshFaults faults = mesh::find_mesh_faults(quarter_cube(GetParam()).mesh);
  EXPECT_TRUE(faults.bad.empty());
  EXPECT_TRUE(faults.corners.empty());
}

// u = 1e-3 (2x+y+z, x+2y+z, x+y+2z)/2 on the rim: s = 2000, t = 400 everywhere, at the tip too.
TEST_P(QuarterSolids, pass_constant_strain) {
  model::Model model = quarter_cube(GetParam());
  model::NodeSetFreedomRole held;
  held.cls = model::FreedomRole::prescribed;
  held.dof = {true, true, true};
  held.nodes = base::NodeSetId(model.mesh.node_sets.size() - 1);
  model.freedoms.push_back(held);
  model::Load move;
  move.type = model::LoadType::displacement;
  move.nodes = held.nodes;
  const test::CardField sum = test::x_field + test::y_field + test::CardField{base::OpCode::z};
  for (const test::CardField& x :
       {test::x_field, test::y_field, test::CardField{base::OpCode::z}}) {
    move.value.push_back((test::CardField(0.5e-3) * (sum + x)).code);
  }
  base::Vector reaction;
  const base::Vector u = test::solve(model, {"", {move}}, &reaction);
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    const Vec3& x = model.mesh.x[n];
    const Vec3 wanted = 0.5e-3 * (x + Vec3::Constant(x.sum()));
    EXPECT_LT((u.segment<3>(3 * static_cast<Eigen::Index>(n)) - wanted).norm(), 1e-14) << n;
  }
  Stress expected;
  expected << 2000.0, 2000.0, 2000.0, 400.0, 400.0, 400.0;
  for (const Stress& s : element_node_stress(model, model.mesh, u)) {
    EXPECT_LT((s - expected).cwiseAbs().maxCoeff(), 1e-10 * 2000.0);
  }
  const double energy = 0.5 * 1e-3 * (3.0 * 2000.0 + 3.0 * 400.0) *
                        (1.0 + 0.2 * 0.1 * -0.15); // volume: the determinant of the shear
  EXPECT_NEAR(strain_energy(model, model.mesh, test::every_element(model.mesh), u), energy,
              1e-11 * energy);
}

// Every element round the tip has the six rigid modes and no other.
TEST_P(QuarterSolids, have_six_rigid_modes_and_no_other_zero) {
  const model::Model model = quarter_cube(GetParam());
  for (const double ratio : {0.3, 0.4999}) {
    model::ElasticMaterial material = model.materials[0];
    material.nu = ratio;
    const ConstitutiveLaw law = constitutive_law(material, model.properties[0], GetParam().type);
    for_shape_blocks(model.mesh, test::every_element(model.mesh),
                     [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
                       for (const base::ElementId e : block) {
                         const Eigen::MatrixXd K =
                             element_stiffness<S>(element_coordinates<S>(model.mesh, e), law);
                         const Eigen::VectorXd values =
                             Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
                         const double largest = values[values.size() - 1];
                         EXPECT_EQ((values.array().abs() < 1e-10 * largest).count(), 6)
                             << e.index();
                         EXPECT_GT(values[0], -1e-12 * largest);
                         EXPECT_GT(values[6], 1e-8 * largest) << "clear of the rigid ones";
                       }
                     });
  }
}

} // namespace
} // namespace spricka::fe::test_quarter_solids
