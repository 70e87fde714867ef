// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/load_interaction.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace spricka::life {

using model::InteractionRule;
using model::LoadInteractionDefinition;
using model::PlaceOnCrack;

namespace {

// The K_max below which a long crack does not grow at R = 0.
double threshold_of(const std::optional<LoadInteractionDefinition>& interaction,
                    const GrowthRateLaw& law) {
  return interaction && interaction->threshold ? *interaction->threshold : law.threshold(0.0);
}

NewmanClosure closure_of(const std::optional<LoadInteractionDefinition>& interaction) {
  return interaction ? NewmanClosure(interaction->constraint, interaction->stress_ratio)
                     : NewmanClosure(1.0, 0.0);
}

} // namespace

LoadInteraction::LoadInteraction(std::optional<LoadInteractionDefinition> interaction,
                                 GrowthRateLaw law)
    : interaction_(std::move(interaction)), law_(std::move(law)),
      closure_(closure_of(interaction_)), threshold_(threshold_of(interaction_, law_)) {}

double LoadInteraction::plastic_zone(double K_max) const {
  const double over = K_max / interaction_->yield_stress;
  return interaction_->zone_factor * over * over;
}

// Chang: compression since the overload shortens its zone.
double LoadInteraction::shortened_zone(const OverloadMemory& memory) const {
  if (interaction_->rule != InteractionRule::chang) {
    return memory.zone;
  }
  constexpr double most = 0.99;
  return memory.zone * (1.0 + std::clamp(memory.lowest_K / memory.K_max, -most, 0.0));
}

double LoadInteraction::zone_end(const OverloadMemory& memory) const {
  return memory.K_max > 0.0 ? memory.a + shortened_zone(memory)
                            : -std::numeric_limits<double>::infinity();
}

double LoadInteraction::growth(double K_max, double K_min, const LoadCycle& whole_pass,
                               const PlaceOnCrack& place, OverloadMemory& memory) const {
  if (!interaction_) {
    return law_.growth_rate(K_max, K_min, place);
  }
  if (interaction_->rule == InteractionRule::closure) {
    // One level for all, by the extremes of the pass.
    const double opening =
        whole_pass.high > 0.0 ? closure_(whole_pass.low / whole_pass.high) * whole_pass.high : 0.0;
    return law_.growth_rate(K_max, std::max(K_min, opening), place);
  }
  if (!(K_max > 0.0)) {
    memory.lowest_K = std::min(memory.lowest_K, K_min);
    return 0.0;
  }
  const double zone = plastic_zone(K_max);
  if (place.a + zone >= zone_end(memory)) {
    memory = {.a = place.a, .zone = zone, .K_max = K_max, .lowest_K = K_min};
    return unretarded(K_max, K_min, place);
  }
  return retarded(K_max, K_min, place, zone, memory);
}

LoadCycle extreme_loads(const std::vector<LoadCycle>& cycles) {
  LoadCycle all = cycles.empty() ? LoadCycle() : cycles.front();
  for (const LoadCycle& cycle : cycles) {
    all.low = std::min(all.low, cycle.low);
    all.high = std::max(all.high, cycle.high);
  }
  return all;
}

double LoadInteraction::growth_of_settled_pass(const std::vector<LoadCycle>& cycles,
                                               PlaceOnCrack place) const {
  const LoadCycle whole_pass = extreme_loads(cycles);
  OverloadMemory memory;
  double grown = 0.0;
  // The largest cycle of the first pass is remembered throughout the second.
  for (int pass = 0; pass < 2; ++pass) {
    grown = 0.0;
    for (const LoadCycle& cycle : cycles) {
      for (double left = cycle.count; left > 0.0 && std::isfinite(grown); left -= 1.0) {
        const double da =
            std::min(left, 1.0) * growth(cycle.high, cycle.low, whole_pass, place, memory);
        place.a += da;
        grown += da;
      }
    }
  }
  return grown;
}

double LoadInteraction::unretarded(double K_max, double K_min, const PlaceOnCrack& place) const {
  return interaction_->rule == InteractionRule::chang ? chang_rate(K_max, K_min, place)
                                                      : law_.growth_rate(K_max, K_min, place);
}

double LoadInteraction::reduction_factor(double K_max, double ratio) const {
  switch (interaction_->rule) {
  case InteractionRule::modified: {
    // (interaction.5): the function is to be 1 from 0.25 on.
    constexpr double no_effect = 0.25;
    return ratio < no_effect ? std::min(1.0, 2.523 * interaction_->underload_factor /
                                                 (1.0 + 3.5 * std::pow(no_effect - ratio, 0.6)))
                             : 1.0;
  }
  case InteractionRule::willenborg:
  case InteractionRule::chang:
    // (interaction.4). Below the threshold nothing is taken off: the cycle does not grow as it is.
    return std::max(0.0, 1.0 - threshold_ / K_max) / (interaction_->shut_off_ratio - 1.0);
  default:
    return 1.0;
  }
}

// A cycle that stays inside the zone in memory.
double LoadInteraction::retarded(double K_max, double K_min, const PlaceOnCrack& place, double zone,
                                 OverloadMemory& memory) const {
  if (interaction_->rule == InteractionRule::wheeler) {
    const double part = zone / (zone_end(memory) - place.a);
    return std::pow(part, interaction_->exponent) * law_.growth_rate(K_max, K_min, place);
  }
  // (interaction.4): the K whose zone would reach to the end of that in memory.
  const double grown = (place.a - memory.a) / shortened_zone(memory);
  const double required = memory.K_max * std::sqrt(std::max(0.0, 1.0 - grown));
  const double before = memory.lowest_K;
  memory.lowest_K = std::min(before, K_min);
  const double off = reduction_factor(K_max, memory.lowest_K / memory.K_max) * (required - K_max);
  const double high = K_max - off;
  switch (interaction_->rule) {
  case InteractionRule::chang:
    return chang_rate(high, K_min - off, place);
  case InteractionRule::modified:
    return law_.growth_rate(high, K_min > 0.0 ? std::max(K_min - off, 0.0) : K_min, place);
  default:
    return law_.growth_rate(
        high, interaction_->negative_minimum_is_zero ? std::max(K_min - off, 0.0) : K_min - off,
        place);
  }
}

// (interaction.6) by Walker's law at the K that it takes for the same: bounds for R, compression,
// and a threshold that falls with R.
double LoadInteraction::chang_rate(double K_max, double K_min, const PlaceOnCrack& place) const {
  if (!(K_max > 0.0)) {
    return 0.0;
  }
  const LoadInteractionDefinition& with = *interaction_;
  const double R = K_min / K_max;
  if (R < 0.0) {
    const double counted = std::max(R, with.smallest_ratio);
    const double high = std::pow(1.0 + counted * counted, with.negative_exponent) * K_max;
    return K_max > threshold_ ? law_.growth_rate(high, 0.0, place) : 0.0;
  }
  const double range = K_max - K_min;
  const double counted = std::min(R, with.largest_ratio);
  const double high = range / (1.0 - counted);
  return range > (1.0 - with.threshold_slope * R) * threshold_
             ? law_.growth_rate(high, counted * high, place)
             : 0.0;
}

} // namespace spricka::life
