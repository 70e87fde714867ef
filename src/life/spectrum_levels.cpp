// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/spectrum_levels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace spricka::life {

namespace {

// Values that round-off parts are one.
constexpr double same_level = 1e-9;

// Classes for values, the highest first.
std::vector<CycleLevel> classes_for(std::vector<double> values) {
  std::vector<CycleLevel> levels;
  std::sort(values.begin(), values.end(), std::greater<>());
  if (values.empty()) {
    return levels;
  }
  const double top = values.front();
  const double bottom = values.back();
  const double near = same_level * std::max(std::fabs(top), std::fabs(bottom));
  for (const double value : values) {
    if (levels.empty() || value < levels.back().low - near) {
      if (levels.size() == most_levels) { // one more: classes of equal width
        levels.clear();
        for (std::size_t k = most_levels; k-- > 0;) {
          const double width = (top - bottom) / static_cast<double>(most_levels);
          levels.push_back({.low = bottom + width * static_cast<double>(k),
                            .high = bottom + width * static_cast<double>(k + 1)});
        }
        levels.front().high = top;
        return levels;
      }
      levels.push_back({.low = value, .high = value});
    }
  }
  return levels;
}

template <class Value>
std::vector<CycleLevel> sort_into_levels(std::span<const LoadCycle> cycles,
                                         const std::optional<PartsOfCycles>& parts,
                                         const Value& value) {
  std::vector<double> values;
  values.reserve(cycles.size());
  for (const LoadCycle& cycle : cycles) {
    values.push_back(value(cycle));
  }
  std::vector<CycleLevel> levels = classes_for(values);
  if (levels.empty()) {
    return levels;
  }
  const double near = same_level * std::max(std::fabs(levels.front().high), //
                                            std::fabs(levels.back().low));
  for (CycleLevel& level : levels) {
    level.growth = level.life = parts ? 0.0 : no_value;
  }
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    // The first class, from above, whose lower end the value reaches.
    const auto level =
        std::partition_point(levels.begin(), levels.end() - 1,
                             [&](const CycleLevel& of) { return values[i] < of.low - near; });
    level->cycles += cycles[i].count;
    if (parts) {
      level->growth += parts->growth[i];
      level->life += parts->life[i];
    }
  }
  double reached = 0.0;
  for (CycleLevel& level : levels) {
    reached += level.cycles;
    level.reached = reached;
  }
  return levels;
}

} // namespace

std::vector<CycleLevel> sort_by_peak(std::span<const LoadCycle> cycles,
                                     const std::optional<PartsOfCycles>& parts) {
  std::vector<CycleLevel> levels =
      sort_into_levels(cycles, parts, [](const LoadCycle& cycle) { return cycle.high; });
  for (CycleLevel& level : levels) {
    const double near = same_level * std::fabs(level.low);
    level.crossed = 0.0;
    for (const LoadCycle& cycle : cycles) {
      if (cycle.low < level.low - near && cycle.high >= level.low - near) {
        level.crossed += cycle.count;
      }
    }
  }
  return levels;
}

std::vector<CycleLevel> sort_by_range(std::span<const LoadCycle> cycles,
                                      const std::optional<PartsOfCycles>& parts) {
  return sort_into_levels(cycles, parts,
                          [](const LoadCycle& cycle) { return cycle.high - cycle.low; });
}

} // namespace spricka::life
