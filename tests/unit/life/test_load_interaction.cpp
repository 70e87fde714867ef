// SPDX-License-Identifier: GPL-3.0-or-later
#include "centre_crack.hpp"
#include "life/integrate.hpp"
#include "life/load_interaction.hpp"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

/// Retardation against closed forms and an independent program, both from the published equations
/// (Wheeler 1972; Willenborg, Engle, Wood 1971; Gallagher 1974; Chang and Engle 1984).
namespace spricka::life::test_load_interaction {
namespace {

using model::InteractionRule;
using test::interaction_2024;
using test::sqrt_metre;

// Cycles at constant K from behind one overload to the end of its zone, by quadrature over the rate
// at each place.
struct ConstantK {
  double K_max, K_min; // MPa m^0.5
  double overload;

  double cycles_in_zone(const LoadInteraction& interaction) const {
    OverloadMemory memory;
    const double first = 1.0; // mm, wherever that is
    const model::PlaceOnCrack place{.a = first};
    const double grown =
        interaction.growth(overload * K_max * sqrt_metre, K_min * sqrt_metre, {}, place, memory);
    const double end = memory.zone - interaction.plastic_zone(K_max * sqrt_metre);
    const auto cycles = [&](double x) {
      OverloadMemory here = memory;
      return 1.0 /
             interaction.growth(K_max * sqrt_metre, K_min * sqrt_metre, {}, {.a = first + x}, here);
    };
    return integrate(cycles, grown, end, 1e-12).value;
  }
};

TEST(LoadInteraction, WheelerBehindOneOverloadInClosedForm) {
  struct Case {
    double overload, exponent, cycles;
  };
  constexpr std::array cases{Case{1.5, 1.0, 2112.996877545703},  Case{1.5, 2.0, 3597.9778327496874},
                             Case{2.0, 1.0, 7792.437702065061},  Case{2.0, 2.0, 21767.35295281386},
                             Case{2.5, 1.0, 19739.974072970195}, Case{2.5, 2.0, 83782.55245282082}};
  for (const Case& c : cases) {
    model::LoadInteractionDefinition with = interaction_2024(InteractionRule::wheeler);
    with.exponent = c.exponent;
    const LoadInteraction interaction(with, test::walker_2024());
    EXPECT_NEAR((ConstantK{20.0, 2.0, c.overload}.cycles_in_zone(interaction)) / c.cycles, 1.0,
                1e-9)
        << c.overload << " " << c.exponent;
  }
}

TEST(LoadInteraction, WillenborgBehindOneOverloadInClosedForm) {
  for (const bool zero : {false, true}) {
    model::LoadInteractionDefinition with = interaction_2024(InteractionRule::willenborg);
    with.negative_minimum_is_zero = zero;
    const LoadInteraction interaction(with, test::walker_2024());
    for (const auto& [overload, cycles] :
         {std::pair(1.5, 1656.8318198655095), std::pair(2.0, 7126.301450509715),
          std::pair(2.5, 31746.938297777346), std::pair(2.94, 205504.6869309214)}) {
      EXPECT_NEAR((ConstantK{20.0, 2.0, overload}.cycles_in_zone(interaction)) / cycles, 1.0, 1e-9)
          << overload;
    }
  }
}

// R < 0 reaches a law that knows it, or does not.
TEST(LoadInteraction, EffectiveMinimumBelowZeroByName) {
  model::GrowthLawConstants c;
  c.C = 1.5028962878452544e-7;
  c.m = 3.2;
  c.p = 0.25;
  c.q = 1.0;
  c.k_c = 81.64853456014293 * sqrt_metre;
  c.k_unit = sqrt_metre;
  c.threshold_over_ratio = model::ThresholdOverRatio{
      .delta_k = 1.22 * 1.0988434941087548 * sqrt_metre, .slope_above = 1.21, .slope_below = 0.1};
  model::LoadInteractionDefinition with = interaction_2024(InteractionRule::willenborg);
  with.threshold.reset();
  for (const auto& [zero, cycles] :
       {std::pair(false, 5748.71612571909), std::pair(true, 5878.225823117959)}) {
    with.negative_minimum_is_zero = zero;
    const LoadInteraction interaction(with, GrowthRateLaw(model::CrackGrowthLaw::nasgro, c));
    EXPECT_NEAR(interaction.largest_K_without_growth() / sqrt_metre, test::threshold_2024, 1e-9);
    EXPECT_NEAR((ConstantK{20.0, 6.0, 2.0}.cycles_in_zone(interaction)) / cycles, 1.0, 1e-8);
  }
}

TEST(LoadInteraction, AnOverloadOfTheShutOffRatioLeavesTheThreshold) {
  const LoadInteraction interaction(interaction_2024(InteractionRule::willenborg),
                                    test::walker_2024());
  const double K_max = 20.0 * sqrt_metre;
  const double left = K_max - interaction.reduction_factor(K_max, 0.0) * (3.0 - 1.0) * K_max;
  EXPECT_NEAR(left / sqrt_metre, test::threshold_2024, 1e-12 * left);
}

TEST(LoadInteraction, UnderloadsTakeRetardationAway) {
  const LoadInteraction interaction(interaction_2024(InteractionRule::modified),
                                    test::walker_2024());
  constexpr std::array factors{std::pair(-1.0, 0.20178272581498446),
                               std::pair(-0.5, 0.25580891445691145),
                               std::pair(0.0, 0.3999265318050638),
                               std::pair(0.2, 0.6387222706904602),
                               std::pair(0.2499, 0.9953313015127017),
                               std::pair(0.25, 1.0),
                               std::pair(0.5, 1.0)};
  for (const auto& [ratio, factor] : factors) {
    EXPECT_NEAR(interaction.reduction_factor(1.0, ratio), factor, 1e-12) << ratio;
  }
}

// Cycles 15 to 150 MPa on a centre crack from 6 mm; the first one from 10 mm on goes to S times
// 150, and its minimum to `after`. N where a length is passed, straight within a cycle.
std::map<double, double> cycles_at_lengths(const LoadInteraction& interaction, double overload,
                                           double after, const std::vector<double>& lengths) {
  std::map<double, double> N;
  OverloadMemory memory;
  double a = 6.0;
  bool came = false;
  std::size_t next = 0;
  for (double n = 0.0; next < lengths.size(); n += 1.0) {
    const double K = test::centre_crack_K(a);
    const bool now = !came && a >= 10.0;
    came = came || now;
    const double da = interaction.growth(now ? overload * 150.0 * K : 150.0 * K,
                                         now ? after * K : 15.0 * K, {}, {.a = a}, memory);
    for (; next < lengths.size() && a + da >= lengths[next]; ++next) {
      N[lengths[next]] = n + (lengths[next] - a) / da;
    }
    a += da;
  }
  return N;
}

TEST(LoadInteraction, OneOverloadCycleByCycle) {
  struct Case {
    std::optional<model::LoadInteractionDefinition> with;
    double overload, after;
    std::array<double, 4> N;
  };
  const auto named = [](InteractionRule rule, double solr, double zone) {
    model::LoadInteractionDefinition with = interaction_2024(rule);
    with.shut_off_ratio = solr;
    with.zone_factor = zone;
    return std::optional(with);
  };
  const std::vector<double> lengths{10.1, 11.0, 12.0, 20.0};
  const std::vector<Case> cases{
      {std::nullopt,
       1,
       15.0,
       {5296.086500559414, 6008.702866641902, 6696.338754865058, 10048.23526504523}},
      {std::nullopt,
       1.5,
       15.0,
       {5293.029850007238, 6005.646209321844, 6693.282101823636, 10045.17861460999}},
      {named(InteractionRule::wheeler, 3, 0.5 * std::numbers::inv_pi),
       1.5,
       15.0,
       {5458.55980088982, 6794.959459881883, 7482.595329189076, 10834.49183085318}},
      {named(InteractionRule::willenborg_1971, 3, 0.5 * std::numbers::inv_pi),
       1.5,
       15.0,
       {5755.506771814011, 7472.784260814624, 8160.420142955597, 11512.31664985132}},
      {named(InteractionRule::willenborg, 3, 0.5 * std::numbers::inv_pi),
       1.5,
       15.0,
       {5353.231850692342, 6235.192138248204, 6922.828029760869, 10274.72452835739}},
      {named(InteractionRule::willenborg, 2.5, 0.5 * std::numbers::inv_pi),
       1.5,
       15.0,
       {5403.121611494946, 6418.10097763772, 7105.736857177092, 10457.63335644784}},
      {named(InteractionRule::modified, 3, 0.5 * std::numbers::inv_pi),
       1.5,
       15.0,
       {5354.823864833436, 6240.57921549117, 6928.215113099724, 10280.11162930648}},
      {std::nullopt,
       2,
       15.0,
       {5286.312805698857, 5998.929199157951, 6686.565070656669, 10038.46157304507}},
      {named(InteractionRule::wheeler, 3, 0.5 * std::numbers::inv_pi),
       2,
       15.0,
       {5734.624922567285, 9506.60314169567, 11316.39421679471, 14723.86820791465}},
      {named(InteractionRule::willenborg, 3, 0.5 * std::numbers::inv_pi),
       2,
       15.0,
       {5590.630292209427, 7986.964220032808, 9061.471610988909, 12423.72754785023}},
      {named(InteractionRule::willenborg, 2.5, 0.5 * std::numbers::inv_pi),
       2,
       15.0,
       {6190.716887564377, 10975.90548635454, 12381.72498025642, 15747.71287660961}},
      {named(InteractionRule::modified, 3, 0.5 * std::numbers::inv_pi),
       2,
       15.0,
       {5575.538094261869, 7890.189616533222, 8945.585243846308, 12307.53098358884}},
      {std::nullopt,
       2.5,
       15.0,
       {5274.269796605484, 5986.886184819753, 6674.522059451661, 10026.41856299844}},
      {named(InteractionRule::wheeler, 3, 0.5 * std::numbers::inv_pi),
       2.5,
       15.0,
       {6045.715238622245, 13868.2881062524, 18722.52881256922, 24391.58911258521}},
      {named(InteractionRule::willenborg, 3, 0.5 * std::numbers::inv_pi),
       2.5,
       15.0,
       {6775.143763855952, 17013.80277060811, 20724.74280271658, 25060.46091319873}},
      {named(InteractionRule::willenborg, 2.5, 0.5 * std::numbers::inv_pi),
       2.5,
       15.0,
       {42209.90002065114, 145846.6207262428, 156508.6198397658, 161861.1135115392}},
      {named(InteractionRule::modified, 3, 0.5 * std::numbers::inv_pi),
       2.5,
       15.0,
       {6498.444802824215, 15192.44863305574, 18530.23923424558, 22767.71162997697}},
      {named(InteractionRule::willenborg, 3, std::numbers::pi / 8.0 / (1.15 * 1.15)),
       2,
       15.0,
       {5598.008942205006, 8405.024438313247, 10052.8456993186, 13772.81745032806}},
      {named(InteractionRule::willenborg, 3, 1.0 / (6.0 * std::numbers::pi)),
       2,
       15.0,
       {5560.888348087744, 6911.86140631138, 7599.497282757836, 10951.3937870406}},
      {named(InteractionRule::modified, 3, 0.5 * std::numbers::inv_pi),
       2,
       -75.0,
       {5400.311070883651, 6828.278983427259, 7696.022075650561, 11054.88405864497}}};
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Case& c = cases[k];
    const LoadInteraction interaction(c.with, test::walker_2024());
    const auto N = cycles_at_lengths(interaction, c.overload, c.after, lengths);
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      EXPECT_NEAR(N.at(lengths[i]) / c.N[i], 1.0, 1e-9) << k << " " << lengths[i];
    }
  }
}

TEST(LoadInteraction, ConstantAmplitudeIsNeverHeldBack) {
  for (const InteractionRule rule : {InteractionRule::wheeler, InteractionRule::willenborg_1971,
                                     InteractionRule::willenborg, InteractionRule::modified}) {
    const LoadInteraction interaction(interaction_2024(rule), test::walker_2024());
    EXPECT_EQ(
        cycles_at_lengths(interaction, 1.0, 15.0, {20.0}),
        cycles_at_lengths(LoadInteraction(std::nullopt, test::walker_2024()), 1.0, 15.0, {20.0}));
  }
}

// (Newman 1984 for the level; the closed life of a centre crack by Paris' law.)
TEST(LoadInteraction, OneOpeningLevelForAllCycles) {
  struct Case {
    double low, high, alpha, stress, from, to, cycles;
  };
  constexpr std::array cases{Case{0, 150, 2.0, 0.3, 0, 150, 202636.12647051868},
                             Case{0, 150, 2.0, 0.3, 60, 100, 3276834.558110852},
                             Case{-50, 150, 1.0, 0.4, 20, 90, 6426307.545689235}};
  model::GrowthLawConstants c;
  c.C = 1e-8;
  c.m = 3.0;
  c.k_unit = sqrt_metre;
  for (const Case& now : cases) {
    model::LoadInteractionDefinition with;
    with.rule = InteractionRule::closure;
    with.constraint = now.alpha;
    with.stress_ratio = now.stress;
    const LoadInteraction interaction(with, GrowthRateLaw(model::CrackGrowthLaw::paris, c));
    OverloadMemory memory;
    const auto cycles = [&](double a) {
      const double K = test::centre_crack_K(a);
      return 1.0 / interaction.growth(now.to * K, now.from * K, {now.low * K, now.high * K},
                                      {.a = a}, memory);
    };
    EXPECT_NEAR(integrate(cycles, 6.0, 20.0, 1e-12).value / now.cycles, 1.0, 1e-10);
  }
}

} // namespace
} // namespace spricka::life::test_load_interaction
