// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/crack_kinematics.hpp"
#include "growth/growth_events.hpp"
#include "growth/trajectory.hpp"
#include "model/forward.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace spricka::growth {

/// The s of stations after so many cycles from the first one; empty: it lies behind the last.
using ExtentAfterCycles =
    std::function<std::optional<double>(const std::vector<SolvedStation>& stations, double cycles)>;

/// Where a growth ends by what its stations and the functions between them say; all must outlive
/// it.
struct GrowthEndCriteria {
  const model::Model& model;
  const std::vector<TrackedTip>& tips;
  const std::vector<SolvedStation>& stations;   ///< >= 1
  const ExtentAfterCycles& extent_after_cycles; ///< empty: by the rates

  /// The first place between s0 and s1 where K reaches the toughness, the ligament its plastic
  /// limit, or nothing grows any more, if it is so at the last station.
  [[nodiscard]] std::optional<GrowthEvent> find_crossing(const GrowthTrajectory& between, double s0,
                                                         double s1) const;
  /// Whether the growth has ended at the last station or since the one before.
  [[nodiscard]] std::optional<GrowthEvent> find_growth_end(const GrowthTrajectory& between) const;

private:
  [[nodiscard]] std::optional<GrowthEvent> find_end_at_first_station() const;
  [[nodiscard]] std::optional<double> extent_at_last_cycle(const GrowthTrajectory& between,
                                                           double last) const;
  [[nodiscard]] std::optional<GrowthEvent> find_futile_growth() const;
  [[nodiscard]] GrowthEvent event_at_last_station(GrowthEventKind kind, std::string reason) const;
  [[nodiscard]] double total_turn_angle(std::size_t tip) const;
  [[nodiscard]] std::size_t most_stations() const;
};

} // namespace spricka::growth
