// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/ordered_cycles.hpp"

#include "base/turning_points.hpp"

#include <cstddef>

namespace spricka::life {

std::vector<LoadCycle> pair_valleys_with_peaks(std::span<const double> history) {
  const std::vector<double> points = base::closed_turning_points(history);
  std::vector<LoadCycle> cycles;
  if (points.size() < 2) {
    return cycles;
  }
  cycles.reserve(points.size() / 2);
  const std::size_t first_peak = points[0] > points[1] ? 0 : 1;
  for (std::size_t peak = first_peak; peak < points.size(); peak += 2) {
    cycles.push_back({.low = peak > 0 ? points[peak - 1] : points.back(), .high = points[peak]});
  }
  return cycles;
}

std::vector<LoadCycle> order_cycles(std::span<const double> history,
                                    model::CycleCounting counting) {
  return counting == model::CycleCounting::pairs ? pair_valleys_with_peaks(history)
                                                 : count_rainflow_in_order_of_peaks(history);
}

std::vector<LoadCycle> order_cycles(const model::SpectrumDefinition& spectrum) {
  if (spectrum.sequence) {
    return order_cycles(spectrum.turning_points, spectrum.counting);
  }
  std::vector<LoadCycle> cycles;
  cycles.reserve(spectrum.cycles.size());
  for (const auto& [low, high, count] : spectrum.cycles) {
    cycles.push_back({.low = low, .high = high, .count = count});
  }
  return cycles;
}

} // namespace spricka::life
