// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"

#include "model/model.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spricka::fe::test_load {
namespace {

using base::CompiledExpression;
using base::ElementType;
using base::OpCode;
using base::Vec2;
using base::Vec3;
using base::Vector;

constexpr double thickness = 0.4;
constexpr auto everywhere = [](const Vec3&) { return true; };

// Quarter ring 1 <= r <= 2, its arcs curved where the elements are.
Vec2 ring(const Vec2& p) {
  const double angle = 0.5 * std::numbers::pi * (1.0 - p.x());
  return (1.0 + p.y()) * Vec2(std::cos(angle), std::sin(angle));
}

class EveryType : public testing::TestWithParam<ElementType> {
protected:
  EveryType() : model(test::plane_model(1.0, 0.3, model::StressState::plane_stress, thickness)) {
    model.mesh = test::make_mesh(GetParam(), test::unit_grid(6, 3), ring);
  }

  static Vec2 sum(const Vector& f) {
    const Eigen::Map<const Eigen::Matrix2Xd> by_node(f.data(), 2, f.size() / 2);
    return by_node.rowwise().sum();
  }
  /// Moment about the origin.
  [[nodiscard]] double moment(const Vector& f) const {
    double m = 0.0;
    for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
      const auto row = 2 * static_cast<Eigen::Index>(n);
      m += model.mesh.x[n].x() * f[row + 1] - model.mesh.x[n].y() * f[row];
    }
    return m;
  }
  Vector load(model::LoadType type, std::vector<CompiledExpression> value,
              const test::Where& where) {
    model::Load card;
    card.type = type;
    card.value = std::move(value);
    if (type == model::LoadType::force) {
      card.nodes = test::node_set(model, where);
    } else if (type == model::LoadType::body) {
      card.elements = test::all_elements(model);
    } else {
      card.faces = test::face_set(model, where);
    }
    return consistent_load_vector(model, model.mesh, {"", {card}});
  }
  model::Model model;
};

INSTANTIATE_TEST_SUITE_P(load, EveryType,
                         testing::Values(ElementType::trim3, ElementType::trimc6,
                                         ElementType::quam4, ElementType::quamc8,
                                         ElementType::quamc9),
                         [](const auto& c) {
                           return std::string(base::element_info(c.param).name);
                         });

bool inner(const Vec3& x) {
  return std::abs(x.norm() - 1.0) < 0.1;
}

// Pressure on an arc from (0,1) to (1,0): by the divergence theorem the resultant depends on the
// end points only, however the arc is divided: p t (1, 1) pushing outwards.
TEST_P(EveryType, pressure_resultant_depends_on_the_end_points_only) {
  const Vector f = load(model::LoadType::pressure, {CompiledExpression::make_constant(7.0)}, inner);
  EXPECT_LT((sum(f) - 7.0 * thickness * Vec2(1.0, 1.0)).norm(), 1e-13);
}

TEST_P(EveryType, pressure_all_round_balances) {
  const Vector f =
      load(model::LoadType::pressure, {CompiledExpression::make_constant(7.0)}, everywhere);
  EXPECT_LT(sum(f).norm(), 1e-13);
  EXPECT_NEAR(moment(f), 0.0, 1e-13);
  EXPECT_GT(f.norm(), 1.0);
}

TEST_P(EveryType, pressure_field_is_taken_at_its_place) {
  // p = x on the straight edge y = 0, 1 <= x <= 2: force 3/2 t in +y, moment 7/3 t.
  const Vector f = load(model::LoadType::pressure, {test::linear(0.0, 1.0, 0.0)},
                        [](const Vec3& x) { return std::abs(x.y()) < 1e-12; });
  EXPECT_LT((sum(f) - Vec2(0.0, 1.5 * thickness)).norm(), 1e-14);
  EXPECT_NEAR(moment(f), 7.0 / 3.0 * thickness, 1e-14);
}

TEST_P(EveryType, traction_on_a_straight_edge) {
  const Vector f = load(model::LoadType::traction,
                        {test::linear(1.0, 2.0, 0.0), CompiledExpression::make_constant(-4.0)},
                        [](const Vec3& x) { return std::abs(x.y()) < 1e-12; });
  EXPECT_LT((sum(f) - thickness * Vec2(4.0, -4.0)).norm(), 1e-14);
  EXPECT_NEAR(moment(f), -4.0 * 1.5 * thickness, 1e-14);
}

TEST_P(EveryType, traction_on_an_arc_tends_to_its_length) {
  const Vector f = load(model::LoadType::traction, {CompiledExpression::make_constant(1.0)}, inner);
  const double length = 0.5 * std::numbers::pi;
  const double tolerance = base::element_info(GetParam()).quadratic ? 1e-5 : 5e-3;
  EXPECT_NEAR(sum(f).x(), length * thickness, tolerance);
  EXPECT_EQ(sum(f).y(), 0.0);
}

TEST_P(EveryType, resultant_over_faces_is_exact) {
  const Vector f = load(
      model::LoadType::resultant,
      {CompiledExpression::make_constant(3.0), CompiledExpression::make_constant(-97100.0)}, inner);
  EXPECT_NEAR(sum(f).x(), 3.0, 1e-15 * 97100.0);
  EXPECT_NEAR(sum(f).y(), -97100.0, 1e-14 * 97100.0);
  // Even over the arc: by the symmetry of the arc about x = y the force acts at a point with
  // equal coordinates c, where c is that of an even traction.
  const Vector even =
      load(model::LoadType::traction, {CompiledExpression::make_constant(1.0)}, inner);
  const double c = -moment(even) / sum(even).x();
  EXPECT_NEAR(moment(f), c * (-97100.0 - 3.0), 1e-9);
}

TEST_P(EveryType, resultant_over_elements_is_exact) {
  model::Load card;
  card.type = model::LoadType::resultant;
  card.elements = test::all_elements(model);
  card.value = {CompiledExpression::make_constant(0.0), CompiledExpression::make_constant(97100.0)};
  const Vector f = consistent_load_vector(model, model.mesh, {"", {card}});
  EXPECT_EQ(sum(f).x(), 0.0);
  EXPECT_NEAR(sum(f).y(), 97100.0, 1e-14 * 97100.0);
  // The share of a node does not depend on the thickness or on the force.
  const Vector body = load(
      model::LoadType::body,
      {CompiledExpression::make_constant(0.0), CompiledExpression::make_constant(1.0)}, everywhere);
  EXPECT_LT((f / 97100.0 - body / sum(body).y()).norm(), 1e-15);
}

// Integral of a linear force field over the mesh: with the divergence theorem, from the sides
// only: the volume integral of x is that of x^2/2 n_x over the boundary, a traction-like load.
TEST_P(EveryType, body_force_field_agrees_with_the_divergence_theorem) {
  const Vector body = load(model::LoadType::body, {test::linear(0.0, 1.0, 0.0)}, everywhere);
  const CompiledExpression half_square{
      {{OpCode::number, -0.5}, {OpCode::x}, {OpCode::multiply}, {OpCode::x}, {OpCode::multiply}}};
  const Vector sides = load(model::LoadType::pressure, {half_square}, everywhere);
  EXPECT_NEAR(sum(body).x(), sum(sides).x(), 1e-13);
}

TEST_P(EveryType, nodal_forces_are_added_as_given) {
  const auto corner = [](const Vec3& x) { return (x - Vec3(2.0, 0.0, 0.0)).norm() < 1e-12; };
  const Vector f =
      load(model::LoadType::force,
           {test::linear(0.0, 1.0, 0.0), CompiledExpression::make_constant(5.0)}, corner);
  EXPECT_LT((sum(f) - Vec2(2.0, 5.0)).norm(), 1e-14);
  EXPECT_NEAR(f.norm(), std::sqrt(29.0), 1e-14);
}

TEST(prescribed_displacement_vector, sets_the_components_given_and_no_force) {
  model::Model model = test::plane_model(1.0, 0.3, model::StressState::plane_stress);
  model.mesh = test::make_mesh(ElementType::quam4, test::unit_grid(1, 1));
  model::Load all;
  all.type = model::LoadType::displacement;
  all.nodes = test::node_set(model, everywhere);
  all.value = {test::linear(0.0, 1.0, 0.0), CompiledExpression::make_constant(3.0)};
  model::Load top = all;
  top.nodes = test::node_set(model, [](const Vec3& x) { return x.y() == 1.0; });
  top.value = {CompiledExpression::make_constant(9.0)};
  const model::LoadCase load_case{"", {all, top}};
  Vector expected(8);
  expected << 0.0, 3.0, 1.0, 3.0, 9.0, 3.0, 10.0, 3.0; // lines of a case add up
  EXPECT_EQ(prescribed_displacement_vector(model, model.mesh, load_case), expected);
  EXPECT_EQ(consistent_load_vector(model, model.mesh, load_case).norm(), 0.0);
}

} // namespace
} // namespace spricka::fe::test_load
