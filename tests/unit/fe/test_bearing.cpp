// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/bearing.hpp"

#include "fe/assemble.hpp"
#include "geometry/circle_fit.hpp"
#include "model/mesh_side.hpp"
#include "model/model.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spricka::fe::test_bearing {
namespace {

using base::CompiledExpression;
using base::ElementType;
using base::Vec2;
using base::Vec3;
using base::Vector;
using test::Cells;

constexpr double radius = 36.0;
constexpr double thickness = 14.0;
const Vec2 centre(12.0, -7.0);

// A ring of two layers of 4 length round the centre, from the radius outwards (a bore) or inwards
// (a shaft).
model::Model ring(ElementType type, int sectors, bool shaft) {
  model::Model model = test::plane_model(72e3, 0.3, model::StressState::plane_stress, thickness);
  Cells cells;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < sectors; ++i) {
      const double angle = 0.1 + 2.0 * std::numbers::pi * i / sectors;
      const double r = radius + (shaft ? -4.0 : 4.0) * j;
      cells.points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
  }
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < sectors; ++i) {
      const int n = j * sectors;
      const int next = (i + 1) % sectors;
      if (shaft) {
        cells.cells.push_back({n + i, n + next, n + sectors + next, n + sectors + i});
      } else {
        cells.cells.push_back({n + next, n + i, n + sectors + i, n + sectors + next});
      }
    }
  }
  // Mid nodes lie on chords, a little inside their circles 2 apart.
  model.mesh = test::make_mesh(type, cells, [](const Vec2& p) {
    const double r = radius + 2.0 * std::round((p.norm() - radius) / 2.0);
    return Vec2(centre + r * p.normalized());
  });
  return model;
}

struct Case {
  ElementType type;
  bool shaft;
  model::BearingShape shape;
};

class Bearing : public testing::TestWithParam<Case> {
protected:
  Bearing() : model(ring(GetParam().type, 24, GetParam().shaft)) {
    load.type = model::LoadType::bearing;
    load.shape = GetParam().shape;
    load.faces = on_circle([](const Vec2&) { return true; });
  }

  base::FaceSetId on_circle(const std::function<bool(const Vec2&)>& where) {
    return test::face_set(model, [&](const Vec3& x) {
      const Vec2 arm = x.head<2>() - centre;
      return std::abs(arm.norm() - radius) < 1e-9 && where(arm);
    });
  }
  Vector apply(const Vec2& F) {
    load.value = {CompiledExpression::make_constant(F.x()),
                  CompiledExpression::make_constant(F.y())};
    return consistent_load_vector(model, model.mesh, {"", {load}});
  }
  static Vec2 sum(const Vector& f) {
    const Eigen::Map<const Eigen::Matrix2Xd> by_node(f.data(), 2, f.size() / 2);
    return by_node.rowwise().sum();
  }
  [[nodiscard]] double moment_about_centre(const Vector& f) const {
    double m = 0.0;
    for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
      const Vec2 arm = model.mesh.x[n].head<2>() - centre;
      const auto row = 2 * static_cast<Eigen::Index>(n);
      m += arm.x() * f[row + 1] - arm.y() * f[row];
    }
    return m;
  }

  model::Model model;
  model::Load load;
};

std::vector<Case> every_case() {
  std::vector<Case> cases;
  for (const ElementType type : {ElementType::trim3, ElementType::trimc6, ElementType::quam4,
                                 ElementType::quamc8, ElementType::quamc9}) {
    for (const bool shaft : {false, true}) {
      for (const auto shape : {model::BearingShape::cosine, model::BearingShape::uniform}) {
        cases.push_back({type, shaft, shape});
      }
    }
  }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(load, Bearing, testing::ValuesIn(every_case()), [](const auto& c) {
  return std::string(base::element_info(c.param.type).name) + (c.param.shaft ? "_shaft" : "_bore") +
         (c.param.shape == model::BearingShape::cosine ? "_cosine" : "_uniform");
});

TEST_P(Bearing, circle_is_found) {
  std::vector<geometry::WeightedPoint> points;
  for (const model::Face& face : model.mesh.set_with_id(load.faces).faces) {
    for (const base::NodeId n : model::side_nodes(model.mesh, face)) {
      points.push_back({model.mesh.x[n.index()].head<2>(), 1.0});
    }
  }
  const geometry::FittedCircle circle = geometry::fit_circle(points);
  EXPECT_LT((circle.centre - centre).norm(), 1e-11);
  EXPECT_NEAR(circle.radius, radius, 1e-11);
}

TEST_P(Bearing, resultant_is_exact_and_without_moment) {
  for (const double angle : {0.0, 0.37, 1.0, 2.0, 4.5, 0.5 * std::numbers::pi}) {
    const Vec2 F = 97100.0 * Vec2(std::cos(angle), std::sin(angle));
    const Vector f = apply(F);
    EXPECT_LT((sum(f) - F).norm(), 1e-13 * F.norm()) << angle;
    EXPECT_NEAR(moment_about_centre(f), 0.0, 1e-13 * F.norm() * radius) << angle;
  }
}

TEST_P(Bearing, pushes_on_the_loaded_half_only) {
  const Vec2 d(std::cos(0.37), std::sin(0.37));
  const Vector f = apply(1000.0 * d);
  const double side = GetParam().shaft ? -1.0 : 1.0;
  const double element = 2.0 * std::numbers::pi * radius / 24.0;
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    const Vec2 arm = model.mesh.x[n].head<2>() - centre;
    if (side * arm.dot(d) < -element) {
      EXPECT_EQ(f.segment<2>(2 * static_cast<Eigen::Index>(n)).norm(), 0.0);
    }
  }
}

// Work of the load on a smooth field against the closed form: on u = (e_r . d) e_r, side * arm
// outwards, cosine p = 2F/(pi R t) cos gives F integral 2/pi cos^2 = F; uniform p = F/(2 R t)
// gives F.  On u = (e_r . d)^2 e_r they give 8 F/(3 pi) and pi F/4.
TEST_P(Bearing, has_the_shape_asked_for) {
  const double F = 1000.0;
  const Vec2 d(std::cos(2.1), std::sin(2.1));
  const Vector f = apply(F * d);
  double first = 0.0;
  double second = 0.0;
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    const Vec2 e = (GetParam().shaft ? -1.0 : 1.0) * (model.mesh.x[n].head<2>() - centre) / radius;
    const double work = e.dot(f.segment<2>(2 * static_cast<Eigen::Index>(n)));
    first += e.dot(d) * work;
    second += e.dot(d) * e.dot(d) * work;
  }
  const bool cosine = GetParam().shape == model::BearingShape::cosine;
  // The field is interpolated over 15 deg.
  const double tolerance = base::element_info(GetParam().type).quadratic ? 2e-4 * F : 2e-2 * F;
  EXPECT_NEAR(first, F, tolerance);
  EXPECT_NEAR(second, (cosine ? 8.0 / (3.0 * std::numbers::pi) : 0.25 * std::numbers::pi) * F,
              tolerance);
}

TEST_P(Bearing, half_a_bore_is_enough_and_the_other_half_too_little) {
  const double side = GetParam().shaft ? -1.0 : 1.0;
  load.faces = on_circle([&](const Vec2& arm) { return side * arm.y() > -0.2 * radius; });
  const Vec2 up(0.0, 1000.0);
  EXPECT_LT((sum(apply(up)) - up).norm(), 1e-10);

  load.faces = on_circle([&](const Vec2& arm) { return side * arm.y() < -0.2 * radius; });
  load.value = {CompiledExpression::make_constant(0.0), CompiledExpression::make_constant(1000.0)};
  const auto visit = [](const auto& /*face*/, const auto& /*points*/) { ADD_FAILURE(); };
  EXPECT_FALSE(for_bearing_points(model, model.mesh, load, visit));
}

// Turning load and mesh together turns the forces: no direction is special, cuts included.
TEST_P(Bearing, does_not_depend_on_the_direction) {
  const double step = 2.0 * std::numbers::pi / 24.0;
  const double angle = 0.1 + 0.4 * step;
  const Vector f = apply(Vec2(std::cos(angle), std::sin(angle)));
  const Vector g = apply(Vec2(std::cos(angle + step), std::sin(angle + step)));
  std::vector<double> a;
  std::vector<double> b;
  for (Eigen::Index i = 0; i < f.size(); i += 2) {
    a.push_back(f.segment<2>(i).norm());
    b.push_back(g.segment<2>(i).norm());
  }
  std::ranges::sort(a);
  std::ranges::sort(b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i], b[i], 1e-13);
  }
}

// Edges are divided where the pressure ends, so that nodal forces follow the direction smoothly;
// quadrature points that enter and leave would make them jump.
TEST_P(Bearing, follows_the_direction_without_jumps) {
  const double step = 2.0 * std::numbers::pi / 24.0 / 400.0;
  Vector last = apply(Vec2(1.0, 0.0));
  for (int k = 1; k <= 400; ++k) {
    const Vector now = apply(Vec2(std::cos(k * step), std::sin(k * step)));
    EXPECT_LT((now - last).norm(), 2.0 * step) << k;
    last = now;
  }
}

} // namespace
} // namespace spricka::fe::test_bearing
