// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "life/no_value.hpp"
#include "life/rainflow.hpp"

#include <optional>
#include <span>
#include <vector>

/// The cycles of a spectrum by their levels: how many there are, and what they do.
namespace spricka::life {

/// Parts of the growth of a crack and of its life that the cycles of a list have. [cycle]
struct PartsOfCycles {
  std::vector<double> growth, life;
};

/// Cycles whose peak, or range, lies from `low` to `high`: one value, or a class of them.
struct CycleLevel {
  double low = 0.0, high = 0.0;
  double cycles = 0.0;  ///< of a pass
  double reached = 0.0; ///< cycles of this level and of all above it
  /// Of peaks: how often the load of a pass rises through `low`.
  double crossed = no_value;
  double growth = no_value, life = no_value; ///< parts of the whole
};

/// So many different values stand one by one, more of them in as many classes of equal width.
inline constexpr std::size_t most_levels = 24;

/// By their peaks, the highest first. Without `parts` these have no value.
std::vector<CycleLevel> sort_by_peak(std::span<const LoadCycle> cycles,
                                     const std::optional<PartsOfCycles>& parts);
/// By their ranges, the largest first.
std::vector<CycleLevel> sort_by_range(std::span<const LoadCycle> cycles,
                                      const std::optional<PartsOfCycles>& parts);

} // namespace spricka::life
