// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/elasticity.hpp"
#include "tests/convergence/error_norm.hpp"
#include "tests/unit/fe/field.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Rates on a smooth manufactured solution: u = (sin x sin y, 2 cos x cos y). Its divergence is
// -cos x sin y, so that the body force is b = ((mu - lambda) sin x sin y, (lambda + 5 mu) cos x
// cos y). Displacements are prescribed all round.
namespace spricka::test {
namespace {

using base::ElementType;
using model::State;

// Quarter ring 1 <= r <= 2 whose inner lines are bent: sides are curved, elements distorted.
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

const Exact exact{
    [](const Vec2& x) {
      return Vec2(std::sin(x.x()) * std::sin(x.y()), 2.0 * std::cos(x.x()) * std::cos(x.y()));
    },
    [](const Vec2& x) {
      Eigen::Matrix2d H;
      H << std::cos(x.x()) * std::sin(x.y()), std::sin(x.x()) * std::cos(x.y()),
          -2.0 * std::sin(x.x()) * std::cos(x.y()), -2.0 * std::cos(x.x()) * std::sin(x.y());
      return H;
    }};

struct Result {
  ErrorNorms solution;
  ErrorNorms interpolation;
};

Result run(ElementType type, State state, int n) {
  model::Model model = plane_model(1.0, 0.3, state);
  model.mesh = make_mesh(type, unit_grid(n, n), bent_ring);
  set_freedom(model, model::FreedomClass::prescribed, on_rim, true, true);
  const fe::Lame k = fe::lame(model.materials[0], state);
  const Field ss = sin(x_field) * sin(y_field);
  const Field cc = cos(x_field) * cos(y_field);
  model::Load body;
  body.type = model::LoadType::body;
  body.elements = all_elements(model);
  body.value = {((k.mu - k.lambda) * ss).code, ((k.lambda + 5.0 * k.mu) * cc).code};
  model::Load rim;
  rim.type = model::LoadType::displacement;
  rim.nodes = node_set(model, on_rim);
  rim.value = {ss.code, (2.0 * cc).code};

  base::Vector interpolant(2 * static_cast<Eigen::Index>(model.mesh.node_count()));
  for (std::size_t i = 0; i < model.mesh.node_count(); ++i) {
    interpolant.segment<2>(2 * static_cast<Eigen::Index>(i)) = exact.u(model.mesh.x[i].head<2>());
  }
  return {error_norms(model, solve(model, {"", {body, rim}}), exact),
          error_norms(model, interpolant, exact)};
}

class Rates : public testing::TestWithParam<std::tuple<ElementType, State>> {};

INSTANTIATE_TEST_SUITE_P(
    convergence, Rates,
    testing::Combine(testing::Values(ElementType::trim3, ElementType::trimc6, ElementType::quam4,
                                     ElementType::quamc8, ElementType::quamc9),
                     testing::Values(State::plane_stress, State::plane_strain)),
    [](const auto& c) {
      return std::string(base::info(std::get<0>(c.param)).name) +
             (std::get<1>(c.param) == State::plane_stress ? "_stress" : "_strain");
    });

TEST_P(Rates, are_those_of_the_theory) {
  const auto [type, state] = GetParam();
  const double p = base::info(type).quadratic ? 2.0 : 1.0;
  std::vector<double> L2;
  std::vector<double> energy;
  Result last;
  // Constant strain takes longer to reach its rate.
  const int coarsest = type == ElementType::trim3 ? 20 : 8;
  for (const int n : {coarsest, 2 * coarsest, 4 * coarsest}) {
    last = run(type, state, n);
    L2.push_back(last.solution.L2);
    energy.push_back(last.solution.energy);
  }
  EXPECT_NEAR(slope(L2), p + 1.0, 0.1);
  EXPECT_NEAR(slope(energy), p, 0.1);
  // The solution is the best approximation in energy among all with its values on the rim, of
  // which the interpolant is one; but for integration on curved elements.
  EXPECT_LT(last.solution.energy, 1.001 * last.interpolation.energy);
  EXPECT_LT(last.solution.L2, 3.0 * last.interpolation.L2);
}

} // namespace
} // namespace spricka::test
