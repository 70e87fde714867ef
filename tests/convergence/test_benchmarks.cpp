// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/stress.hpp"
#include "model/model.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Problems whose answers are known to many digits: references recomputed to convergence (Cook, LE1)
// or closed forms (thick cylinder).
namespace spricka::test::test_benchmarks {
namespace {

using base::CompiledExpression;
using base::ElementType;
using model::FreedomRole;
using model::StressState;

double grade(double t, double power) {
  return std::pow(t, power);
}

// Denser at both ends.
double grade_ends(double t, double power) {
  return t < 0.5 ? 0.5 * grade(2.0 * t, power) : 1.0 - 0.5 * grade(2.0 * (1.0 - t), power);
}

Vec2 displacement_at(const model::Mesh& mesh, const base::Vector& u, const Vec3& x) {
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if ((mesh.x[n] - x).norm() < 1e-9) {
      return u.segment<2>(2 * static_cast<Eigen::Index>(n));
    }
  }
  ADD_FAILURE() << "no node at " << x.transpose();
  return Vec2::Zero();
}

class Quadratics : public testing::TestWithParam<ElementType> {};
INSTANTIATE_TEST_SUITE_P(convergence, Quadratics,
                         testing::Values(ElementType::trimc6, ElementType::quamc8,
                                         ElementType::quamc9),
                         [](const auto& c) {
                           return std::string(base::element_info(c.param).name);
                         });

// K07 Cook's membrane: clamped on the left, where the corners are singular; unit shear on the
// right.
TEST_P(Quadratics, K07_cook_membrane) {
  model::Model model = plane_model(1.0, 1.0 / 3.0, StressState::plane_stress);
  const Cells grid = unit_grid(
      32, 32, [](const Vec2& p) { return Vec2(grade(p.x(), 2.5), grade_ends(p.y(), 2.0)); });
  model.mesh = make_mesh(GetParam(), grid, [](const Vec2& p) {
    const double s = p.x();
    const double t = p.y();
    return Vec2(48.0 * s, (1.0 - t) * 44.0 * s + t * (44.0 + 16.0 * s));
  });
  set_freedom(
      model, FreedomRole::suppressed, [](const Vec3& x) { return x.x() == 0.0; }, true, true);
  model::Load shear;
  shear.type = model::LoadType::resultant;
  shear.faces = face_set(model, [](const Vec3& x) { return std::abs(x.x() - 48.0) < 1e-9; });
  shear.value = {CompiledExpression::make_constant(0.0), CompiledExpression::make_constant(1.0)};
  const base::Vector u = solve(model, {"", {shear}});
  EXPECT_NEAR(displacement_at(model.mesh, u, Vec3(48.0, 52.0, 0.0)).y(), 23.967, 1.5e-4 * 23.967);
}

// K04 NAFEMS LE1, elliptic membrane under outward pressure.
TEST_P(Quadratics, K04_elliptic_membrane) {
  model::Model model = plane_model(210e3, 0.3, StressState::plane_stress, 0.1);
  const Cells grid = unit_grid(
      48, 24, [](const Vec2& p) { return Vec2(grade_ends(p.x(), 1.8), grade(p.y(), 1.8)); });
  model.mesh = make_mesh(GetParam(), grid, [](const Vec2& p) {
    const double angle = 0.5 * std::numbers::pi * (1.0 - p.x());
    const double g = p.y();
    const Vec2 inner(2.0 * std::cos(angle), std::sin(angle));
    const Vec2 outer(3.25 * std::cos(angle), 2.75 * std::sin(angle));
    return Vec2((1.0 - g) * inner + g * outer);
  });
  set_freedom(
      model, FreedomRole::suppressed, [](const Vec3& x) { return x.x() < 1e-12; }, true, false);
  set_freedom(
      model, FreedomRole::suppressed, [](const Vec3& x) { return x.y() < 1e-12; }, false, true);
  model::Load pressure;
  pressure.type = model::LoadType::pressure;
  pressure.faces = face_set(model, [](const Vec3& x) {
    return std::abs(std::hypot(x.x() / 3.25, x.y() / 2.75) - 1.0) < 1e-9;
  });
  pressure.value = {CompiledExpression::make_constant(-10.0)};
  const base::Vector u = solve(model, {"", {pressure}});
  const auto D = fe::stress_at_body_point(model, model.mesh, u, Vec3(2.0, 0.0, 0.0));
  const auto A = fe::stress_at_body_point(model, model.mesh, u, Vec3(0.0, 1.0, 0.0));
  ASSERT_TRUE(D && A);
  EXPECT_NEAR((*D)[1], 92.65818, 1e-4 * 92.65818);
  EXPECT_NEAR((*A)[0], -7.26058, 1e-3 * 7.26058);
}

// K06 thick cylinder 3 <= r <= 9 under inner pressure 1, plane strain. Closer to
// incompressible, fully integrated quadratics stiffen.
// Lame: u(3) = (1 + nu)/E 9 p/(81 - 9) ((1 - 2 nu) 3 + 81/3).
TEST_P(Quadratics, K06_thick_cylinder) {
  for (const double nu : {0.3, 0.49, 0.499}) {
    model::Model model = plane_model(1000.0, nu, StressState::plane_strain);
    model.mesh = make_mesh(GetParam(), unit_grid(28, 20), [](const Vec2& p) {
      const double angle = 0.5 * std::numbers::pi * (1.0 - p.x());
      return Vec2((3.0 + 6.0 * p.y()) * Vec2(std::cos(angle), std::sin(angle)));
    });
    set_freedom(
        model, FreedomRole::suppressed, [](const Vec3& x) { return x.x() < 1e-12; }, true, false);
    set_freedom(
        model, FreedomRole::suppressed, [](const Vec3& x) { return x.y() < 1e-12; }, false, true);
    model::Load pressure;
    pressure.type = model::LoadType::pressure;
    pressure.faces = face_set(model, [](const Vec3& x) { return std::abs(x.norm() - 3.0) < 1e-9; });
    pressure.value = {CompiledExpression::make_constant(1.0)};
    const base::Vector u = solve(model, {"", {pressure}});
    const double exact = (1.0 + nu) / 1000.0 * 9.0 / 72.0 * ((1.0 - 2.0 * nu) * 3.0 + 27.0);
    EXPECT_NEAR(displacement_at(model.mesh, u, Vec3(3.0, 0.0, 0.0)).x(), exact, 1e-3 * exact) << nu;
  }
}

} // namespace
} // namespace spricka::test::test_benchmarks
