// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/pass_counter.hpp"

#include "growth/cycle_by_cycle.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

using growth::GrowthTrajectory;
using growth::SolvedStation;
using model::InteractionRule;
using model::LoadInteractionDefinition;

namespace {

/// More are not followed one by one: it would take longer than the fronts.
constexpr double most_cycles = 1e8;
constexpr std::size_t points = 4; // of the polynomials between stations

} // namespace

life::LoadInteraction make_load_interaction(const model::Model& model,
                                            const std::optional<std::size_t>& entry) {
  return {entry ? std::optional(model.interactions[*entry]) : std::nullopt,
          life::GrowthRateLaw(model.growth->law, model.growth->constants)};
}

bool PassCounter::may_follow_cycles(const std::vector<SolvedStation>& stations) const {
  const bool mapped = std::ranges::all_of(stations, [](const SolvedStation& station) {
    return std::ranges::none_of(
        station.tips, [](const growth::TipStation& tip) { return tip.K_over_path.empty(); });
  });
  return mapped && stations.size() > 1 &&
         spectrum_.cycles_per_pass() * GrowthTrajectory(stations, {}, points)
                                           .cycles(stations.front().s, stations.back().s) <
             most_cycles;
}

// Behind a place where nothing grows there are no cycles to follow.
bool PassCounter::has_followed_each_cycle(const std::vector<SolvedStation>& stations,
                                          double passes) const {
  return may_follow_cycles(stations) &&
         (std::isinf(passes) || passes * spectrum_.cycles_per_pass() <= most_cycles);
}

std::vector<SolvedStation>
PassCounter::with_settled_rates(std::vector<SolvedStation> stations) const {
  for (SolvedStation& station : stations) {
    for (growth::TipStation& tip : station.tips) {
      tip.rate = tip.extent_rate_ratio * interaction_.growth_of_settled_pass(
                                             tip.K_over_path.empty()
                                                 ? tip.cycles_of_K
                                                 : spectrum_.cycles_in_order_as_K(tip.K_over_path),
                                             growth::place_of_tip(tip, tip.a));
    }
  }
  return stations;
}

std::vector<double> PassCounter::passes_at(const std::vector<SolvedStation>& stations,
                                           const std::vector<double>& places) const {
  if (may_follow_cycles(stations)) {
    if (auto passes = growth::CycleByCycleGrowth(stations, spectrum_)
                          .passes_at(places, interaction_, most_cycles)) {
      return std::move(*passes);
    }
  }
  const std::vector<SolvedStation> settled = with_settled_rates(stations);
  const GrowthTrajectory between(settled, {}, points);
  std::vector<double> passes;
  passes.reserve(places.size());
  for (const double s : places) {
    passes.push_back(between.cycles(settled.front().s, s));
  }
  return passes;
}

std::optional<double> PassCounter::extent_after_passes(const std::vector<SolvedStation>& stations,
                                                       double passes) const {
  if (stations.size() < 2) {
    return std::nullopt;
  }
  if (may_follow_cycles(stations)) {
    return growth::CycleByCycleGrowth(stations, spectrum_)
        .extent_after_passes(passes, interaction_, most_cycles);
  }
  const std::vector<SolvedStation> settled = with_settled_rates(stations);
  return GrowthTrajectory(settled, {}, points).extent_after_cycles(settled.front().s, passes);
}

namespace {

std::string rule_words(const LoadInteractionDefinition& rule, double threshold,
                       const std::string& K_unit) {
  const std::string K_threshold = fmt::format("K_max threshold {:.6g} {}", threshold, K_unit);
  switch (rule.rule) {
  case InteractionRule::wheeler:
    return fmt::format("Wheeler, exponent {:.6g}", rule.exponent);
  case InteractionRule::willenborg_1971:
    return "Willenborg of 1971: all of K required - K_max is taken off, K_min below 0 is 0";
  case InteractionRule::willenborg:
    return fmt::format("Willenborg generalised, shut-off ratio {:.6g}, {}, effective K_min below "
                       "0 {}",
                       rule.shut_off_ratio, K_threshold,
                       rule.negative_minimum_is_zero ? "is 0" : "counts");
  case InteractionRule::modified:
    return fmt::format("Willenborg modified for underloads, phi_0 = {:.6g}", rule.underload_factor);
  case InteractionRule::chang:
    return fmt::format("Walker and Chang, shut-off ratio {:.6g}, {}, threshold slope {:.6g}, q = "
                       "{:.6g}, R from {:.6g} to {:.6g}",
                       rule.shut_off_ratio, K_threshold, rule.threshold_slope,
                       rule.negative_exponent, rule.smallest_ratio, rule.largest_ratio);
  case InteractionRule::closure:
    return fmt::format("one opening level for all cycles by Newman, alpha = {:.6g}, stress ratio "
                       "{:.6g}",
                       rule.constraint, rule.stress_ratio);
  }
  return {};
}

} // namespace

std::string describe_interaction(const model::Model& model,
                                 const life::LoadInteraction& interaction,
                                 const std::vector<SolvedStation>& stations) {
  const std::optional<LoadInteractionDefinition>& rule = interaction.definition();
  if (!rule) {
    return "NONE: cycles do not act on each other";
  }
  std::string out = rule->name + ": " +
                    rule_words(*rule, interaction.largest_K_without_growth(),
                               model.units.stress_intensity_name());
  if (rule->rule == InteractionRule::closure) {
    return out;
  }
  const auto zone = [&](const SolvedStation& station) {
    double largest = 0.0;
    for (const growth::TipStation& tip : station.tips) {
      largest = std::max(largest, tip.K_max);
    }
    return interaction.plastic_zone(largest);
  };
  return out +
         fmt::format("; plastic zone {:.6g}{} (K_max/{:.6g})^2, {:.4g} {} at the first length "
                     "and {:.4g} at the last",
                     rule->zone_factor, rule->zone_name.empty() ? "" : " (" + rule->zone_name + ")",
                     rule->yield_stress, zone(stations.front()), model.units.length_name,
                     zone(stations.back()));
}

} // namespace spricka::analysis
