// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/growth_law.hpp"
#include "life/integrate.hpp"
#include "life/newman_closure.hpp"
#include "life/threshold.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

/// NASGRO's law as a whole against numbers of an independent program (its formulas: Newman 1984;
/// Forman and Mettu 1992; NASGRO reference manual 4), with constants of 2024-T3 sheet and 7075-T651
/// plate, L-T (DOT/FAA/AR-05/15, 2005), in mm and MPa m^0.5.
namespace spricka::life::test_threshold {
namespace {

constexpr double ksi_sqrt_inch = 1.0988434941087548; // MPa m^0.5

model::GrowthLawConstants sheet_2024() {
  model::GrowthLawConstants c;
  c.C = 1.5028962878452544e-7;
  c.m = 3.2;
  c.p = 0.25;
  c.q = 1.0;
  c.k_c = 81.64853456014293;
  c.threshold_over_ratio = model::ThresholdOverRatio{.delta_k = 1.22 * ksi_sqrt_inch,
                                                     .slope_above = 1.21,
                                                     .slope_below = 0.1,
                                                     .intrinsic_length = 0.0381};
  return c;
}

model::GrowthLawConstants plate_7075() {
  model::GrowthLawConstants c = sheet_2024();
  c.C = 5.85240827832e-7;
  c.m = 2.8;
  c.p = 0.5;
  c.k_c = 54.8490784;
  c.threshold_over_ratio->delta_k = 0.70 * ksi_sqrt_inch;
  c.threshold_over_ratio->slope_above = 1.30;
  return c;
}

constexpr double long_crack = std::numeric_limits<double>::infinity();

TEST(NewmanClosure, IsThePublishedFunction) {
  struct Opening {
    double alpha, stress, R, f;
  };
  constexpr std::array published{
      Opening{1, 0, -2, 0.53499999999999992},     Opening{1, 0, -1, 0.53499999999999992},
      Opening{1, 0, -0.5, 0.53499999999999992},   Opening{1, 0, -0.2, 0.53499999999999992},
      Opening{1, 0, 0, 0.53499999999999992},      Opening{1, 0, 0.1, 0.53901999999999994},
      Opening{1, 0, 0.3, 0.57243999999999995},    Opening{1, 0, 0.5, 0.64249999999999996},
      Opening{1, 0, 0.7, 0.7525599999999999},     Opening{1, 0, 0.9, 0.90598000000000001},
      Opening{1, 0.3, -2, 0.2702884904407768},    Opening{1, 0.3, -1, 0.37348849044077681},
      Opening{1, 0.3, -0.5, 0.42508849044077679}, Opening{1, 0.3, -0.2, 0.45604849044077678},
      Opening{1, 0.3, 0, 0.47668849044077677},    Opening{1, 0.3, 0.1, 0.49070041270843501},
      Opening{1, 0.3, 0.3, 0.54189417650556893},  Opening{1, 0.3, 0.5, 0.62624424522038846},
      Opening{1, 0.3, 0.7, 0.74646631393520768},  Opening{1, 0.3, 0.9, 0.90527607773234176},
      Opening{2, 0, -2, 0.34499999999999992},     Opening{2, 0, -1, 0.34499999999999992},
      Opening{2, 0, -0.5, 0.34499999999999992},   Opening{2, 0, -0.2, 0.34499999999999992},
      Opening{2, 0, 0, 0.34499999999999992},      Opening{2, 0, 0.1, 0.35433999999999993},
      Opening{2, 0, 0.3, 0.42347999999999991},    Opening{2, 0, 0.5, 0.54749999999999988},
      Opening{2, 0, 0.7, 0.71151999999999993},    Opening{2, 0, 0.9, 0.90066000000000002},
      Opening{2, 0.3, -2, 0.16185633963047674},   Opening{2, 0.3, -1, 0.24375633963047674},
      Opening{2, 0.3, -0.5, 0.28470633963047676}, Opening{2, 0.3, -0.2, 0.30927633963047674},
      Opening{2, 0.3, 0, 0.32565633963047674},    Opening{2, 0.3, 0.1, 0.3421718621208234},
      Opening{2, 0.3, 0.3, 0.42035387027029375},  Opening{2, 0.3, 0.5, 0.54806566981523841},
      Opening{2, 0.3, 0.7, 0.71250146936018299},  Opening{2, 0.3, 0.9, 0.90085547750965334},
      Opening{3, 0, -2, 0.25499999999999995},     Opening{3, 0, -1, 0.25499999999999995},
      Opening{3, 0, -0.5, 0.25499999999999995},   Opening{3, 0, -0.2, 0.25499999999999995},
      Opening{3, 0, 0, 0.25499999999999995},      Opening{3, 0, 0.1, 0.26685999999999993},
      Opening{3, 0, 0.3, 0.35291999999999996},    Opening{3, 0, 0.5, 0.50249999999999995},
      Opening{3, 0, 0.7, 0.69999999999999996},    Opening{3, 0, 0.9, 0.90000000000000002},
      Opening{3, 0.3, -2, 0.12417697515144921},   Opening{3, 0.3, -1, 0.1847769751514492},
      Opening{3, 0.3, -0.5, 0.21507697515144922}, Opening{3, 0.3, -0.2, 0.23325697515144922},
      Opening{3, 0.3, 0, 0.24537697515144921},    Opening{3, 0.3, 0.1, 0.26241501984720861},
      Opening{3, 0.3, 0.3, 0.35428374851873617},  Opening{3, 0.3, 0.5, 0.50526348757572459},
      Opening{3, 0.3, 0.7, 0.69999999999999996},  Opening{3, 0.3, 0.9, 0.90000000000000002}};
  for (const Opening& o : published) {
    EXPECT_NEAR(NewmanClosure(o.alpha, o.stress)(o.R), o.f, 1e-12) << o.alpha << " " << o.R;
  }
}

// Centre cracks in an infinite plate; largest stress, R, from one length to another.
TEST(NasgroLaw, LivesOfCentreCracks) {
  struct Life {
    double stress, R, first, last, cycles;
  };
  const auto compare = [](const model::GrowthLawConstants& c, const std::vector<Life>& lives) {
    const GrowthRateLaw law(model::CrackGrowthLaw::nasgro, c);
    for (const Life& life : lives) {
      const double last =
          life.last > 0.0 ? life.last
                          : 0.999 * 1000.0 / std::numbers::pi * std::pow(*c.k_c / life.stress, 2);
      const auto cycles = [&](double a) {
        const double K = life.stress * std::sqrt(1e-3 * std::numbers::pi * a);
        return 1.0 / law.growth_rate(K, life.R * K, {.a = a});
      };
      EXPECT_NEAR(integrate(cycles, life.first, last, 1e-12).value / life.cycles, 1.0, 1e-7)
          << life.stress << " " << life.R;
    }
  };
  compare(sheet_2024(), {{100.0, 0.1, 2.0, 20.0, 76877.228246142098},
                         {100.0, -1.0, 2.0, 20.0, 48393.063982663771},
                         {80.0, 0.5, 5.0, 40.0, 275086.45832043426},
                         {200.0, 0.0, 1.0, 0.0, 11502.287209633483}});
  compare(plate_7075(), {{100.0, 0.1, 2.0, 20.0, 41456.617380646276},
                         {100.0, -1.0, 2.0, 20.0, 27596.798683710083},
                         {80.0, 0.5, 5.0, 40.0, 134304.65825100988}});
}

TEST(FatigueThreshold, OverROfLongCracks) {
  constexpr std::array sheet{std::pair(-3.0, 6.480601258209273), std::pair(-2.0, 6.480601258209273),
                             std::pair(-1.0, 5.39004784522229),  std::pair(-0.5, 4.450735640608595),
                             std::pair(-0.2, 3.739823219877324), std::pair(0.0, 3.2023444628663444),
                             std::pair(0.1, 2.9258075763458202), std::pair(0.3, 2.4205316701172865),
                             std::pair(0.5, 2.0011214441640233), std::pair(0.7, 1.6732264359299616),
                             std::pair(0.9, 1.6732264359299616)};
  const FatigueThreshold threshold(sheet_2024());
  for (const auto& [R, expected] : sheet) {
    EXPECT_NEAR(threshold(R, long_crack) / expected, 1.0, 1e-9) << R;
  }
  constexpr std::array plate{std::pair(-1.0, 3.2042878), std::pair(-0.2, 2.2232585),
                             std::pair(0.0, 1.903737), std::pair(0.5, 1.1740518)};
  const FatigueThreshold other(plate_7075());
  for (const auto& [R, expected] : plate) {
    EXPECT_NEAR(other(R, long_crack) / expected, 1.0, 1e-7) << R;
  }
}

TEST(FatigueThreshold, ShortCracksHaveLess) {
  constexpr std::array<std::array<double, 4>, 4> expected{
      {{0.02, 3.1624200287881377, 1.8788624070237108, 1.1740872654166137},
       {0.05, 4.060594931737371, 2.412487619589217, 1.507545726364195},
       {0.127, 4.727384687100781, 2.808641891740388, 1.7550996102113199},
       {1.27, 5.310971952603883, 3.1553637580295164, 1.971763548097225}}};
  const FatigueThreshold threshold(sheet_2024());
  for (const auto& [a, below, zero, above] : expected) {
    EXPECT_NEAR(threshold(-1.0, a) / below, 1.0, 1e-9) << a;
    EXPECT_NEAR(threshold(0.0, a) / zero, 1.0, 1e-9) << a;
    EXPECT_NEAR(threshold(0.5, a) / above, 1.0, 1e-9) << a;
  }
  model::GrowthLawConstants none = sheet_2024();
  none.threshold_over_ratio->intrinsic_length = 0.0;
  EXPECT_EQ(FatigueThreshold(none)(0.3, 0.02), threshold(0.3, long_crack));
}

// 2.39 times the constant for R to 1 is that at R = 0: either makes the same function. As NASGRO 3
// wrote it: dKth = dK0 [(1 - A0)(1 - R)/(1 - f)]^(1 + Cth R).
TEST(FatigueThreshold, TheConstantAtZeroMakesTheSame) {
  const FatigueThreshold by_one(sheet_2024());
  model::GrowthLawConstants c = sheet_2024();
  c.threshold_over_ratio->delta_k = by_one(0.0, long_crack);
  c.threshold_over_ratio->at_zero_ratio = true;
  EXPECT_NEAR(c.threshold_over_ratio->delta_k / (1.22 * ksi_sqrt_inch), 2.39, 0.005);
  const FatigueThreshold by_zero(c);
  for (const double R : {-2.0, -0.7, 0.0, 0.2, 0.6, 0.95}) {
    EXPECT_NEAR(by_zero(R, 0.3) / by_one(R, 0.3), 1.0, 1e-12) << R;
  }
  const NewmanClosure f(2.0, 0.3);
  for (const double R : {0.0, 0.25, 0.5, 0.7}) {
    const double older = c.threshold_over_ratio->delta_k *
                         std::pow((1.0 - f(0.0)) * (1.0 - R) / (1.0 - f(R)), 1.0 + 1.21 * R);
    EXPECT_NEAR(by_zero(R, long_crack) / older, 1.0, 1e-12) << R;
  }
}

struct RateAt {
  double R, range, rate; // range: K_max - K_min
};

TEST(NasgroLaw, RatesFromThresholdToToughness) {
  constexpr std::array rates{RateAt{-1.0, 5.390586850006812, 1.5175868072589832e-07},
                             RateAt{-1.0, 10.78009569044458, 1.2137959930380861e-05},
                             RateAt{-1.0, 146.9673622082573, 0.5706905573402564},
                             RateAt{-0.5, 4.451180714172656, 1.7337039225031262e-07},
                             RateAt{-0.5, 4.539750353420767, 6.915138243936911e-07},
                             RateAt{-0.5, 5.340882768730315, 1.9997481931200507e-06}};
  const GrowthRateLaw law(model::CrackGrowthLaw::nasgro, sheet_2024());
  for (const RateAt& at : rates) {
    const double K_max = at.range / (1.0 - at.R);
    // next to the threshold the last digits of it count
    EXPECT_NEAR(law.growth_rate(K_max, at.R * K_max) / at.rate, 1.0, 1e-8)
        << at.R << ' ' << at.range;
  }
  constexpr std::array rounded{
      RateAt{0.0, 16.16993, 0.00037076793}, RateAt{0.0, 80.83205, 5.3607762},
      RateAt{0.1, 14.66285, 0.00035132275}, RateAt{0.3, 11.76193, 0.00026020656},
      RateAt{0.5, 9.038491, 0.00015048291}, RateAt{0.7, 6.401949, 6.2610949e-05}};
  for (const RateAt& at : rounded) {
    const double K_max = at.range / (1.0 - at.R);
    EXPECT_NEAR(law.growth_rate(K_max, at.R * K_max) / at.rate, 1.0, 2e-5)
        << at.R << ' ' << at.range;
  }
}

TEST(NasgroLaw, EndsAtTheThresholdOfItsOwnR) {
  const GrowthRateLaw law(model::CrackGrowthLaw::nasgro, sheet_2024());
  for (const double R : {-1.0, 0.0, 0.5, 0.85}) {
    const double K_max = FatigueThreshold(sheet_2024())(R, long_crack) / (1.0 - R);
    EXPECT_EQ(law.growth_rate(0.999999 * K_max, 0.999999 * R * K_max), 0.0) << R;
    EXPECT_GT(law.growth_rate(1.000001 * K_max, 1.000001 * R * K_max), 0.0) << R;
    const double range = law.K_range_for_rate(law.growth_rate(3.0 * K_max, 3.0 * R * K_max), R);
    EXPECT_NEAR(range / (3.0 * K_max * (1.0 - std::max(R, 0.0))), 1.0, 1e-12);
  }
  EXPECT_GT(law.growth_rate(3.2, 0.0, {0.1}), 0.0); // a short crack grows where a long one stands
  EXPECT_EQ(law.growth_rate(3.2, 0.0), 0.0);
}

// The other laws take R < 0 as 0, and so the threshold at R = 0.
TEST(FatigueThreshold, IsThatOfEveryLaw) {
  const GrowthRateLaw paris(model::CrackGrowthLaw::paris, sheet_2024());
  EXPECT_EQ(paris.growth_rate(4.0, 2.0), 0.0);
  EXPECT_GT(paris.growth_rate(4.1, 2.05), 0.0);
  EXPECT_EQ(paris.growth_rate(3.2, -3.2), 0.0);
  EXPECT_GT(paris.growth_rate(3.21, -3.21), 0.0);
  EXPECT_FALSE(paris.is_held_by_constant_threshold(4.0, 2.0));
}

TEST(ConstantThreshold, IsToldWhereItHoldsBackAnotherR) {
  model::GrowthLawConstants c = sheet_2024();
  c.threshold_over_ratio.reset();
  c.threshold = 3.2;
  const GrowthRateLaw paris(model::CrackGrowthLaw::paris, c);
  EXPECT_TRUE(paris.is_held_by_constant_threshold(6.0, 3.0));
  EXPECT_FALSE(paris.is_held_by_constant_threshold(6.0, 2.0)); // it grows by Paris' law
  EXPECT_FALSE(paris.is_held_by_constant_threshold(3.0, 0.0)); // the R of the constant
  EXPECT_FALSE(paris.is_held_by_constant_threshold(3.0, -3.0));
  const GrowthRateLaw nasgro(model::CrackGrowthLaw::nasgro, c);
  EXPECT_TRUE(nasgro.is_held_by_constant_threshold(6.0, 2.0)); // slowed down
  EXPECT_FALSE(nasgro.is_held_by_constant_threshold(16.0, 8.0));
  EXPECT_TRUE(nasgro.is_held_by_constant_threshold(3.0, -3.0));
}

} // namespace
} // namespace spricka::life::test_threshold
