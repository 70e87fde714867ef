// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/heat.hpp"
#include "fe/thermal.hpp"
#include "mesh/cut/patch.hpp"
#include "mesh/cut/tip_mesh.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace spricka::test_heat {
namespace {

using base::OpCode;

constexpr base::ExpressionInstruction x{OpCode::x, 0.0};
constexpr base::ExpressionInstruction y{OpCode::y, 0.0};

base::ExpressionInstruction number(double v) {
  return {OpCode::number, v};
}

/// A plate of 4 x 4 with an oblique edge crack, left of x = 1.6 a set of its elements.
struct Plate {
  model::Model model;
  mesh::CrackedMesh cracked;

  Plate() {
    const base::NetId net(std::size_t{0});
    mesh::BlockSpec spec;
    spec.type = base::ElementType::quamc8;
    spec.size = {4.0, 4.0, 1.0};
    spec.nx = 10;
    spec.ny = 10;
    model.nets = {{"", {}}};
    mesh::generate_block(model.mesh, net, "", spec);
    model.materials = {{"M", 1000.0, 0.3, 0.0, 1e-3, {}}};
    model.properties = {{base::ElementSetId(std::size_t{0}),
                         base::MaterialId(std::size_t{0}),
                         model::StressState::plane_strain,
                         2.5,
                         {}}};
    model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(std::size_t{0}));
    model::ElementSet left{"LEFT", {}, {}};
    for (std::size_t e = 0; e < model.mesh.element_count(); ++e) {
      if (model.mesh.x[model.mesh.element_nodes(base::ElementId(e))[0].index()].x() < 1.6 - 1e-9) {
        left.elements.emplace_back(e);
      }
    }
    model.mesh.element_sets.push_back(left);
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
  }

  [[nodiscard]] fe::CaseTemperature heat(base::CompiledExpression T, std::size_t set) const {
    model::Load load;
    load.type = model::LoadType::temperature;
    load.elements = base::ElementSetId(set);
    load.value = {std::move(T)};
    return fe::make_case_temperature(
        model, {cracked.mesh, model.mesh, &cracked.host, {cracked.fronts.front().tip_point().node}},
        {"", {load}});
  }
  [[nodiscard]] std::size_t left() const { return model.mesh.element_sets.size() - 1; }

  /// Work of all nodal forces on a displacement that strains the plate by 1 in both directions,
  /// over thickness, beta and 2: the integral of the temperature.
  [[nodiscard]] double integral(const fe::CaseTemperature& heat) const {
    base::Vector f = fe::thermal_load(model, cracked.mesh, heat.temperature);
    fe::add_residual_temperature_load(model, cracked.mesh, {&heat, 1.0}, {}, f);
    double work = 0.0;
    for (std::size_t n = 0; n < cracked.mesh.node_count(); ++n) {
      work += f.segment<2>(2 * static_cast<Eigen::Index>(n)).dot(cracked.mesh.x[n].head<2>());
    }
    const double beta = 1e-3 * 1000.0 / (1.0 - 2.0 * 0.3);
    return work / (2.0 * beta * 2.5);
  }
};

TEST(Heat, ElementsTakeALinearTemperatureWhole) {
  const Plate plate;
  const fe::CaseTemperature heat =
      plate.heat({{number(3.0), x, {OpCode::multiply, 0.0}, y, {OpCode::subtract, 0.0}}}, 0);
  EXPECT_TRUE(heat.points.empty());
  EXPECT_NEAR(plate.integral(heat), (3.0 * 2.0 - 2.0) * 16.0, 1e-9);
}

// The rim runs through elements of the patch: each bears its share, to 1e-4 of an element.
TEST(Heat, AHeatedSetKeepsItsPlaceInAPatch) {
  const Plate plate;
  const fe::CaseTemperature heat =
      plate.heat(base::CompiledExpression::make_constant(7.0), plate.left());
  EXPECT_FALSE(heat.points.empty());
  EXPECT_NEAR(plate.integral(heat), 7.0 * 1.6 * 4.0, 7.0 * 1.6 * 4.0 * 1e-4);
}

TEST(Heat, AJumpInsideElementsIsIntegrated) {
  const Plate plate;
  const fe::CaseTemperature heat = plate.heat({{x, number(1.234), {OpCode::less, 0.0}}}, 0);
  EXPECT_NEAR(plate.integral(heat), 1.234 * 4.0, 1.234 * 4.0 * 1e-4);
}

// Over the elements round the tip, triangles with a corner there, the root has the integral
// 0.4 R(t)^2.5 by angle, R the distance of the opposite side.
TEST(Heat, TheRootOfTheDistanceFromATipIsSmooth) {
  const Plate plate;
  const mesh::CrackFront& front = plate.cracked.fronts.front();
  std::vector<base::ExpressionInstruction> code{x,
                                                number(front.tip_point().x.x()),
                                                {OpCode::subtract, 0.0},
                                                number(2.0),
                                                {OpCode::power, 0.0}};
  for (const base::ExpressionInstruction& i :
       {y, number(front.tip_point().x.y()), base::ExpressionInstruction{OpCode::subtract, 0.0},
        number(2.0), base::ExpressionInstruction{OpCode::power, 0.0},
        base::ExpressionInstruction{OpCode::add, 0.0}, number(0.25),
        base::ExpressionInstruction{OpCode::power, 0.0}}) {
    code.push_back(i);
  }
  const fe::CaseTemperature heat = plate.heat({code}, 0);
  const model::Mesh& mesh = plate.cracked.mesh;
  int found = 0;
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    const auto nodes = mesh.element_nodes(e);
    const auto at = std::ranges::find(nodes, front.tip_point().node);
    if (at == nodes.end() || mesh.type[i] != base::ElementType::trimc6) {
      continue;
    }
    const auto c = static_cast<std::size_t>(at - nodes.begin());
    const base::Vec3 a = mesh.x[nodes[(c + 1) % 3].index()] - front.tip_point().x;
    const base::Vec3 b = mesh.x[nodes[(c + 2) % 3].index()] - front.tip_point().x;
    const double height = a.cross(b).norm() / (b - a).norm();
    double exact = 0.0;
    constexpr int steps = 400;
    const double angle = std::acos(a.normalized().dot(b.normalized()));
    for (int k = 0; k < steps; ++k) { // middles: 1e-7 of a smooth function
      const double t = angle * (k + 0.5) / steps;
      const double sine = std::sin(std::acos(-a.normalized().dot((b - a).normalized())) + t);
      exact += 0.4 * std::pow(height / sine, 2.5) * angle / steps;
    }
    double sum = 0.0;
    const auto& element = shape::as_reference_element<shape::Trimc6>();
    const auto X = fe::element_coordinates(element, mesh, e);
    const fe::ConstitutiveLaw law = fe::constitutive_law(plate.model, mesh, e);
    const auto T = fe::gather_corner_temperatures(element, mesh, e, heat.temperature);
    for (const fe::ResidualTemperaturePoint& p : heat.residual_points_in_element(e)) {
      sum += p.area * (p.T + fe::projected_temperature(element, X, law, T, p.r));
    }
    EXPECT_NEAR(sum, exact, 2e-6 * exact);
    ++found;
  }
  EXPECT_GT(found, 10);
}

} // namespace
} // namespace spricka::test_heat
