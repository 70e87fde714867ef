// SPDX-License-Identifier: GPL-3.0-or-later
// How finely the integrals of K along a front are summed.
#include "crack/space/front_rule.hpp"
#include "tests/unit/crack/front_tube.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace spricka {
namespace {

using base::Vec3;
using test::Tube;

struct RuledPenny : testing::Test {
  Tube tube{test::penny_front(1.0), {.segments = 24, .radii = {0.05, 0.1, 0.15, 0.2}}};

  [[nodiscard]] bool at_front(base::ElementId e) const {
    return std::ranges::any_of(tube.mesh().nodes_of(e), [&](base::NodeId n) {
      const Vec3& x = tube.mesh().x[n.index()];
      return std::hypot(std::hypot(x.x(), x.y()) - 1.0, x.z()) < 1e-3;
    });
  }
  [[nodiscard]] std::vector<crack::StressIntensity> K(const crack::FrontFields& fields) const {
    const base::Vector u = tube.at_nodes([](const Vec3& x, crack::FaceSide side) -> Vec3 {
      constexpr double mu = 1000.0 / 2.6;
      return test::pressed_penny(x, side, mu, 0.3) + test::sheared_penny(x, side, mu, 0.3);
    });
    return crack::front_intensity(tube.model, tube.cracked, tube.front(), fields, {}, u, {});
  }
};

TEST_F(RuledPenny, IsFineAtTheFrontAndCoarserAway) {
  const crack::FrontFields fields = tube.fields({2, 3});
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
  crack::FrontFields finer = tube.fields({2, 3});
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

} // namespace
} // namespace spricka
