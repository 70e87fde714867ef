// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "life/growth_law.hpp"
#include "model/interaction_rules.hpp"

#include <cmath>
#include <numbers>

/// 2024-T3 sheet (DOT/FAA/AR-05/15, 2005) and the centre crack that references of load interaction
/// are made with; mm, MPa, K in MPa mm^0.5.
namespace spricka::test {

inline const double sqrt_metre = std::sqrt(1000.0); // MPa m^0.5 in MPa mm^0.5
inline constexpr double yield_2024 = 365.4221365379231;
inline constexpr double threshold_2024 = 3.2023444628663446; // at R = 0, MPa m^0.5

/// Walker's law; compression does nothing.
inline life::GrowthRateLaw walker_2024() {
  model::GrowthLawConstants c;
  c.C = 3.115782828226343e-8;
  c.m = 3.273;
  c.p = 0.618;
  c.k_unit = sqrt_metre;
  return {model::CrackGrowthLaw::walker, c};
}

inline model::LoadInteractionDefinition interaction_2024(model::InteractionRule rule) {
  model::LoadInteractionDefinition with;
  with.rule = rule;
  with.zone_factor = 0.5 * std::numbers::inv_pi;
  with.yield_stress = yield_2024;
  with.exponent = 1.43;
  with.shut_off_ratio = 3.0;
  with.threshold = threshold_2024 * sqrt_metre;
  with.underload_factor = 0.4;
  with.threshold_slope = 1.0;
  with.negative_exponent = 0.3;
  with.largest_ratio = 0.75;
  with.smallest_ratio = -0.99;
  with.negative_minimum_is_zero = rule == model::InteractionRule::willenborg_1971;
  return with;
}

/// K of a crack of half length a in an infinite plate over the stress.
inline double centre_crack_K(double a) {
  return std::sqrt(std::numbers::pi * a);
}

/// The numbers that public programs' sequences are made with: x' = (1103515245 x + 12345) mod 2^31.
class CongruentialNumbers {
public:
  explicit CongruentialNumbers(std::int64_t seed) : x_(seed) {}
  double operator()() {
    x_ = (1103515245 * x_ + 12345) % 2147483648;
    return static_cast<double>(x_) / 2147483648.0;
  }

private:
  std::int64_t x_;
};

} // namespace spricka::test
