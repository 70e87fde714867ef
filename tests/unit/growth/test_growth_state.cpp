// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/damaged_field.hpp"
#include "growth/growth_integrator.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace spricka::test_growth_state {
namespace {

using base::Vec3;
using growth::TipStation;

// All members of a state come back from its arrays.
TEST(GrowthState, ComesBackFromItsArrays) {
  growth::GrowthState state;
  state.step = 0.3;
  state.rejected = 2;
  state.stations.push_back(
      {.s = 1.0, .tips = {TipStation{.a = 1.0, .law_use = {.outside = 0.25}}}, .breakthroughs = 1});
  state.stations.push_back({.s = 2.0, .tips = {TipStation{.a = 2.0, .plastic = 0.5}}, .met = 3});
  growth::GrownCrack crack;
  crack.kind = model::CrackDefinitionKind::drawn;
  crack.points = {Vec3::Zero(), Vec3::UnitX()};
  crack.plane.closed = true;
  crack.plane.place = Vec3(1.0, 2.0, 3.0);
  crack.history.fronts = {{Vec3::Zero(), Vec3::UnitX()}, {Vec3::UnitY(), Vec3::UnitZ()}};
  crack.history.normals = {Vec3::UnitX(), Vec3::UnitY()};
  state.cracks = {crack, growth::GrownCrack()};
  state.tips.push_back({.crack = 1, .number = 4, .on_a = true, .sign = -1.0, .shared = true});
  const growth::GrowthState back =
      growth::growth_state_from_arrays(growth::growth_state_to_arrays(state));
  EXPECT_EQ(back.step, 0.3);
  EXPECT_EQ(back.rejected, 2);
  ASSERT_EQ(back.stations.size(), 2U);
  EXPECT_EQ(back.stations[0].breakthroughs, 1U);
  EXPECT_EQ(back.stations[1].met, 3U);
  ASSERT_EQ(back.stations[0].tips.size(), 1U);
  EXPECT_EQ(back.stations[0].tips[0].law_use.outside, 0.25);
  ASSERT_EQ(back.stations[1].tips.size(), 1U);
  EXPECT_EQ(back.stations[1].tips[0].plastic, 0.5);
  ASSERT_EQ(back.cracks.size(), 2U);
  EXPECT_EQ(back.cracks[0].kind, model::CrackDefinitionKind::drawn);
  EXPECT_EQ(back.cracks[0].points, crack.points);
  EXPECT_TRUE(back.cracks[0].plane.closed);
  EXPECT_EQ(back.cracks[0].plane.place, crack.plane.place);
  EXPECT_EQ(back.cracks[0].history.fronts, crack.history.fronts);
  EXPECT_EQ(back.cracks[0].history.normals, crack.history.normals);
  ASSERT_EQ(back.tips.size(), 1U);
  EXPECT_EQ(back.tips[0].number, 4U);
  EXPECT_EQ(back.tips[0].sign, -1.0);
  EXPECT_TRUE(back.tips[0].on_a && back.tips[0].shared && !back.tips[0].paired);
}

// K of all loads, of which lives are counted whose cycles act on each other.
TEST(GrowthState, KeepsKOverTheLoadPath) {
  growth::GrowthState state;
  TipStation tip{.a = 1.0};
  tip.K_over_path = base::PiecewiseLinear({0.0, 0.3, 1.0}, {1.0, 2.0}, {10.0 / 3.0, 0.1});
  TipStation followed{.a = 2.0};
  followed.cycles_of_K = {{0.5, 2.0, 3.0}, {-1.0, 1.0, 0.5}};
  state.stations.push_back({.s = 3.0, .tips = {tip, followed}});
  growth::NamedValueArrays arrays = growth::growth_state_to_arrays(state);
  const growth::GrowthState back = growth::growth_state_from_arrays(arrays);
  const std::vector<TipStation>& tips = back.stations.at(0).tips;
  EXPECT_EQ(tips.at(0).K_over_path.knots(), tip.K_over_path.knots());
  EXPECT_EQ(tips.at(0).K_over_path.segment_start_values(), tip.K_over_path.segment_start_values());
  EXPECT_EQ(tips.at(0).K_over_path.segment_slopes(), tip.K_over_path.segment_slopes());
  EXPECT_TRUE(tips.at(1).K_over_path.empty());
  ASSERT_EQ(tips.at(1).cycles_of_K.size(), 2U);
  EXPECT_EQ(tips.at(1).cycles_of_K[1].low, -1.0);
  EXPECT_EQ(tips.at(1).cycles_of_K[1].count, 0.5);
  arrays["path_segment.begin"] = {0.3, 0.0};
  EXPECT_THROW(growth::growth_state_from_arrays(arrays), base::CorruptStoredField);
}

TEST(GrowthState, NamesTheDamagedField) {
  growth::GrowthState state;
  state.stations.push_back({1.0, {TipStation{}}});
  state.cracks.emplace_back().points = {Vec3::Zero(), Vec3::UnitX()};
  state.tips.emplace_back();
  const growth::NamedValueArrays whole = growth::growth_state_to_arrays(state);
  const auto trouble = [&](const char* field, const std::vector<double>& values) {
    growth::NamedValueArrays arrays = whole;
    arrays[field] = values;
    try {
      growth::growth_state_from_arrays(arrays);
    } catch (const base::CorruptStoredField& damage) {
      return std::string(damage.what());
    }
    return std::string();
  };
  EXPECT_EQ(trouble("station.s", {1.0}), "");
  for (const char* field : {"station_tip.K_max", "crack.points", "growth.step", "tip.sign"}) {
    EXPECT_TRUE(trouble(field, {}).starts_with(field)) << trouble(field, {});
    EXPECT_TRUE(trouble(field, {1.0, 1.0}).starts_with(field)) << trouble(field, {1.0, 1.0});
  }
  EXPECT_TRUE(trouble("crack.points", {1e8}).starts_with("crack.points"));
  EXPECT_TRUE(trouble("tip.crack", {1.0}).starts_with("tip.crack"));
  EXPECT_TRUE(trouble("crack.kind", {0.5}).starts_with("crack.kind"));
  EXPECT_TRUE(trouble("crack.kind", {99.0}).starts_with("crack.kind"));
}

} // namespace
} // namespace spricka::test_growth_state
