// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/growth_integrator.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace spricka::test_growth_integrator_steps {
namespace {

using growth::TipStation;

constexpr double initial_arm = 1.0;
constexpr double last_arm = 3.0;

/// A crack without a mesh. It never goes on by less than a part of its arm, as an axis of an
/// ellipse that waits outside of the body and then jumps.
class JumpingKinematics final : public growth::CrackKinematics {
public:
  explicit JumpingKinematics(double least) : least_(least) { tips_.push_back({.name = "C"}); }

  [[nodiscard]] bool can_kink() const override { return false; }
  void resume_from(const growth::GrowthState& /*state*/) override {}
  [[nodiscard]] growth::CrackGeometry current_cracks() override { return at(initial_arm); }
  [[nodiscard]] double initial_tip_extent(std::size_t /*tip*/) const override {
    return initial_arm;
  }
  [[nodiscard]] double remaining_growth_length(const growth::GrowthState& state,
                                               std::size_t tip) const override {
    return last_arm - state.stations.back().tips[tip].a;
  }
  [[nodiscard]] growth::AdvanceLimit advance_limit(const growth::GrowthState& state,
                                                   std::size_t tip, double share,
                                                   double ds) const override {
    return {.ds = std::min(ds, remaining_growth_length(state, tip) / share)};
  }
  bool smooth_advances(const growth::GrowthState& state, std::vector<double>& by) const override {
    by[0] = std::max(by[0], std::min(least_ * state.stations.back().tips[0].a,
                                     remaining_growth_length(state, 0)));
    return true;
  }
  std::optional<growth::CrackGeometry> advance_cracks(const growth::GrowthState& state,
                                                      const growth::AdvanceToNextStation& advance,
                                                      base::Diagnostics& /*diagnostics*/) override {
    return at(state.stations.back().tips[0].a + advance.by[0]);
  }
  void evaluate_trial_tips(std::vector<TipStation>& /*found*/) const override {}
  void accept_trial(growth::GrowthState& /*state*/) override {}
  [[nodiscard]] std::optional<growth::GrowthEvent>
  handle_unmeshable_advance(bool /*passage*/, const std::string& why) override {
    return growth::GrowthEvent{.reason = why};
  }

private:
  static growth::CrackGeometry at(double arm) {
    growth::CrackGeometry state;
    state.aims.emplace_back(arm, 0.0, 0.0);
    return state;
  }

  double least_;
};

struct Marched {
  int solved = 0;
  bool ended = false;
  std::size_t stations = 0;
};

// K waves within each jump: all of them miss a tolerance of 1e-6.
Marched march_to_the_end(double least) {
  model::Model model;
  model.growth.emplace();
  model.growth->law = model::CrackGrowthLaw::paris;
  model.growth->tolerance = 1e-6;
  model.growth->last_length = last_arm;
  const growth::GrowthRateFunction paris = [](double K_max, double K_min,
                                              const model::PlaceOnCrack& /*place*/) {
    return 1e-3 * std::pow(K_max - K_min, 3);
  };
  growth::GrowthIntegrator march(model, paris, std::make_unique<JumpingKinematics>(least), {});
  Marched marched;
  base::Diagnostics diagnostics;
  while (marched.solved < 300) {
    const std::optional<growth::CrackGeometry> state = march.propose_next_cracks(diagnostics);
    if (!state) {
      break;
    }
    const double a = state->aims[0].x();
    std::vector<TipStation> found(1);
    found[0].K_max = 1.0 + 0.5 * std::sin(20.0 * a);
    found[0].rate = paris(found[0].K_max, 0.0, {});
    march.accept_or_reject_station(std::move(found));
    ++marched.solved;
  }
  marched.ended = march.growth_end().has_value();
  marched.stations = march.growth_state().stations.size();
  return marched;
}

// A refused advance is asked for shorter than it was asked for, whatever the ways made of it: else
// it comes back as it was, for ever.
TEST(GrowthIntegrator, EndsWhereWaysGoFartherThanTheyAreAsked) {
  const Marched marched = march_to_the_end(0.3);
  EXPECT_TRUE(marched.ended) << marched.solved << " solved, " << marched.stations << " stations";
}

TEST(WayCurvature, IsTheTurnOverTheAdvance) {
  const TipStation before{.a = 1.0, .heading = 3.0};
  EXPECT_NEAR(growth::tip_path_curvature(before, {.a = 1.5, .heading = 3.1}), 0.2, 1e-12);
  // Headings on both sides of the negative x axis are near to each other.
  EXPECT_NEAR(growth::tip_path_curvature(before, {.a = 1.5, .heading = -3.0}),
              2.0 * (2.0 * std::acos(-1.0) - 6.0), 1e-12);
  // A tip that rests and turns does not hold the step of the others.
  EXPECT_EQ(growth::tip_path_curvature(before, {.a = 1.0, .heading = 2.0}), 0.0);
}

} // namespace
} // namespace spricka::test_growth_integrator_steps
