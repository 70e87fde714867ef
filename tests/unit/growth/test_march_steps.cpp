// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/march.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace spricka::test_march_steps {
namespace {

using growth::TipStation;

constexpr double initial_arm = 1.0;
constexpr double last_arm = 3.0;

/// A crack without a mesh. It never goes on by less than a part of its arm, as an axis of an
/// ellipse that waits outside of the body and then jumps.
class JumpingWays final : public growth::Ways {
public:
  explicit JumpingWays(double least) : least_(least) {}

  [[nodiscard]] const std::vector<growth::GrowingTip>& tips() const override { return tips_; }
  [[nodiscard]] bool turns() const override { return false; }
  void go_on(const growth::State& /*state*/) override {}
  [[nodiscard]] growth::CrackState here() override { return at(initial_arm); }
  [[nodiscard]] double first_arm(std::size_t /*tip*/) const override { return initial_arm; }
  [[nodiscard]] double length_left(const growth::State& state, std::size_t tip) const override {
    return last_arm - state.stations.back().tips[tip].a;
  }
  [[nodiscard]] growth::WayLimit limit(const growth::State& state, std::size_t tip, double share,
                                       double ds) const override {
    return {.ds = std::min(ds, length_left(state, tip) / share)};
  }
  bool relax(const growth::State& state, std::vector<double>& by) const override {
    by[0] =
        std::max(by[0], std::min(least_ * state.stations.back().tips[0].a, length_left(state, 0)));
    return true;
  }
  std::optional<growth::CrackState> advanced(const growth::State& state,
                                             const growth::Advance& advance,
                                             base::Diagnostics& /*diagnostics*/) override {
    return at(state.stations.back().tips[0].a + advance.by[0]);
  }
  void place(std::vector<TipStation>& /*found*/) const override {}
  void settle(growth::State& /*state*/) override {}
  [[nodiscard]] std::optional<growth::WayEnd>
  refused(const growth::State& /*state*/, bool /*leapt*/, const std::string& why) override {
    return growth::WayEnd{"MESH", why};
  }
  [[nodiscard]] growth::CrackState straight_on(const growth::State& /*state*/,
                                               double /*advance*/) const override {
    return {};
  }

private:
  static growth::CrackState at(double arm) {
    growth::CrackState state;
    state.aims.emplace_back(arm, 0.0, 0.0);
    return state;
  }

  double least_;
  std::vector<growth::GrowingTip> tips_{{"C"}};
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
  const growth::Law paris = [](double K_max, double K_min) {
    return 1e-3 * std::pow(K_max - K_min, 3);
  };
  growth::March march(model, paris, std::make_unique<JumpingWays>(least), {});
  Marched marched;
  base::Diagnostics diagnostics;
  while (marched.solved < 300) {
    const std::optional<growth::CrackState> state = march.next(diagnostics);
    if (!state) {
      break;
    }
    const double a = state->aims[0].x();
    std::vector<TipStation> found(1);
    found[0].K_max = 1.0 + 0.5 * std::sin(20.0 * a);
    found[0].rate = paris(found[0].K_max, 0.0);
    march.take(std::move(found));
    ++marched.solved;
  }
  marched.ended = march.end().has_value();
  marched.stations = march.state().stations.size();
  return marched;
}

// A refused advance is asked for shorter than it was asked for, whatever the ways made of it: else
// it comes back as it was, for ever.
TEST(March, EndsWhereWaysGoFartherThanTheyAreAsked) {
  const Marched marched = march_to_the_end(0.3);
  EXPECT_TRUE(marched.ended) << marched.solved << " solved, " << marched.stations << " stations";
}

} // namespace
} // namespace spricka::test_march_steps
