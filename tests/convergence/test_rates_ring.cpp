// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/convergence/manufactured.hpp"

#include <gtest/gtest.h>

// Rates on a smooth manufactured solution about an axis, on the axis too.
namespace spricka::test::test_rates_ring {
namespace {

using base::ElementType;

class RingRates : public testing::TestWithParam<ElementType> {};

INSTANTIATE_TEST_SUITE_P(convergence, RingRates,
                         testing::Values(ElementType::trim3, ElementType::trimc6,
                                         ElementType::quam4, ElementType::quamc8,
                                         ElementType::quamc9),
                         [](const auto& c) {
                           return std::string(base::element_info(c.param).name);
                         });

TEST_P(RingRates, are_those_of_the_theory) {
  const ElementType type = GetParam();
  const double p = base::element_info(type).quadratic ? 2.0 : 1.0;
  std::vector<double> L2;
  std::vector<double> energy;
  const int coarsest = type == ElementType::trim3 ? 20 : 8;
  for (const int n : {coarsest, 2 * coarsest, 4 * coarsest}) {
    const Manufactured m = manufactured_plane(type, model::StressState::axisymmetric, n);
    const ErrorNorms error = error_norms(m.model, m.u, m.exact);
    L2.push_back(error.L2);
    energy.push_back(error.energy);
  }
  RecordProperty("L2", std::to_string(slope(L2)));
  RecordProperty("energy", std::to_string(slope(energy)));
  EXPECT_NEAR(slope(L2), p + 1.0, 0.1);
  EXPECT_NEAR(slope(energy), p, 0.1);
}

} // namespace
} // namespace spricka::test::test_rates_ring
