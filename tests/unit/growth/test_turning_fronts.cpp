// SPDX-License-Identifier: GPL-3.0-or-later
#include "growing_block.hpp"
#include "growth/free_front_shape.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

/// Fronts that leave their plane by angles that a formula gives.
namespace spricka::test_turning_fronts {
namespace {

using namespace spricka::test;

constexpr double kink = 0.3;

Block block_with_penny() {
  Block block({-20, -20, -20}, {20, 20, 20}, 4);
  block.ellipse(Vec3::Zero(), 1.0, 1.0);
  block.model.growth->direction = model::GrowthDirection::hoop;
  block.model.growth->last_length = 1.5;
  block.model.growth->tolerance = 0.02;
  return block;
}

/// Turns by the kink at its first front, then straight on.
std::vector<TipStation> found_at(const growth::CrackGeometry& cracks, bool first) {
  std::vector<TipStation> found(cracks.aims.size());
  for (std::size_t tip = 0; tip < found.size(); ++tip) {
    found[tip].K_max = 100.0;
    found[tip].rate = paris(100.0, 0.0);
    found[tip].turn = first ? kink : 0.0;
  }
  return found;
}

double off_cone(const Vec3& x) {
  return x.z() - (std::hypot(x.x(), x.y()) - 1.0) * std::tan(kink);
}

TEST(TurningFronts, APennyBecomesACone) {
  const Block block = block_with_penny();
  growth::GrowthIntegrator march(block.model, paris,
                                 std::make_unique<growth::FreeFrontShape>(block.model), {});
  growth::CrackGeometry last;
  for (bool first = true; !march.growth_end(); first = false) {
    base::Diagnostics diagnostics;
    const auto cracks = march.propose_next_cracks(diagnostics);
    ASSERT_TRUE(cracks);
    last = *cracks;
    march.accept_or_reject_station(found_at(*cracks, first));
  }
  EXPECT_STREQ(march.growth_end()->word(), "AMAX");
  for (const Vec3& x : last.aims) {
    EXPECT_NEAR(off_cone(x), 0.0, 1e-4);
    EXPECT_NEAR((x - x.normalized()).norm(), 0.5, 0.03); // from the first front
  }
  const model::FrontHistory& wake = last.solids[0].front_history;
  ASSERT_EQ(wake.fronts.size(), march.growth_state().stations.size());
  for (const std::vector<Vec3>& front : wake.fronts) {
    EXPECT_EQ(front.front(), front.back());
    for (const Vec3& x : front) {
      EXPECT_NEAR(off_cone(x), 0.0, 1e-4);
    }
  }
  ASSERT_EQ(wake.normals.size(), wake.fronts.back().size());
  for (std::size_t i = 0; i < wake.normals.size(); ++i) {
    const Vec3 out = Vec3(wake.fronts.back()[i].x(), wake.fronts.back()[i].y(), 0.0).normalized();
    const Vec3 b = std::cos(kink) * Vec3::UnitZ() - std::sin(kink) * out;
    EXPECT_NEAR((wake.normals[i] - b).norm(), 0.0, 2e-3);
  }
}

TEST(TurningFronts, GoOnAsTheyWere) {
  const Block block = block_with_penny();
  const auto ways = [&] { return std::make_unique<growth::FreeFrontShape>(block.model); };
  growth::GrowthIntegrator march(block.model, paris, ways(), {});
  base::Diagnostics diagnostics;
  for (int k = 0; k < 3; ++k) {
    const auto cracks = march.propose_next_cracks(diagnostics);
    ASSERT_TRUE(cracks);
    march.accept_or_reject_station(found_at(*cracks, k == 0));
  }
  const growth::GrowthState kept =
      growth::growth_state_from_arrays(growth::growth_state_to_arrays(march.growth_state()));
  growth::GrowthIntegrator again(block.model, paris, ways(), kept);
  const auto one = march.propose_next_cracks(diagnostics);
  const auto other = again.propose_next_cracks(diagnostics);
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->aims, other->aims);
  EXPECT_EQ(one->solids[0].points, other->solids[0].points);
  EXPECT_EQ(one->solids[0].front_history.fronts, other->solids[0].front_history.fronts);
  EXPECT_EQ(one->solids[0].front_history.normals, other->solids[0].front_history.normals);
}

TEST(TurningFronts, EndWhereTheyStandOnTheirPlane) {
  const Block block = block_with_penny();
  growth::GrowthIntegrator march(block.model, paris,
                                 std::make_unique<growth::FreeFrontShape>(block.model), {});
  for (int k = 0; k < 40 && !march.growth_end(); ++k) {
    base::Diagnostics diagnostics;
    const auto cracks = march.propose_next_cracks(diagnostics);
    if (cracks) {
      march.accept_or_reject_station(found_at(*cracks, true)); // further at each front
    }
  }
  ASSERT_TRUE(march.growth_end());
  EXPECT_STREQ(march.growth_end()->word(), "CURL");
}

} // namespace
} // namespace spricka::test_turning_fronts
