// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

namespace spricka::life {

/// `count` cycles between two loads: low <= high, a half cycle has count 0.5.
struct LoadCycle {
  double low = 0.0, high = 0.0;
  double count = 1.0;
};

/// Rainflow count of a history of loads (ASTM E1049-85): half cycles where it does not close
/// (5.4.4), or full cycles only of a history that repeats (5.4.5, begun at its highest peak).
/// Points that do not turn are dropped; a history without a range has no cycles.
std::vector<LoadCycle> count_rainflow_cycles(std::span<const double> history, bool repeated);

/// The full cycles of a history that repeats, each where its peak stands in the history.
std::vector<LoadCycle> count_rainflow_in_order_of_peaks(std::span<const double> history);

} // namespace spricka::life
