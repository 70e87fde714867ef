// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/stress.hpp"
#include "model/model.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Patch tests (K01): a linear displacement gives constant stress in any mesh. E = 1e6, nu = 0.25,
// u = 1e-3 (x + y/2), v = 1e-3 (y + x/2), so that in plane stress sxx = syy = 4000/3, sxy = 400.
namespace spricka::fe::test_patch {
namespace {

using base::ElementType;
using base::Vec2;
using base::Vec3;
using test::Cells;

constexpr double E = 1e6;
constexpr double nu = 0.25;

enum class Transposition { straight, curved_inside, quarter_point };

struct Case {
  ElementType type;
  Transposition form;
  model::StressState state;
};

std::string case_name(const testing::TestParamInfo<Case>& info) {
  const char* form = info.param.form == Transposition::straight        ? "_straight"
                     : info.param.form == Transposition::curved_inside ? "_curved"
                                                                       : "_quarter_point";
  const char* state = info.param.state == model::StressState::plane_stress ? "_stress" : "_strain";
  return std::string(base::element_info(info.param.type).name) + form + state;
}

std::vector<Case> every_case() {
  std::vector<Case> cases;
  for (const model::StressState state :
       {model::StressState::plane_stress, model::StressState::plane_strain}) {
    for (const ElementType type : {ElementType::trim3, ElementType::quam4, ElementType::trimc6,
                                   ElementType::quamc8, ElementType::quamc9}) {
      cases.push_back({type, Transposition::straight, state});
      if (base::element_info(type).quadratic) {
        cases.push_back({type, Transposition::curved_inside, state});
        cases.push_back({type, Transposition::quarter_point, state});
      }
    }
  }
  return cases;
}

bool on_rim(const Vec3& x) {
  return std::min({x.x(), x.y(), 1.0 - x.x(), 1.0 - x.y()}) < 1e-12;
}

model::Mesh patch_mesh(const Case& c) {
  if (c.form == Transposition::quarter_point) {
    Cells grid = test::unit_grid(2, 2);
    grid.points[4] = Vec2(0.42, 0.55);
    model::Mesh mesh = test::make_mesh(c.type, grid);
    test::make_quarter_points(mesh, base::NodeId(4));
    return mesh;
  }
  model::Mesh mesh = test::make_mesh(c.type, test::macneal_harder());
  if (c.form == Transposition::curved_inside) {
    for (std::size_t n = 8; n < mesh.node_count(); ++n) {
      if (!on_rim(mesh.x[n])) {
        const auto k = static_cast<double>(n);
        mesh.x[n] += 0.03 * Vec3(std::sin(3.0 * k), std::cos(5.0 * k), 0.0);
      }
    }
  }
  return mesh;
}

class Patch : public testing::TestWithParam<Case> {
protected:
  Patch() : model(test::plane_model(E, nu, GetParam().state, 0.5)) {
    model.mesh = patch_mesh(GetParam());
    // Both normal strains are 1e-3, gamma is 1e-3.
    const bool stress = GetParam().state == model::StressState::plane_stress;
    const double s = 1e-3 * E / (stress ? 1.0 - nu : (1.0 + nu) * (1.0 - 2.0 * nu));
    expected << s, s, stress ? 0.0 : 2.0 * nu * s, 1e-3 * E / (2.0 * (1.0 + nu)), 0.0, 0.0;
  }

  void expect_constant_stress(const base::Vector& u) const {
    const std::vector<Stress> stress = element_node_stress(model, model.mesh, u);
    for (const Stress& s : stress) {
      EXPECT_LT((s - expected).cwiseAbs().maxCoeff(), 1e-10 * expected[0]);
    }
    for (const Stress& s : nodal_stress(model, model.mesh, stress)) {
      EXPECT_LT((s - expected).cwiseAbs().maxCoeff(), 1e-10 * expected[0]);
    }
    // Energy: 1/2 sigma : eps times the volume 0.5.
    const double energy = 0.5 * 0.5 * 1e-3 * (2.0 * expected[0] + expected[3]);
    EXPECT_NEAR(strain_energy(model, model.mesh, test::every_element(model.mesh), u), energy,
                1e-11 * energy);
  }

  model::Model model;
  Stress expected;
};

INSTANTIATE_TEST_SUITE_P(K01, Patch, testing::ValuesIn(every_case()), case_name);

TEST_P(Patch, prescribed_rim) {
  test::set_freedom(model, model::FreedomRole::prescribed, on_rim, true, true);
  model::Load load;
  load.type = model::LoadType::displacement;
  load.nodes = test::node_set(model, on_rim);
  load.value = {test::linear(0.0, 1e-3, 0.5e-3), test::linear(0.0, 0.5e-3, 1e-3)};
  base::Vector reaction;
  const base::Vector u = test::solve(model, {"", {load}}, &reaction);
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    const Vec3& x = model.mesh.x[n];
    const auto row = 2 * static_cast<Eigen::Index>(n);
    EXPECT_NEAR(u[row], 1e-3 * (x.x() + 0.5 * x.y()), 1e-15);
    EXPECT_NEAR(u[row + 1], 1e-3 * (x.y() + 0.5 * x.x()), 1e-15);
    if (!on_rim(x)) {
      EXPECT_LT(reaction.segment<2>(row).norm(), 1e-11 * expected[0]);
    }
  }
  expect_constant_stress(u);
}

TEST_P(Patch, tractions_on_the_rim) {
  const auto corner = [](double x, double y) {
    return [x, y](const Vec3& p) { return (p - Vec3(x, y, 0.0)).norm() < 1e-12; };
  };
  test::set_freedom(model, model::FreedomRole::suppressed, corner(0.0, 0.0), true, true);
  test::set_freedom(model, model::FreedomRole::suppressed, corner(1.0, 0.0), false, true);
  model::LoadCase load_case;
  for (const Vec2& n : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
    model::Load load;
    load.type = model::LoadType::traction;
    load.faces = test::face_set(model, [&](const Vec3& x) {
      return std::abs(n.dot(x.head<2>()) - std::max(n.sum(), 0.0)) < 1e-12;
    });
    load.value = {
        base::CompiledExpression::make_constant(expected[0] * n.x() + expected[3] * n.y()),
        base::CompiledExpression::make_constant(expected[3] * n.x() + expected[1] * n.y())};
    load_case.loads.push_back(load);
  }
  expect_constant_stress(test::solve(model, load_case));
}

} // namespace
} // namespace spricka::fe::test_patch
