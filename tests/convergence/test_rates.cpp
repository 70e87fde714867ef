// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/convergence/manufactured.hpp"

#include <gtest/gtest.h>

// Rates on a smooth manufactured solution in the plane.
namespace spricka::test::test_rates {
namespace {

using base::ElementType;
using model::StressState;

struct Result {
  ErrorNorms solution;
  ErrorNorms interpolation;
};

Result run(ElementType type, StressState state, int n) {
  const Manufactured m = manufactured_plane(type, state, n);
  base::Vector interpolant(m.u.size());
  for (std::size_t i = 0; i < m.model.mesh.node_count(); ++i) {
    interpolant.segment<2>(2 * static_cast<Eigen::Index>(i)) =
        m.exact.u(m.model.mesh.x[i]).head<2>();
  }
  return {error_norms(m.model, m.u, m.exact), error_norms(m.model, interpolant, m.exact)};
}

class LoadAndGapRates : public testing::TestWithParam<std::tuple<ElementType, StressState>> {};

INSTANTIATE_TEST_SUITE_P(
    convergence, LoadAndGapRates,
    testing::Combine(testing::Values(ElementType::trim3, ElementType::trimc6, ElementType::quam4,
                                     ElementType::quamc8, ElementType::quamc9),
                     testing::Values(StressState::plane_stress, StressState::plane_strain)),
    [](const auto& c) {
      return std::string(base::element_info(std::get<0>(c.param)).name) +
             (std::get<1>(c.param) == StressState::plane_stress ? "_stress" : "_strain");
    });

TEST_P(LoadAndGapRates, are_those_of_the_theory) {
  const auto [type, state] = GetParam();
  const double p = base::element_info(type).quadratic ? 2.0 : 1.0;
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
} // namespace spricka::test::test_rates
