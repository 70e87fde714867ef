// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/williams.hpp"
#include "fe/element.hpp"
#include "tests/unit/crack/near_tip.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::test_williams {
namespace {

using crack::TipFrame;

TipFrame turned(double angle) {
  TipFrame tip;
  tip.x = {0.3, -0.2};
  tip.e1 = {std::cos(angle), std::sin(angle)};
  tip.e2 = {-std::sin(angle), std::cos(angle)};
  return tip;
}

class Williams : public testing::TestWithParam<std::tuple<int, model::StressState>> {
protected:
  [[nodiscard]] int mode() const { return std::get<0>(GetParam()); }
  [[nodiscard]] model::StressState state() const { return std::get<1>(GetParam()); }
  [[nodiscard]] Eigen::Matrix2d stress(const TipFrame& tip, const base::Vec2& x) const {
    const Eigen::Matrix2d H = test::near_tip_gradient(tip, x, mode(), material, state());
    const fe::Strain<2> s = fe::elasticity<2>(material, state()) * fe::strain<2>(H);
    return fe::stress_tensor<2>(s);
  }
  model::ElasticMaterial material{"M", 210.0, 0.3, 0.0, 0.0, {}};
};

TEST_P(Williams, GradientIsTheDerivativeOfTheDisplacement) {
  const TipFrame tip = turned(0.7);
  for (const double angle : {-2.9, -1.0, 0.2, 1.7, 3.0}) {
    const base::Vec2 x = tip.x + 0.8 * (std::cos(angle) * tip.e1 + std::sin(angle) * tip.e2);
    const Eigen::Matrix2d H = test::near_tip_gradient(tip, x, mode(), material, state());
    const double h = 1e-6;
    for (int j = 0; j < 2; ++j) {
      const base::Vec2 d = h * base::Vec2::Unit(j);
      const base::Vec2 difference =
          (test::near_tip_displacement(tip, x + d, mode(), material, state()) -
           test::near_tip_displacement(tip, x - d, mode(), material, state())) /
          (2.0 * h);
      EXPECT_LT((difference - H.col(j)).norm(), 1e-8 * H.norm());
    }
  }
}

TEST_P(Williams, StressIsInEquilibrium) {
  const TipFrame tip = turned(-0.4);
  const base::Vec2 x = tip.x + base::Vec2(0.5, 0.6);
  const double h = 1e-5;
  base::Vec2 divergence = base::Vec2::Zero();
  for (int j = 0; j < 2; ++j) {
    const base::Vec2 d = h * base::Vec2::Unit(j);
    divergence += (stress(tip, x + d) - stress(tip, x - d)).col(j) / (2.0 * h);
  }
  EXPECT_LT(divergence.norm(), 1e-7 * stress(tip, x).norm());
}

// Ahead of the tip s22 (mode 1) or s12 (mode 2) is K / sqrt(2 pi r); the faces are free.
TEST_P(Williams, StressAheadDefinesK) {
  const TipFrame tip = turned(1.1);
  Eigen::Matrix2d Q;
  Q << tip.e1, tip.e2;
  const double r = 0.02;
  const Eigen::Matrix2d ahead = Q.transpose() * stress(tip, tip.x + r * tip.e1) * Q;
  const double K = 1.0 / std::sqrt(2.0 * std::numbers::pi * r);
  EXPECT_NEAR(ahead(1, 1), mode() == 1 ? K : 0.0, 1e-12 * K);
  EXPECT_NEAR(ahead(0, 1), mode() == 2 ? K : 0.0, 1e-12 * K);
  const base::Vec2 face = tip.x - r * tip.e1 + 1e-14 * tip.e2;
  EXPECT_LT((stress(tip, face) * tip.e2).norm(), 1e-9 * K);
}

INSTANTIATE_TEST_SUITE_P(Modes, Williams,
                         testing::Combine(testing::Values(1, 2),
                                          testing::Values(model::StressState::plane_stress,
                                                          model::StressState::plane_strain)));

} // namespace
} // namespace spricka::test_williams
