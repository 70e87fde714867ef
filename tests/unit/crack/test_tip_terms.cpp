// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/finite_shift.hpp"
#include "crack/front_intensity.hpp"
#include "crack/front_rows.hpp"
#include "crack/tip_intensity.hpp"
#include "mesh/cut/graft.hpp"
#include "mesh/cut/patch.hpp"
#include "mesh/cut/tip_mesh.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace spricka::test_tip_terms {
namespace {

using base::OpCode;

const base::ExpressionInstruction x{OpCode::x, 0.0};
const base::ExpressionInstruction y{OpCode::y, 0.0};
const base::ExpressionInstruction plus{OpCode::add, 0.0};
const base::ExpressionInstruction times{OpCode::multiply, 0.0};
base::ExpressionInstruction number(double v) {
  return {OpCode::number, v};
}

/// 1 + a x + b y + c x y, as the deck would give it.
base::CompiledExpression field(double a, double b, double c) {
  return {{number(1.0), number(a), x, times, plus, number(b), y, times, plus, number(c), x, y,
           times, times, plus}};
}

/// A plate with an oblique edge crack, its patch and rough displacements: the derivative of the
/// energy must be right for any.
struct Plate {
  model::Model model;
  mesh::CrackedMesh cracked;
  mesh::CrackFaceSides crack_faces;
  std::vector<crack::VirtualExtensionField> fields;
  base::Vector u;

  explicit Plate(model::StressState state) {
    const base::NetId net(std::size_t{0});
    mesh::BlockSpec spec;
    spec.type = base::ElementType::quamc8;
    spec.size = {4.0, 4.0, 1.0};
    spec.nx = 10;
    spec.ny = 10;
    model.nets = {{"", {}}};
    mesh::generate_block(model.mesh, net, "", spec);
    model.materials = {{"M", 1000.0, 0.3, 0.0, 1e-3, {}}};
    model.properties = {
        {base::ElementSetId(std::size_t{0}), base::MaterialId(std::size_t{0}), state, 2.5, {}}};
    model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(std::size_t{0}));
    mesh::CrackLine line;
    line.crack = base::CrackId(std::size_t{0});
    line.net = net;
    line.points = {{0.0, 2.0, 0.0}, {1.5, 2.4, 0.0}};
    base::Diagnostics diagnostics;
    const std::vector<mesh::TipMeshParameters> tips{
        mesh::choose_tip_mesh(model.mesh, line, nullptr)};
    cracked = mesh::insert_cracks(model.mesh, {&line, 1}, tips, std::vector<base::SourceSpan>(1),
                                  diagnostics)
                  .value();
    crack_faces = mesh::crack_face_sides(cracked.mesh, cracked.faces.front());
    std::vector<int> left_out;
    fields =
        crack::TipNeighbourhood(cracked.mesh).extension_fields(cracked, front(), {2, 4}, left_out);
    u.resize(2 * static_cast<Eigen::Index>(cracked.mesh.node_count()));
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      u[i] = std::sin(1.7 * static_cast<double>(i * i % 97));
    }
  }
  [[nodiscard]] const mesh::CrackFront& front() const { return cracked.fronts.front(); }
  [[nodiscard]] std::vector<base::ElementId> all() const {
    std::vector<base::ElementId> elements;
    for (std::size_t e = 0; e < cracked.mesh.element_count(); ++e) {
      elements.emplace_back(e);
    }
    return elements;
  }
};

enum class What { body, pressure, traction, temperature };

model::Load load_of(What what) {
  model::Load load;
  switch (what) {
  case What::body:
    load.type = model::LoadType::body;
    load.value = {field(2.0, -1.0, 0.7), field(-0.5, 3.0, 1.1)};
    break;
  case What::pressure:
    load.type = model::LoadType::pressure;
    load.value = {field(0.8, 0.3, -0.4)};
    break;
  case What::traction:
    load.type = model::LoadType::traction;
    load.value = {field(0.4, -0.3, 0.9), field(1.4, 0.2, 0.1)};
    break;
  case What::temperature:
    load.type = model::LoadType::temperature;
    load.value = {field(0.6, -1.3, 0.0)};
    break;
  }
  return load;
}

/// The load on all that it can act on; of tractions only one crack face, which leaves a force at
/// the tip.
crack::FrontLoads acting(const Plate& plate, const model::Load& load, double factor) {
  crack::ActingLoad a{&load, factor, {}, {}};
  if (load.type == model::LoadType::pressure || load.type == model::LoadType::traction) {
    a.faces = plate.crack_faces.left;
    if (load.type == model::LoadType::pressure) {
      a.faces.insert(a.faces.end(), plate.crack_faces.right.begin(), plate.crack_faces.right.end());
    }
  } else {
    a.elements = plate.all();
  }
  crack::FrontLoads loads{{a}, {}};
  if (load.type == model::LoadType::temperature) {
    loads.temperature =
        base::Vector::Zero(static_cast<Eigen::Index>(plate.cracked.mesh.nodes.size()));
    for (std::size_t e = 0; e < plate.cracked.mesh.element_count(); ++e) {
      const auto nodes = plate.cracked.mesh.element_nodes(base::ElementId(e));
      const int corners = base::element_info(plate.cracked.mesh.type[e]).corners;
      for (int i = 0; i < corners; ++i) { // linear: what the projection finds
        loads.temperature[plate.cracked.mesh.first[e] + i] =
            factor *
            load.value[0](plate.cracked.mesh.x[nodes[static_cast<std::size_t>(i)].index()]);
      }
    }
  }
  return loads;
}

class TipTerm : public testing::TestWithParam<std::tuple<model::StressState, What>> {};

// G against the energy itself, differenced on both sides: with every load, also with one whose
// force at the tip is not balanced by the other crack face's.
TEST_P(TipTerm, IsTheDerivativeOfTheEnergy) {
  const auto [state, what] = GetParam();
  const Plate plate(state);
  const model::Load load = load_of(what);
  const crack::FrontLoads loads = acting(plate, load, 1e3);
  const crack::TipContext set =
      crack::make_tip_context(plate.model, plate.cracked, plate.front(), plate.fields, loads);
  const crack::FrontLoads none;
  const crack::TipContext unloaded =
      crack::make_tip_context(plate.model, plate.cracked, plate.front(), plate.fields, none);
  ASSERT_EQ(plate.fields.size(), 2U);
  for (const crack::VirtualExtensionField& f : plate.fields) {
    const crack::StressIntensity K =
        crack::front_intensity(plate.model, plate.cracked, plate.front(),
                               crack::wrap_tip_domains({f}), {}, plate.u, loads)
            .front();
    const crack::StressIntensity bare =
        crack::front_intensity(plate.model, plate.cracked, plate.front(),
                               crack::wrap_tip_domains({f}), {}, plate.u, {})
            .front();
    // The stiffness itself takes fewer points than G: what it misses is no matter of the loads, but
    // for elements that expand freely.
    const double s = 1e-4 * plate.front().size;
    const double difference = crack::finite_shift_release_rate(set, f, s, plate.u) -
                              crack::finite_shift_release_rate(unloaded, f, s, plate.u);
    EXPECT_NEAR(K.G - bare.G, difference,
                (what == What::temperature ? 2e-4 : 1e-6) * std::abs(K.G - bare.G));
    EXPECT_GT(std::abs(K.G - bare.G), 1e-4 * std::abs(bare.G)); // the term is there
  }
}

// K1 and K2 are their rows times u and what the loads add at u = 0.
TEST_P(TipTerm, IsTheConstantOfK) {
  const auto [state, what] = GetParam();
  const Plate plate(state);
  const model::Load load = load_of(what);
  const crack::FrontLoads loads = acting(plate, load, 1e3);
  const auto& [model, cracked, crack_faces, fields, u] = plate;
  for (const model::CrackTipPlaneState wish :
       {model::CrackTipPlaneState::automatic, model::CrackTipPlaneState::stress}) {
    crack::FrontIntensityOptions request;
    request.state = wish;
    const crack::StressIntensity K =
        crack::front_intensity(model, cracked, plate.front(), crack::wrap_tip_domains(fields),
                               request, u, loads)
            .front();
    const base::Matrix rows = crack::front_intensity_functionals(
        model, cracked, plate.front(), crack::wrap_tip_domains(fields), wish);
    const crack::StressIntensity c =
        crack::front_intensity(model, cracked, plate.front(), crack::wrap_tip_domains(fields),
                               request, base::Vector::Zero(u.size()), loads)
            .front();
    const double size = rows.cwiseAbs().transpose().row(0).dot(u.cwiseAbs());
    EXPECT_NEAR(rows.col(0).dot(u) + c.K1, K.K1, 1e-12 * size);
    EXPECT_NEAR(rows.col(1).dot(u) + c.K2, K.K2, 1e-12 * size);
    EXPECT_GT(std::abs(c.K1), 0.0);
  }
}

std::string name_of(const testing::TestParamInfo<std::tuple<model::StressState, What>>& info) {
  const auto [state, what] = info.param;
  const std::string names[] = {"Body", "Pressure", "Traction", "Temperature"};
  return names[static_cast<std::size_t>(what)] +
         (state == model::StressState::plane_stress ? "Stress" : "Strain");
}

INSTANTIATE_TEST_SUITE_P(Loads, TipTerm,
                         testing::Combine(testing::Values(model::StressState::plane_stress,
                                                          model::StressState::plane_strain),
                                          testing::Values(What::body, What::pressure,
                                                          What::traction, What::temperature)),
                         name_of);

// Crack faces of the plate: as many sides on each, opposite each other, ending at the tip.
TEST(CrackFaceSides, LieOppositeEachOther) {
  const Plate plate(model::StressState::plane_stress);
  ASSERT_EQ(plate.crack_faces.left.size(), plate.crack_faces.right.size());
  EXPECT_EQ(2 * plate.crack_faces.left.size() + 1, plate.cracked.faces.front().left.size());
  double length = 0.0;
  for (const model::Face& face : plate.crack_faces.left) {
    const auto nodes = plate.cracked.mesh.element_nodes(face.element);
    const auto corners = static_cast<std::size_t>(
        base::element_info(plate.cracked.mesh.type[face.element.index()]).corners);
    const auto i = static_cast<std::size_t>(face.side);
    const base::Vec3 d = plate.cracked.mesh.x[nodes[(i + 1) % corners].index()] -
                         plate.cracked.mesh.x[nodes[i].index()];
    EXPECT_GT(d.dot(plate.front().tip_point().growth),
              0.0); // the body on its left, towards the tip
    length += d.norm();
  }
  EXPECT_NEAR(length, std::hypot(1.5, 0.4), 1e-12);
}

} // namespace
} // namespace spricka::test_tip_terms
