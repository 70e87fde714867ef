// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/extension.hpp"
#include "crack/front_intensity.hpp"
#include "crack/tip_intensity.hpp"
#include "fe/assemble.hpp"
#include "mesh/cut/patch.hpp"
#include "mesh/cut/tip_mesh.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"
#include "solve/condense.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

// A first program on the library: K of an edge crack in a strip that is pulled at both ends. Read
// the test first; what it calls stands above it.
namespace spricka::test_first_solution {
namespace {

constexpr double W = 10.0; // width
constexpr double H = 30.0; // height
constexpr double a = 3.0;  // length of the crack
constexpr double stress = 100.0;

// Mesh, material and property; the mesh has sets BODY and, of faces, XMIN XMAX YMIN YMAX.
model::Model strip() {
  model::Model model;
  model.nets.emplace_back();
  mesh::BlockSpec block;
  block.size = {W, H, 0.0};
  block.nx = 10;
  block.ny = 30;
  mesh::generate_block(model.mesh, base::NetId(0), "", block);
  model::ElasticMaterial& steel = model.materials.emplace_back();
  steel.E = 210e3;
  steel.nu = 0.3;
  model::ElementProperty& sheet = model.properties.emplace_back();
  sheet.elements = base::ElementSetId(0);
  sheet.material = base::MaterialId(0);
  model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(0));
  return model;
}

// The mesh with a crack from the middle of the left side (manual, mesh.1 to 5).
mesh::CrackedMesh cut(const model::Mesh& whole) {
  mesh::CrackLine line;
  line.crack = base::CrackId(0);
  line.net = base::NetId(0);
  line.points = {{0.0, H / 2, 0.0}, {a, H / 2, 0.0}};
  const mesh::HostMesh host(whole);
  const mesh::TipMeshParameters sizes = mesh::choose_tip_mesh(host, line, nullptr);
  const base::SourceSpan no_card;
  base::Diagnostics diagnostics;
  auto cracked = mesh::insert_cracks(host, {&line, 1}, {&sizes, 1}, {&no_card, 1}, diagnostics);
  if (!cracked) {
    throw std::runtime_error(diagnostics.messages().front().text);
  }
  return std::move(*cracked);
}

// Stress on the upper and the lower side (fe.16).
model::LoadCase pull() {
  model::LoadCase both;
  for (const auto& [set, sign] : {std::pair<std::size_t, double>(2, -1.0), {3, 1.0}}) {
    model::Load& load = both.loads.emplace_back();
    load.type = model::LoadType::traction;
    load.faces = base::FaceSetId(set);
    load.value = {{{{base::OpCode::number, 0.0}}}, {{{base::OpCode::number, sign * stress}}}};
  }
  return both;
}

// The lower corners: what balances without supports is held against rigid motion only.
std::vector<model::FreedomRole> supports(const model::Mesh& mesh) {
  std::vector<model::FreedomRole> cls(2 * mesh.node_count(), model::FreedomRole::local);
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    const base::Vec3& x = mesh.x[n];
    if (x.norm() < 1e-9) {
      cls[2 * n] = cls[2 * n + 1] = model::FreedomRole::suppressed;
    } else if ((x - base::Vec3(W, 0.0, 0.0)).norm() < 1e-9) {
      cls[2 * n + 1] = model::FreedomRole::suppressed;
    }
  }
  return cls;
}

TEST(FirstSolution, EdgeCrackInAStrip) {
  const model::Model model = strip();
  const mesh::CrackedMesh cracked = cut(model.mesh);
  const model::Mesh& mesh = cracked.mesh;

  // K u = f on the freedoms w that the supports leave (fe.6, solve.3)
  const fe::Body body = fe::find_bodies(mesh).front();
  const fe::DofMap free = fe::number_freedoms(mesh, body.nodes, supports(mesh));
  const base::Vector f = fe::consistent_load_vector(model, mesh, pull());
  const solve::Condensation K(fe::assemble_stiffness(model, mesh, body.elements, {}, free), 0);
  ASSERT_EQ(K.report().status, solve::FactorStatus::ok);
  const base::Matrix w = K.recover(base::Matrix(0, 1), f(free.freedom));
  base::Vector u = base::Vector::Zero(f.size());
  u(free.freedom) = w.col(0);

  // K1 and K2 by virtual extension of the crack, the mean over rings 2 to 5 (crack.11)
  const mesh::CrackFront& front = cracked.fronts.front();
  std::vector<int> left_out;
  const std::vector<crack::VirtualExtensionField> q =
      crack::TipNeighbourhood(mesh).extension_fields(cracked, front, {2, 3, 4, 5}, left_out);
  const crack::StressIntensity at_tip =
      crack::front_intensity(model, cracked, front, crack::wrap_tip_domains(q), {}, u, {}).front();

  // Tada, Paris and Irwin 2000, half a per cent off at most; the mesh adds a tenth
  const double c = std::numbers::pi * a / (2.0 * W);
  const double F = std::sqrt(std::tan(c) / c) / std::cos(c) *
                   (0.752 + 2.02 * a / W + 0.37 * std::pow(1.0 - std::sin(c), 3));
  EXPECT_NEAR(at_tip.K1 / (stress * std::sqrt(std::numbers::pi * a)), F, 0.006 * F);
  EXPECT_NEAR(at_tip.K2, 0.0, 2e-3 * at_tip.K1);
  EXPECT_NEAR(at_tip.G, at_tip.G_from_K, 2e-3 * at_tip.G);
}

} // namespace
} // namespace spricka::test_first_solution
