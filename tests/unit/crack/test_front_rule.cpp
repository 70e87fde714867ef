// SPDX-License-Identifier: GPL-3.0-or-later
// How finely the integrals of K along a front are summed.
#include "crack/front_intensity.hpp"
#include "crack/front_rule.hpp"
#include "crack/moving_field.hpp"
#include "tests/unit/crack/front_tube.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace spricka::test_front_rule {
namespace {

using base::Vec3;
using test::Tube;

struct RuledPenny : testing::Test {
  Tube tube{test::penny_front(1.0), {.segments = 24, .radii = {0.03, 0.06, 0.12, 0.19}}};

  [[nodiscard]] bool at_front(base::ElementId e) const {
    return std::ranges::any_of(tube.mesh().element_nodes(e), [&](base::NodeId n) {
      const Vec3& x = tube.mesh().x[n.index()];
      return std::hypot(std::hypot(x.x(), x.y()) - 1.0, x.z()) < 1e-3;
    });
  }
  [[nodiscard]] std::vector<crack::StressIntensity>
  K(const crack::FrontIntegralDomains& fields) const {
    const base::Vector u = tube.at_nodes([](const Vec3& x, crack::UpperOrLowerFace side) -> Vec3 {
      constexpr double mu = 1000.0 / 2.6;
      return test::pressed_penny(x, side, mu, 0.3) + test::sheared_penny(x, side, mu, 0.3);
    });
    return crack::front_intensity(tube.model, tube.cracked, tube.front(), fields, {}, u, {});
  }
};

TEST_F(RuledPenny, IsFineAtTheFrontAndCoarserAway) {
  const crack::FrontIntegralDomains fields = tube.fields({2, 3});
  std::size_t near = 0;
  for (const auto& [e, degree] : fields.degree) {
    EXPECT_EQ(degree == crack::front_degree, at_front(e)) << e.index();
    near += at_front(e) ? 1U : 0U;
  }
  EXPECT_GT(near, 0U);
  EXPECT_LT(near, fields.degree.size());
}

TEST_F(RuledPenny, FinerRulesAwayFromTheFrontLeaveKAlone) {
  const std::vector<crack::StressIntensity> own = K(tube.fields({2, 3}));
  crack::FrontIntegralDomains finer = tube.fields({2, 3});
  for (auto& [e, degree] : finer.degree) {
    degree = at_front(e) ? degree : 13;
  }
  const std::vector<crack::StressIntensity> fine = K(finer);
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_NEAR(own[i].K1, fine[i].K1, 2e-5 * fine[i].K1);
    EXPECT_NEAR(own[i].K2, fine[i].K2, 2e-5 * fine[i].K1);
    EXPECT_NEAR(own[i].K3, fine[i].K3, 2e-5 * fine[i].K1);
  }
}

// The sharp end of an ellipse, with a tube that reaches to nearly 0.6 of the radius of
// curvature there: the partners' derivatives have no bound at the centres of curvature.
struct RuledBend : testing::Test {
  Tube tube{test::ellipse_front(1.0, 0.5, 1.0),
            {.segments = 48, .radii = {0.023, 0.046, 0.093, 0.147}}};
  crack::FrontIntegralDomains own = tube.fields({2, 3});
};

TEST_F(RuledBend, IsFinerTowardsTheCentresOfCurvature) {
  const auto degree_at = [&](const Vec3& x) {
    int degree = 0;
    double least = 1.0;
    for (const auto& [e, of_rule] : own.degree) {
      Vec3 centre = Vec3::Zero();
      for (const base::NodeId n : tube.mesh().element_nodes(e)) {
        centre += tube.mesh().x[n.index()] / 20.0;
      }
      if ((centre - x).norm() < least) {
        least = (centre - x).norm();
        degree = of_rule;
      }
    }
    return degree;
  };
  constexpr double across = 0.12; // amid the outermost ring
  EXPECT_GT(degree_at({1.0 - across, 0.0, 0.0}), degree_at({1.0 + across, 0.0, 0.0}));
}

// The near fields of the front as displacements: what a finer rule would change is little beside
// the 30 % by which these elements miss K2 and K3 here, and 0.8 % if the centres did not count.
TEST_F(RuledBend, FinerRulesLeaveKAlone) {
  const crack::FrontAxes axes(*tube.front().curve);
  const fe::LameConstants k =
      fe::lame_constants(tube.model.materials[0], model::StressState::solid);
  const crack::FrontBody body{k.lambda, k.mu, tube.model.materials[0].nu, 1.0};
  const base::Vector u = tube.at_nodes([&](const Vec3& x, crack::UpperOrLowerFace side) -> Vec3 {
    const crack::FrontCoordinates at = axes.locate_point(x, side);
    Vec3 sum = Vec3::Zero();
    for (std::size_t m = 1; m <= 3 && at.r > 1e-12; ++m) {
      sum += crack::section_field(m, {at.r, at.theta}, body).w;
    }
    return sum.x() * at.frame.m + sum.y() * at.frame.b + sum.z() * at.frame.t;
  });
  const auto K = [&](const crack::FrontIntegralDomains& fields) {
    return crack::front_intensity(tube.model, tube.cracked, tube.front(), fields, {}, u, {});
  };
  crack::FrontIntegralDomains finer = tube.fields({2, 3});
  for (auto& [e, degree] : finer.degree) {
    degree = 15;
  }
  const std::vector<crack::StressIntensity> ours = K(own);
  const std::vector<crack::StressIntensity> fine = K(finer);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_NEAR(ours[i].K1, fine[i].K1, 3e-4);
    EXPECT_NEAR(ours[i].K2, fine[i].K2, 3e-3);
    EXPECT_NEAR(ours[i].K3, fine[i].K3, 7e-3);
  }
}

} // namespace
} // namespace spricka::test_front_rule
