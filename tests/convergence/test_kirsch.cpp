// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/stress.hpp"
#include "model/model.hpp"
#include "tests/convergence/error_norm.hpp"
#include "tests/unit/fe/field.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// K08: a round hole (R = 1) in a plate under tension 1 along x, a quarter of it.
namespace spricka::test::test_kirsch {
namespace {

using base::ElementType;

constexpr double E = 1.0;
constexpr double nu = 0.3;

// From the hole to a box of width a and height b: rays through the corner of the box at 45 deg of
// the hole.
Map plate(double a, double b) {
  return [=](const Vec2& p) {
    const double angle = 0.5 * std::numbers::pi * (1.0 - p.x());
    const Vec2 hole(std::cos(angle), std::sin(angle));
    const Vec2 box = p.x() > 0.5 ? Vec2(a, 2.0 * (1.0 - p.x()) * b) : Vec2(2.0 * p.x() * a, b);
    return Vec2((1.0 - p.y()) * hole + p.y() * box);
  };
}

// Layers denser towards the hole.
model::Model quarter_plate(ElementType type, int n, const Map& map) {
  model::Model model = plane_model(E, nu, model::StressState::plane_stress);
  model.mesh = make_mesh(
      type, unit_grid(n, n, [](const Vec2& p) { return Vec2(p.x(), p.y() * p.y()); }), map);
  const auto x_axis = [](const Vec3& x) { return std::abs(x.y()) < 1e-12; };
  const auto y_axis = [](const Vec3& x) { return std::abs(x.x()) < 1e-12; };
  set_freedom(model, model::FreedomRole::suppressed, y_axis, true, false);
  set_freedom(model, model::FreedomRole::suppressed, x_axis, false, true);
  return model;
}

// Source: Kirsch 1898 (Timoshenko, Goodier art. 35), in Cartesian components.
struct Kirsch {
  CardField c2 = cos(2.0 * theta_field);
  CardField c4 = cos(4.0 * theta_field);
  CardField s2 = sin(2.0 * theta_field);
  CardField s4 = sin(4.0 * theta_field);
  CardField q = 1.0 / (rho_field * rho_field);
  CardField xx = 1.0 - q * (1.5 * c2 + c4) + 1.5 * q * q * c4;
  CardField yy = 0.0 - q * (0.5 * c2 - c4) - 1.5 * q * q * c4;
  CardField xy = 0.0 - q * (0.5 * s2 + s4) + 1.5 * q * q * s4;
};

base::Vector solve_infinite(model::Model& model) {
  const Kirsch exact;
  model::Load right;
  right.type = model::LoadType::traction;
  right.faces = face_set(model, [](const Vec3& x) { return std::abs(x.x() - 4.0) < 1e-12; });
  right.value = {exact.xx.code, exact.xy.code};
  model::Load top = right;
  top.faces = face_set(model, [](const Vec3& x) { return std::abs(x.y() - 4.0) < 1e-12; });
  top.value = {exact.xy.code, exact.yy.code};
  return solve(model, {"", {right, top}});
}

// The gradient that goes with the exact stresses; rotations are left out, as strains need none.
Exact exact_strains() {
  return {[](const Vec2&) { return Vec2(Vec2::Zero()); },
          [k = Kirsch()](const Vec2& p) {
            const Vec3 x(p.x(), p.y(), 0.0);
            const double xx = k.xx.code(x);
            const double yy = k.yy.code(x);
            const double shear = (1.0 + nu) / E * k.xy.code(x);
            Eigen::Matrix2d H;
            H << (xx - nu * yy) / E, shear, shear, (yy - nu * xx) / E;
            return H;
          }};
}

class Kirsch2 : public testing::TestWithParam<ElementType> {};
INSTANTIATE_TEST_SUITE_P(
    K08, Kirsch2, testing::Values(ElementType::trimc6, ElementType::quamc8, ElementType::quamc9),
    [](const auto& c) { return std::string(base::element_info(c.param).name); });

TEST_P(Kirsch2, energy_converges_quadratically_on_the_curved_hole) {
  std::vector<double> errors;
  for (const int n : {8, 16, 32}) {
    model::Model model = quarter_plate(GetParam(), n, plate(4.0, 4.0));
    const base::Vector u = solve_infinite(model);
    errors.push_back(error_norms(model, u, exact_strains()).energy);
  }
  EXPECT_NEAR(slope(errors), 2.0, 0.1);
  // The energy of the unit stress on the quarter box is near 16.
  EXPECT_LT(errors.back(), 1e-3 * 4.0);
}

TEST_P(Kirsch2, stress_concentration_is_three) {
  model::Model model = quarter_plate(GetParam(), 32, plate(4.0, 4.0));
  const base::Vector u = solve_infinite(model);
  const auto top = fe::stress_at_body_point(model, model.mesh, u, Vec3(0.0, 1.0, 0.0));
  const auto side = fe::stress_at_body_point(model, model.mesh, u, Vec3(1.0, 0.0, 0.0));
  ASSERT_TRUE(top && side);
  EXPECT_NEAR((*top)[0], 3.0, 1e-3 * 3.0);
  EXPECT_NEAR((*side)[1], -1.0, 2e-3);
}

// Finite strip, here turned so that it is pulled along x: width R/W = 0.2, half length 3 W.
TEST_P(Kirsch2, strip) {
  model::Model model = quarter_plate(GetParam(), 40, plate(15.0, 5.0));
  model::Load end;
  end.type = model::LoadType::traction;
  end.faces = face_set(model, [](const Vec3& x) { return std::abs(x.x() - 15.0) < 1e-12; });
  end.value = {base::CompiledExpression::make_constant(1.0)};
  const base::Vector u = solve(model, {"", {end}});
  const auto top = fe::stress_at_body_point(model, model.mesh, u, Vec3(0.0, 1.0, 0.0));
  const auto side = fe::stress_at_body_point(model, model.mesh, u, Vec3(1.0, 0.0, 0.0));
  ASSERT_TRUE(top && side);
  EXPECT_NEAR((*top)[0], 3.152571, 1e-3 * 3.152571);
  EXPECT_NEAR((*side)[1], -1.118863, 2e-3 * 1.118863);
}

} // namespace
} // namespace spricka::test::test_kirsch
