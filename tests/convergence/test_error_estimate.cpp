// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/error_estimate.hpp"
#include "tests/convergence/manufactured.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

// The estimated error in energy against the true one on manufactured problems: their ratio, the
// effectivity, tends to 1.
namespace spricka::test::test_error_estimate {
namespace {

using base::ElementType;
using base::Vec3;
using model::StressState;

double effectivity(const Manufactured& m) {
  const std::vector<double> e = fe::estimate_error(m.model, m.model.mesh, m.u).energy;
  // error_norms integrates eps D eps, twice the energy.
  return std::sqrt(2.0 * std::accumulate(e.begin(), e.end(), 0.0)) /
         error_norms(m.model, m.u, m.exact).energy;
}

void expect_good(const std::vector<double>& found) {
  std::string all;
  for (const double theta : found) {
    all += std::to_string(theta) + " ";
  }
  testing::Test::RecordProperty("effectivity", all);
  SCOPED_TRACE(all);
  EXPECT_NEAR(found.front(), 1.0, 0.2);
  EXPECT_NEAR(found.back(), 1.0, 0.1);
}

class PlaneEstimate : public testing::TestWithParam<std::tuple<ElementType, StressState>> {};

INSTANTIATE_TEST_SUITE_P(
    convergence, PlaneEstimate,
    testing::Combine(testing::Values(ElementType::trim3, ElementType::trimc6, ElementType::quam4,
                                     ElementType::quamc8, ElementType::quamc9),
                     testing::Values(StressState::plane_stress, StressState::plane_strain,
                                     StressState::axisymmetric)),
    [](const auto& c) {
      const StressState state = std::get<1>(c.param);
      return std::string(base::element_info(std::get<0>(c.param)).name) +
             (state == StressState::plane_stress   ? "_stress"
              : state == StressState::plane_strain ? "_strain"
                                                   : "_ring");
    });

TEST_P(PlaneEstimate, tends_to_the_error) {
  const auto [type, state] = GetParam();
  std::vector<double> found;
  for (const int n : {6, 12, 24}) {
    found.push_back(effectivity(manufactured_plane(type, state, n)));
  }
  expect_good(found);
  EXPECT_NEAR(found.back(), 1.0, 0.05);
}

class SolidEstimate : public testing::TestWithParam<ElementType> {};

INSTANTIATE_TEST_SUITE_P(convergence, SolidEstimate,
                         testing::Values(ElementType::tet4, ElementType::tet10, ElementType::penta6,
                                         ElementType::pentac15, ElementType::hexe8,
                                         ElementType::hexec20, ElementType::hexec27),
                         [](const auto& c) {
                           return std::string(base::element_info(c.param).name);
                         });

TEST_P(SolidEstimate, tends_to_the_error) {
  const bool quadratic = base::element_info(GetParam()).quadratic;
  std::vector<double> found;
  for (const int n : quadratic ? std::vector<int>{3, 5} : std::vector<int>{4, 8}) {
    found.push_back(effectivity(manufactured_solid(GetParam(), 0.3, Vec3(1.0, -2.0, 0.5), n)));
  }
  expect_good(found);
}

} // namespace
} // namespace spricka::test::test_error_estimate
