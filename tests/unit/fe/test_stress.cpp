// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/stress.hpp"
#include "model/property_points.hpp"

#include "model/model.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace spricka::fe::test_stress {
namespace {

using base::ElementType;
using base::Vec2;
using base::Vec3;
using base::Vector;
using test::Cells;

constexpr double E = 200.0;
constexpr double nu = 0.3;

using CardField = std::function<Vec2(const Vec3&)>;

Vector interpolate(const model::Mesh& mesh, const CardField& field) {
  Vector u(2 * static_cast<Eigen::Index>(mesh.node_count()));
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    u.segment<2>(2 * static_cast<Eigen::Index>(n)) = field(mesh.x[n]);
  }
  return u;
}

// Pure bending in plane stress, sxx = E y, all else zero: u = x y, v = -(x^2 + nu y^2)/2. A
// quadratic field, which quadratic elements with straight sides hold exactly.
Vec2 bending(const Vec3& x) {
  return {x.x() * x.y(), -0.5 * (x.x() * x.x() + nu * x.y() * x.y())};
}

class Quadratic : public testing::TestWithParam<ElementType> {
protected:
  Quadratic() : model(test::plane_model(E, nu, model::StressState::plane_stress)) {
    // Parallelograms: QUAMC8 is complete to degree 2 on them.
    model.mesh = test::make_mesh(GetParam(), test::unit_grid(3, 2), [](const Vec2& p) {
      return Vec2(2.0 * p.x() + 0.3 * p.y(), p.y() - 0.2 * p.x());
    });
    u = interpolate(model.mesh, bending);
  }
  model::Model model;
  Vector u;
};

INSTANTIATE_TEST_SUITE_P(stress, Quadratic,
                         testing::Values(ElementType::trimc6, ElementType::quamc8,
                                         ElementType::quamc9),
                         [](const auto& c) {
                           return std::string(base::element_info(c.param).name);
                         });

TEST_P(Quadratic, recovers_a_linear_stress_exactly) {
  const std::vector<Stress> by_element = element_node_stress(model, model.mesh, u);
  for (std::size_t k = 0; k < by_element.size(); ++k) {
    const Stress expected = E * model.mesh.x[model.mesh.nodes[k].index()].y() * Stress::Unit(0);
    EXPECT_LT((by_element[k] - expected).norm(), 1e-12 * E);
  }
  const std::vector<Stress> by_node = nodal_stress(model, model.mesh, by_element);
  for (std::size_t n = 0; n < by_node.size(); ++n) {
    EXPECT_LT((by_node[n] - E * model.mesh.x[n].y() * Stress::Unit(0)).norm(), 1e-12 * E);
  }
}

TEST_P(Quadratic, finds_stress_at_points_inside_on_sides_and_at_corners) {
  for (const Vec2& p : {Vec2(0.11, 0.2), Vec2(0.5, 0.5), Vec2(1.0, 0.0), Vec2(0.0, 1.0),
                        Vec2(0.0, 0.3), Vec2(1.0 / 3.0, 0.5), Vec2(0.25, 0.0), Vec2(1.0, 1.0)}) {
    const Vec3 x(2.0 * p.x() + 0.3 * p.y(), p.y() - 0.2 * p.x(), 0.0);
    const std::optional<Stress> s = stress_at_body_point(model, model.mesh, u, x);
    ASSERT_TRUE(s.has_value()) << p.transpose();
    EXPECT_LT((*s - E * x.y() * Stress::Unit(0)).norm(), 1e-11 * E) << p.transpose();
  }
}

TEST_P(Quadratic, is_empty_outside_the_body) {
  EXPECT_FALSE(stress_at_body_point(model, model.mesh, u, Vec3(-0.1, 0.0, 0.0)));
  EXPECT_FALSE(stress_at_body_point(model, model.mesh, u, Vec3(1.0, 1.5, 0.0)));
  EXPECT_FALSE(stress_at_body_point(model, model.mesh, u, Vec3(50.0, 50.0, 0.0)));
}

TEST(stress, plane_strain_has_the_stress_across) {
  model::Model model = test::plane_model(E, nu, model::StressState::plane_strain);
  model.mesh = test::make_mesh(ElementType::trim3, test::unit_grid(1, 1));
  const Vector u = interpolate(model.mesh, [](const Vec3& x) { return Vec2(x.x(), 0.0); });
  const Stress s = element_node_stress(model, model.mesh, u).front();
  const double lambda = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  EXPECT_NEAR(s[0], lambda + E / (1.0 + nu), 1e-12 * E);
  EXPECT_NEAR(s[1], lambda, 1e-12 * E);
  EXPECT_NEAR(s[2], lambda, 1e-12 * E);
}

TEST(stress, is_finite_at_a_quarter_point_tip_and_elsewhere_exact) {
  for (const ElementType type : {ElementType::trimc6, ElementType::quamc8, ElementType::quamc9}) {
    model::Model model = test::plane_model(E, nu, model::StressState::plane_stress);
    model.mesh = test::make_mesh(type, test::unit_grid(2, 2));
    const base::NodeId tip(4);
    test::make_quarter_points(model.mesh, tip);
    // sqrt(r) along x: infinite strain at the tip.
    const Vec3 x0 = model.mesh.x[tip.index()];
    const Vector u = interpolate(
        model.mesh, [&](const Vec3& x) { return Vec2(std::sqrt((x - x0).norm()), 0.0); });
    for (const Stress& s : element_node_stress(model, model.mesh, u)) {
      EXPECT_TRUE(s.allFinite());
      EXPECT_LT(s.norm(), 20.0 * E);
    }
    const std::optional<Stress> s = stress_at_body_point(model, model.mesh, u, x0);
    ASSERT_TRUE(s.has_value());
    EXPECT_TRUE(s->allFinite());
    // Along the leg y = 0.5 the element holds sqrt(r) exactly: exx = 1 / (2 sqrt(r)).
    const Vector ux = interpolate(model.mesh, [&](const Vec3& x) {
      return Vec2(std::sqrt(std::max(x.x() - x0.x(), 0.0)), 0.0);
    });
    const double r = 0.2;
    const std::optional<Stress> leg =
        stress_at_body_point(model, model.mesh, ux, x0 + Vec3(r, 0.0, 0.0));
    ASSERT_TRUE(leg.has_value());
    EXPECT_NEAR((*leg)[0], E / (1.0 - nu * nu) * 0.5 / std::sqrt(r), 0.2 * E);
  }
}

TEST(stress, nodes_between_two_properties_have_a_value_of_each) {
  model::Model model = test::plane_model(E, nu, model::StressState::plane_stress);
  model.materials.push_back(model.materials[0]);
  model.materials[1].E = 10.0 * E;
  model.properties.push_back(model.properties[0]);
  model.properties[1].material = base::MaterialId(1);
  model.mesh = test::make_mesh(ElementType::quam4, test::unit_grid(2, 1));
  model.mesh.property[1] = base::PropertyId(1);
  const Vector u = interpolate(model.mesh, [](const Vec3& x) { return Vec2(x.x(), -nu * x.y()); });
  const std::vector<Stress> s =
      nodal_stress(model, model.mesh, element_node_stress(model, model.mesh, u));
  const model::FieldPointsByProperty points = model::property_points(model.mesh);
  ASSERT_EQ(s.size(), model.mesh.node_count() + 2); // the border's two nodes once more
  ASSERT_EQ(points.node.size(), s.size());
  for (std::size_t k = 0; k < points.of.size(); ++k) {
    const auto point = static_cast<std::size_t>(points.of[k]);
    const double expected = k < 4 ? E : 10.0 * E;
    EXPECT_NEAR(s[point][0], expected, 1e-11 * expected);
    EXPECT_EQ(points.node[point], model.mesh.nodes[k]);
  }
  // On the border the element found first decides; never a mixture.
  const double border = (*stress_at_body_point(model, model.mesh, u, Vec3(0.5, 0.5, 0.0)))[0];
  EXPECT_NEAR(border, E, 1e-10 * E);
}

// A linear stress on parallelograms and straight triangles: its mean is that of the corners.
TEST_P(Quadratic, mean_of_an_element_is_the_integral_over_it) {
  const std::vector<Stress> mean = element_mean_stress(model, model.mesh, u);
  for (std::size_t e = 0; e < mean.size(); ++e) {
    const auto nodes = model.mesh.element_nodes(base::ElementId(e));
    const auto corners = static_cast<std::size_t>(base::element_info(model.mesh.type[e]).corners);
    double y = 0.0;
    for (std::size_t i = 0; i < corners; ++i) {
      y += model.mesh.x[nodes[i].index()].y() / static_cast<double>(corners);
    }
    EXPECT_LT((mean[e] - E * y * Stress::Unit(0)).norm(), 1e-12 * E);
  }
}

// Two bodies that touch (a contact, or the faces of a crack) share a place but no node.
TEST(stress, is_never_mixed_from_two_bodies) {
  model::Model model = test::plane_model(E, nu, model::StressState::plane_stress);
  Cells cells = test::unit_grid(1, 1);
  for (int i = 0; i < 4; ++i) {
    cells.points.push_back(cells.points[static_cast<std::size_t>(i)] + Vec2(1.0, 0.0));
  }
  cells.cells.push_back({4, 5, 7, 6});
  model.mesh = test::make_mesh(ElementType::quam4, cells);
  Vector u = Vector::Zero(16);
  for (const Eigen::Index n : {5, 7}) {
    u[2 * n] = 1.0; // only the right body is stretched
  }
  const auto s = stress_at_body_point(model, model.mesh, u, Vec3(1.0, 0.5, 0.0));
  ASSERT_TRUE(s.has_value());
  EXPECT_EQ(s->norm(), 0.0);
}

TEST(stress, takes_points_of_an_arc_between_the_nodes) {
  model::Model model = test::plane_model(E, nu, model::StressState::plane_stress);
  model.mesh = test::make_mesh(ElementType::quam4, test::unit_grid(8, 2), [](const Vec2& p) {
    const double angle = 1.5 * (1.0 - p.x());
    return Vec2((1.0 + p.y()) * Vec2(std::cos(angle), std::sin(angle)));
  });
  const Vector u = interpolate(model.mesh, [](const Vec3& x) { return Vec2(x.x(), -nu * x.y()); });
  for (const double angle : {0.1, 0.25, 0.7, 1.3}) {
    for (const double r : {1.0, 2.0}) {
      const auto s =
          stress_at_body_point(model, model.mesh, u, r * Vec3(std::cos(angle), std::sin(angle), 0));
      ASSERT_TRUE(s.has_value());
      EXPECT_NEAR((*s)[0], E, 1e-10 * E);
    }
  }
}

} // namespace
} // namespace spricka::fe::test_stress
