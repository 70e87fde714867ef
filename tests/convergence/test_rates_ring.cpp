// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/law.hpp"
#include "tests/convergence/error_norm.hpp"
#include "tests/unit/fe/field.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Rates about an axis on u = (sin x sin y, 2 cos x cos y), which is smooth on the axis too. With
// s = sin x / x and q = ds/dx = (cos x - s) / x its volume change is (s - cos x) sin y, and the
// body force is
//     b_x = -((lambda - mu) sin x + (lambda + 2 mu) q) sin y
//     b_y = ((lambda + 5 mu) cos x + (mu - lambda) s) cos y.
namespace spricka::test {
namespace {

using base::ElementType;

// A quarter ring from the axis on, with bent lines inside.
Vec2 bent_ring(const Vec2& p) {
  const double bump =
      0.04 * std::sin(2.0 * std::numbers::pi * p.x()) * std::sin(2.0 * std::numbers::pi * p.y());
  const double angle = 0.5 * std::numbers::pi * (1.0 - p.x() - bump);
  return (1.0 + p.y() + bump) * Vec2(std::cos(angle), std::sin(angle));
}

bool on_rim(const Vec3& x) {
  const double r = x.norm();
  return std::min({x.x(), x.y(), r - 1.0, 2.0 - r}) < 1e-9;
}

const ExactField exact{
    [](const Vec3& x) {
      return Vec3(std::sin(x.x()) * std::sin(x.y()), 2.0 * std::cos(x.x()) * std::cos(x.y()), 0.0);
    },
    [](const Vec3& x) {
      Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
      H.topLeftCorner<2, 2>() << std::cos(x.x()) * std::sin(x.y()),
          std::sin(x.x()) * std::cos(x.y()), -2.0 * std::sin(x.x()) * std::cos(x.y()),
          -2.0 * std::cos(x.x()) * std::sin(x.y());
      return H;
    }};

ErrorNorms run(ElementType type, int n) {
  model::Model model = plane_model(1.0, 0.3, model::State::axisymmetric);
  model.mesh = make_mesh(type, unit_grid(n, n), bent_ring);
  for (Vec3& x : model.mesh.x) { // cos(pi / 2) is not quite zero
    x.x() = std::abs(x.x()) < 1e-12 ? 0.0 : x.x();
  }
  set_freedom(model, model::FreedomClass::prescribed, on_rim, true, true);
  const fe::Law k = fe::law_of(model.materials[0], model.properties[0], type);
  const Field s = sin(x_field) / x_field;
  const Field q = (cos(x_field) - s) / x_field;
  model::Load body;
  body.type = model::LoadType::body;
  body.elements = all_elements(model);
  body.value = {
      (((k.mu - k.lambda) * sin(x_field) - (k.lambda + 2.0 * k.mu) * q) * sin(y_field)).code,
      (((k.lambda + 5.0 * k.mu) * cos(x_field) + (k.mu - k.lambda) * s) * cos(y_field)).code};
  model::Load rim;
  rim.type = model::LoadType::displacement;
  rim.nodes = node_set(model, on_rim);
  rim.value = {(sin(x_field) * sin(y_field)).code, (2.0 * (cos(x_field) * cos(y_field))).code};
  return error_norms(model, solve(model, {"", {body, rim}}), exact);
}

class RingRates : public testing::TestWithParam<ElementType> {};

INSTANTIATE_TEST_SUITE_P(convergence, RingRates,
                         testing::Values(ElementType::trim3, ElementType::trimc6,
                                         ElementType::quam4, ElementType::quamc8,
                                         ElementType::quamc9),
                         [](const auto& c) { return std::string(base::info(c.param).name); });

TEST_P(RingRates, are_those_of_the_theory) {
  const ElementType type = GetParam();
  const double p = base::info(type).quadratic ? 2.0 : 1.0;
  std::vector<double> L2;
  std::vector<double> energy;
  const int coarsest = type == ElementType::trim3 ? 20 : 8;
  for (const int n : {coarsest, 2 * coarsest, 4 * coarsest}) {
    const ErrorNorms error = run(type, n);
    L2.push_back(error.L2);
    energy.push_back(error.energy);
  }
  RecordProperty("L2", std::to_string(slope(L2)));
  RecordProperty("energy", std::to_string(slope(energy)));
  EXPECT_NEAR(slope(L2), p + 1.0, 0.1);
  EXPECT_NEAR(slope(energy), p, 0.1);
}

} // namespace
} // namespace spricka::test
