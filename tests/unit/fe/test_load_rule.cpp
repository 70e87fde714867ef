// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/load_rule.hpp"

#include "fe/assemble.hpp"
#include "fe/between_nodes.hpp"
#include "fe/heat.hpp"
#include "model/model.hpp"
#include "tests/unit/fe/expressions.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spricka::fe::test_load_rule {
namespace {

using base::CompiledExpression;
using base::ElementType;
using base::Vec2;
using base::Vec3;
using base::Vector;
using namespace test::field;

class Sides : public testing::TestWithParam<ElementType> {
protected:
  // A turned strip, so that nothing runs along an axis.
  static Vec2 turned(const Vec2& p) {
    return {4.0 * p.x() * std::cos(angle) - p.y() * std::sin(angle),
            4.0 * p.x() * std::sin(angle) + p.y() * std::cos(angle)};
  }
  static constexpr double angle = 0.7;
  static CardField along() { return std::cos(angle) * X + std::sin(angle) * Y; }  // 0 .. 4
  static CardField across() { return std::cos(angle) * Y - std::sin(angle) * X; } // 0 .. 1

  Sides() : model(test::plane_model(1.0, 0.3, model::StressState::plane_stress, 1.0)) {
    model.mesh = test::make_mesh(GetParam(), test::unit_grid(6, 3), turned);
  }
  /// Work of a load on the displacements 1 and (distance along the strip), both along x.
  Vec2 force_and_moment(model::LoadType type, const CardField& value) {
    model::Load card;
    card.type = type;
    card.value = {value.e};
    if (type == model::LoadType::body) {
      card.elements = test::all_elements(model);
    } else {
      card.faces = test::face_set(model, [](const Vec3& x) {
        return std::abs(std::cos(angle) * x.y() - std::sin(angle) * x.x()) < 1e-9;
      });
    }
    const Vector f = consistent_load_vector(model, model.mesh, {"", {card}});
    Vec2 sum = Vec2::Zero();
    for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
      const double fx = f[2 * static_cast<Eigen::Index>(n)];
      sum += fx * Vec2(1.0, along().e(model.mesh.x[n]));
    }
    unresolved = unresolved_load_fraction(model, model.mesh, card);
    return sum;
  }
  void expect(const Vec2& found, const Vec2& wanted, double tolerance) {
    EXPECT_LT(unresolved, 5e-4); // from there on W435 tells
    EXPECT_NEAR(found.x(), wanted.x(), tolerance * std::abs(wanted.x()));
    EXPECT_NEAR(found.y(), wanted.y(), tolerance * std::abs(wanted.y()));
  }
  model::Model model;
  double unresolved = 0.0; ///< of the last load
};

INSTANTIATE_TEST_SUITE_P(load, Sides,
                         testing::Values(ElementType::trim3, ElementType::trimc6,
                                         ElementType::quam4, ElementType::quamc8,
                                         ElementType::quamc9),
                         [](const auto& c) {
                           return std::string(base::element_info(c.param).name);
                         });

// Closed forms of the integrals of a step, a bend and a peak, wherever they lie between nodes.
TEST_P(Sides, a_step_of_traction_is_integrated_up_to_its_place) {
  for (const double at : {0.1, 1.23456, 2.0, 3.999}) {
    expect(force_and_moment(model::LoadType::traction, along() > at),
           {4.0 - at, 0.5 * (16.0 - at * at)}, 1e-8);
  }
}

TEST_P(Sides, a_bend_of_traction_is_integrated_up_to_its_place) {
  const double at = 1.7;
  const double length = 4.0 - at;
  expect(force_and_moment(model::LoadType::traction, max(0.0, along() - at)),
         {0.5 * length * length, 0.5 * length * length * (at + 2.0 / 3.0 * length)}, 1e-9);
}

TEST_P(Sides, a_peak_between_all_points_is_found) {
  for (const double width : {0.1, 0.01}) {
    const double at = 2.3571;
    const double force = width * std::sqrt(std::numbers::pi);
    expect(force_and_moment(model::LoadType::traction, exp(-(((along() - at) / width) ^ 2.0))),
           {force, force * at}, 1e-6);
  }
}

TEST_P(Sides, a_peak_beside_a_load_of_its_size_is_found) {
  const double width = 0.01;
  const double at = 0.4567;
  const double force = 1000.0 * width * std::sqrt(std::numbers::pi);
  expect(force_and_moment(model::LoadType::traction,
                          1.0 + 1000.0 * exp(-(((along() - at) / width) ^ 2.0))),
         {4.0 + force, 8.0 + force * at}, 1e-6);
}

TEST_P(Sides, a_step_of_body_force_is_integrated_up_to_its_line) {
  for (const double at : {0.3, 1.23456, 3.7}) {
    expect(force_and_moment(model::LoadType::body, along() > at),
           {4.0 - at, 0.5 * (16.0 - at * at)}, 1e-5);
  }
}

TEST_P(Sides, a_peak_of_body_force_is_found) {
  const double width = 0.05;
  const double force = width * width * std::numbers::pi;
  const CardField square = ((along() - 2.3571) ^ 2.0) + ((across() - 0.5123) ^ 2.0);
  const Vec2 found = force_and_moment(model::LoadType::body, exp(-square / (width * width)));
  EXPECT_LT(std::abs(found.x() - force), (unresolved + 1e-4) * force);
  EXPECT_LT(unresolved, 1e-3);
}

// A step on the borders of elements belongs to one of them and costs nothing; a window beside it is
// found whole, or what is missed is told.
TEST_P(Sides, a_step_on_borders_times_a_thin_window_keeps_its_force) {
  const double border = 4.0 / 3.0;
  for (const double width : {0.2, 0.02}) {
    const CardField window = (across() > 0.51) * (0.51 + width > across());
    const Vec2 found = force_and_moment(model::LoadType::body, (along() > border) * window);
    const double force = (4.0 - border) * width;
    EXPECT_LE(std::abs(found.x() - force), (unresolved + 1e-4) * force) << width;
    EXPECT_LT(unresolved, 0.01) << width;
  }
}

// The integral of a temperature over the strip, by what elements take and by the points of the
// rest: layers of any thickness, along the elements' sides, across them and askew.
TEST_P(Sides, a_thin_hot_layer_is_integrated_whole) {
  model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(std::size_t{0}));
  const std::array<std::pair<CardField, double>, 2> ways{std::pair{along(), 1.0},
                                                         std::pair{across(), 4.0}};
  for (const auto& [way, length] : ways) {
    for (const double width : {0.1, 0.02}) {
      model::Load card;
      card.type = model::LoadType::temperature;
      card.value = {(100.0 * (way > 0.4321) * (0.4321 + width > way)).e};
      card.elements = test::all_elements(model);
      const CaseTemperature heat =
          make_case_temperature(model, {model.mesh, model.mesh, nullptr, {}}, {"", {card}});
      double sum = 0.0;
      const int corners = base::element_info(GetParam()).corners;
      for (std::size_t e = 0; e < model.mesh.element_count(); ++e) {
        sum += heat.temperature.segment(model.mesh.first[e], corners).mean() * 4.0 /
               static_cast<double>(model.mesh.element_count());
        for (const ResidualTemperaturePoint& p :
             heat.residual_points_in_element(base::ElementId(e))) {
          sum += p.area * p.T;
        }
      }
      const double told = unresolved_temperature_fraction(model, model.mesh, card);
      EXPECT_NEAR(sum, 100.0 * width * length, (told + 1e-3) * 100.0 * width * length)
          << width << " of " << length;
      EXPECT_LT(told, 0.01) << width;
    }
  }
}

// What nodes cannot carry of a displacement: nothing of a polynomial; a kink, a step, a peak.
TEST_P(Sides, a_displacement_is_known_to_leave_its_nodes) {
  const auto off = [&](const CardField& value) {
    model::Load card;
    card.type = model::LoadType::displacement;
    card.value = {value.e};
    card.nodes = test::node_set(model, [](const Vec3& x) {
      return std::abs(std::cos(angle) * x.y() - std::sin(angle) * x.x()) < 1e-9;
    });
    return displacement_interpolation_error(model.mesh, card).off;
  };
  EXPECT_LT(off(1.0 + 0.3 * along()), 1e-12);
  EXPECT_GT(off(along() > 2.3), 0.4);
  EXPECT_GT(off(exp(-(((along() - 2.3571) / 0.03) ^ 2.0))), 0.01);
  const double h = 2.0 / 3.0; // a kink in the middle of an edge, off by h / 2 between two nodes
  if (base::element_info(GetParam()).quadratic) {
    EXPECT_LT(off(along() ^ 2.0), 1e-12);
    EXPECT_NEAR(off(abs(along() - 1.5 * h)), h / 8.0, 0.01 * h);
  } else {
    EXPECT_NEAR(off(abs(along() - 1.5 * h)), h / 2.0, 0.02 * h);
  }
}

// What is smooth costs no more than before: the usual points.
TEST_P(Sides, a_smooth_load_keeps_the_usual_points) {
  model::Load card;
  card.type = model::LoadType::traction;
  card.value = {(1.0 + 0.2 * X + 0.1 * X * Y).e};
  const Eigen::Matrix<double, 3, 3> side{{0.0, 1.0, 0.5}, {0.0, 0.3, 0.15}, {0.0, 0.0, 0.0}};
  const auto rule = load_rule<1>(shape::reference_line(3), side, card, {1.0, 1.0});
  EXPECT_EQ(rule.points.size(), shape::quadrature<shape::Quamc8::Side>(load_degree).size());
}

// Volumes that planes cut off reference elements, and the number of evaluations that takes: a step
// askew is integrated up to its place, and costs no more than a bound.
TEST(LoadRule, StepsAskewEndAtTheirPlane) {
  using shape::ReferenceDomain;
  long evaluations = 0;
  const auto volume = [&]<int dim>(ReferenceDomain domain, const shape::Point<dim>& normal,
                                   double at, double tolerance) {
    evaluations = 0;
    const ReferenceField<dim> step = [&](const shape::Point<dim>& r) {
      ++evaluations;
      return Vec3(normal.dot(r) > at ? 1.0 : 0.0, 0.0, 0.0);
    };
    const FieldAdaptedRule<dim> rule = make_adapted_rule<dim>(
        whole_element_domain<dim>(domain, load_degree), step, {tolerance, {}, false});
    EXPECT_TRUE(rule.jumps);
    double sum = 0.0;
    for (const auto& point : rule.points) {
      sum += point.weight * step(point.r).x();
    }
    return sum;
  };
  using Plane = shape::Point<2>;
  using Solid = shape::Point<3>;
  EXPECT_NEAR(volume.operator()<2>(ReferenceDomain::quadrilateral, Plane(1.0, 0.3), 0.0, 1e-7), 2.0,
              1e-7);
  EXPECT_NEAR(volume.operator()<2>(ReferenceDomain::quadrilateral, Plane(1.0, 1.0), 1.3, 1e-7),
              0.245, 1e-6);
  EXPECT_NEAR(volume.operator()<2>(ReferenceDomain::triangle, Plane(0.0, 1.0), 0.3, 1e-7), 0.245,
              1e-6);
  EXPECT_LT(evaluations, 200000);
  EXPECT_NEAR(volume.operator()<3>(ReferenceDomain::hexahedron, Solid(1.0, -0.3, 0.1), 0.0, 1e-4),
              4.0, 1e-4);
  EXPECT_NEAR(volume.operator()<3>(ReferenceDomain::hexahedron, Solid(1.0, 1.0, 1.0), 1.0, 1e-4),
              4.0 / 3.0, 3e-3);
  EXPECT_NEAR(volume.operator()<3>(ReferenceDomain::tetrahedron, Solid(0.0, 0.0, 1.0), 0.3, 1e-4),
              0.343 / 6.0, 1e-4);
  EXPECT_NEAR(volume.operator()<3>(ReferenceDomain::prism, Solid(0.0, 0.5, 1.0), 0.0, 1e-4),
              7.0 / 12.0, 1e-3);
  EXPECT_LT(evaluations, 200000);
}

// Loads whose rule never ends are told, not guessed: noise, and a pole whose integral is infinite.
TEST(LoadRule, WhatIsNotResolvedIsTold) {
  model::Load card;
  card.type = model::LoadType::traction;
  const Eigen::Matrix<double, 3, 3> side{{0.0, 1.0, 0.5}, {0.0, 0.3, 0.15}, {0.0, 0.0, 0.0}};
  for (const CardField& value : {sin(1e9 * X), 1e-9 / ((X - 0.3137) ^ 2.0)}) {
    card.value = {value.e};
    const auto rule = load_rule<1>(shape::reference_line(3), side, card, {1e-9, 1e-9});
    EXPECT_GT(rule.missed, 0.05 * rule.amount);
  }
}

} // namespace
} // namespace spricka::fe::test_load_rule
