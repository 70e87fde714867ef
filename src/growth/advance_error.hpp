// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/crack_kinematics.hpp"
#include "growth/growth_events.hpp"
#include "growth/state.hpp"
#include "growth/trajectory.hpp"

#include <optional>
#include <vector>

/// What an advance of all tips has missed, by the station that it led to, the last of all.
namespace spricka::growth {

/// Solutions whose error is more times the tolerance than this do not count. The error is that of a
/// polynomial one order below the one that is used.
inline constexpr double largest_error_over_tolerance = 1.5;

/// Error of the last interval, as a part of the cycles that count there; not a number with two
/// stations.
double interval_cycle_error(const std::vector<SolvedStation>& all, const GrowthRateFunction& law);

/// What the heading turned more than the advance [tip] was bent for [rad]; 0 at the first station.
double excess_turn_angle(const std::vector<SolvedStation>& all, const std::vector<double>& advance);

/// The deferred advance of a station, as a part of the cycles.
double deferred_cycle_error(const SolvedStation& here);

/// What the rates, the new ones too, make of the last advance [tip]: the integral of the shares by
/// the parabola through three stations, or by the trapezoidal rule. What that differs by is
/// deferred: the next advance makes up for it.
void defer_advance_correction(const CrackKinematics& kinematics, const std::vector<double>& advance,
                              std::vector<SolvedStation>& all);

/// Estimated error of the cycles up to the end, or to the last station without one, as a part of
/// them; not a number with two stations.
double total_cycle_error(const std::vector<SolvedStation>& all, const GrowthRateFunction& law,
                         const std::optional<GrowthEvent>& end);

} // namespace spricka::growth
