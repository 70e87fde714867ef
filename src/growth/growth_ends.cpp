// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/growth_ends.hpp"

#include "geometry/box.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace spricka::growth {

namespace {

// Whether no tip has a K above 0 at the largest load.
bool closed(const SolvedStation& station) {
  return std::ranges::all_of(station.tips,
                             [](const TipStation& tip) { return !(tip.K_max > 0.0); });
}

// At which K of a tip ends the growth; empty: at none.
std::optional<double> toughness_at_tip(const TipStation& tip,
                                       const model::CrackGrowthSettings& rules) {
  return tip.toughness > 0.0 ? std::optional(tip.toughness) : rules.constants.k_c;
}

// The key that gave it.
const char* toughness_key(const TipStation& tip) {
  return tip.toughness > 0.0 ? "KIE" : "KC";
}

} // namespace

GrowthEvent GrowthEndCriteria::event_at_last_station(GrowthEventKind kind,
                                                     std::string reason) const {
  return {.kind = kind, .reason = std::move(reason), .s = stations.back().s};
}

std::optional<GrowthEvent> GrowthEndCriteria::find_crossing(const GrowthTrajectory& between,
                                                            double s0, double s1) const {
  std::optional<GrowthEvent> first;
  const auto consider = [&](std::optional<double> s, GrowthEventKind kind, std::string reason) {
    if (s && (!first || *s < first->s)) {
      first = GrowthEvent{.kind = kind, .reason = std::move(reason), .s = *s};
    }
  };
  const model::CrackGrowthSettings& rules = *model.growth;
  const SolvedStation& last = stations.back();
  for (std::size_t tip = 0; tip < tips.size(); ++tip) {
    const TipStation& here = last.tips[tip];
    if (const auto K_c = toughness_at_tip(here, rules); K_c && here.K_max >= *K_c) {
      consider(find_first_crossing([&](double s) { return between.K_max(tip, s) - *K_c; }, s0, s1),
               GrowthEventKind::fracture,
               fmt::format("K of {} reaches {}", tips[tip].name, toughness_key(here)));
    }
    if (rules.flow_stress && here.plastic >= 1.0) {
      consider(find_first_crossing(
                   [&](double s) { return between.plastic_load_ratio(tip, s) - 1.0; }, s0, s1),
               GrowthEventKind::net_section,
               fmt::format("the ligament ahead of {} reaches its plastic limit", tips[tip].name));
    }
  }
  if (!(last.growth_rate() > 0.0)) {
    const bool shut = closed(last);
    consider(find_first_crossing(
                 [&](double s) { return between.growth_rate(s) > 0.0 ? -1.0 : 1.0; }, s0, s1),
             shut ? GrowthEventKind::closed : GrowthEventKind::threshold,
             shut ? "no crack grows any more: none opens at the largest load, K1 is not above 0"
                  : "no crack grows any more: delta K has fallen to the threshold");
  }
  return first;
}

std::optional<GrowthEvent>
GrowthEndCriteria::find_growth_end(const GrowthTrajectory& between) const {
  if (stations.size() == 1) {
    return find_end_at_first_station();
  }
  const model::CrackGrowthSettings& rules = *model.growth;
  const SolvedStation& here = stations.back();
  std::optional<GrowthEvent> end = find_crossing(between, stations[stations.size() - 2].s, here.s);
  for (std::size_t tip = 0; tip < tips.size() && rules.last_length && !end; ++tip) {
    const double last = *rules.last_length;
    if (here.tips[tip].a >= last * (1.0 - 1e-12)) {
      end = event_at_last_station(
          GrowthEventKind::last_length,
          fmt::format("{} has its last length, {:.6g}", tips[tip].name, last));
    }
    // A front of another growth may lie farther; those of this one are set to the last length.
    if (end && here.tips[tip].a > last * (1.0 + 1e-9)) {
      const double before = stations[stations.size() - 2].s;
      end->s = find_first_crossing([&](double s) { return between.crack_extent(tip, s) - last; },
                                   before, here.s)
                   .value_or(here.s);
    }
  }
  if (rules.cycles) {
    if (const auto s = extent_at_last_cycle(between, end ? end->s : here.s)) {
      end = GrowthEvent{.kind = GrowthEventKind::last_cycle,
                        .reason = fmt::format("{:.6g} cycles are over", *rules.cycles),
                        .s = *s};
    }
  }
  return end ? end : find_futile_growth();
}

// Up to `last`; empty: the cycles that stop the growth are not over there.
std::optional<double> GrowthEndCriteria::extent_at_last_cycle(const GrowthTrajectory& between,
                                                              double last) const {
  const double most = *model.growth->cycles;
  const double first = stations.front().s;
  if (extent_after_cycles) {
    const std::optional<double> s = extent_after_cycles(stations, most);
    return s && *s <= last ? s : std::nullopt;
  }
  return between.cycles(first, last) >= most ? between.extent_after_cycles(first, most)
                                             : std::nullopt;
}

// The last tip of several is told.
std::optional<GrowthEvent> GrowthEndCriteria::find_end_at_first_station() const {
  const model::CrackGrowthSettings& rules = *model.growth;
  const SolvedStation& here = stations.back();
  std::optional<GrowthEvent> end;
  for (std::size_t tip = 0; tip < tips.size(); ++tip) {
    const TipStation& found = here.tips[tip];
    if (const auto K_c = toughness_at_tip(found, rules); K_c && found.K_max >= *K_c) {
      end = event_at_last_station(GrowthEventKind::fracture,
                                  fmt::format("K of {} is {} or more from the start",
                                              tips[tip].name, toughness_key(found)));
    } else if (rules.flow_stress && here.tips[tip].plastic >= 1.0) {
      end = event_at_last_station(
          GrowthEventKind::net_section,
          fmt::format("the ligament ahead of {} is at its plastic limit from the start",
                      tips[tip].name));
    }
  }
  if (!end && !(here.growth_rate() > 0.0)) {
    const bool shut = closed(here);
    end = event_at_last_station(
        shut ? GrowthEventKind::closed : GrowthEventKind::threshold,
        shut ? "no crack grows: none opens at the largest load, K1 is not above 0"
             : "no crack grows: delta K is not above the threshold");
  }
  return end;
}

// All that a tip has turned by since the first station [rad], left positive.
double GrowthEndCriteria::total_turn_angle(std::size_t tip) const {
  double sum = 0.0;
  for (std::size_t i = 1; i < stations.size(); ++i) {
    sum += std::remainder(stations[i].tips[tip].heading - stations[i - 1].tips[tip].heading,
                          2.0 * std::numbers::pi);
  }
  return sum;
}

// More where DA is so small that the way across the body takes them.
std::size_t GrowthEndCriteria::most_stations() const {
  const std::optional<double>& longest = model.growth->largest_advance;
  if (!longest) {
    return futility_policy.stations;
  }
  const double advances = 2.0 * geometry::Box<3>::around(model.mesh.x).diagonal() / *longest;
  return futility_policy.stations + static_cast<std::size_t>(std::min(advances, 1e6));
}

// Growth that goes on and leads nowhere.
std::optional<GrowthEvent> GrowthEndCriteria::find_futile_growth() const {
  double fastest = 0.0;
  for (const SolvedStation& station : stations) {
    fastest = std::max(fastest, station.growth_rate());
  }
  const double rate = stations.back().growth_rate();
  if (std::isfinite(fastest) && rate < futility_policy.rest * fastest) {
    return event_at_last_station(
        GrowthEventKind::arrest,
        fmt::format("the growth has come to rest: it is {:.1e} of the fastest", rate / fastest));
  }
  for (std::size_t tip = 0; tip < tips.size(); ++tip) {
    if (std::abs(total_turn_angle(tip)) > 2.0 * std::numbers::pi) {
      return event_at_last_station(GrowthEventKind::curl,
                                   fmt::format("{} has turned by a full circle", tips[tip].name));
    }
  }
  if (stations.size() >= most_stations()) {
    return event_at_last_station(
        GrowthEventKind::endless,
        fmt::format("the growth has not ended after {} stations", stations.size()));
  }
  return std::nullopt;
}

} // namespace spricka::growth
