// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/rainflow.hpp"

#include "base/turning_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace spricka::life {

namespace {

LoadCycle cycle(double from, double to, double count) {
  return {.low = std::min(from, to), .high = std::max(from, to), .count = count};
}

// The history from its highest point round to it again.
std::vector<double> from_the_peak(std::span<const double> history) {
  const auto peak = std::max_element(history.begin(), history.end());
  std::vector<double> round(peak, history.end());
  round.insert(round.end(), history.begin(), peak + 1);
  return round;
}

} // namespace

std::vector<LoadCycle> count_rainflow_cycles(std::span<const double> history, bool repeated) {
  if (history.empty()) {
    return {};
  }
  const std::vector<double> points =
      repeated ? base::turning_points(from_the_peak(history)) : base::turning_points(history);
  std::vector<LoadCycle> cycles;
  cycles.reserve(points.size() / 2 + 1);
  std::vector<double> open; // points whose ranges are not counted yet
  for (const double x : points) {
    open.push_back(x);
    while (open.size() >= 3) {
      double* last = &open.back();
      if (std::fabs(last[0] - last[-1]) < std::fabs(last[-1] - last[-2])) {
        break;
      }
      // a range with the start of the history has not closed
      const bool half = open.size() == 3 && !repeated;
      cycles.push_back(cycle(last[-2], last[-1], half ? 0.5 : 1.0));
      if (half) {
        open.erase(open.begin());
      } else {
        last[-2] = last[0];
        open.resize(open.size() - 2);
      }
    }
  }
  for (std::size_t i = 1; i < open.size(); ++i) {
    cycles.push_back(cycle(open[i - 1], open[i], 0.5));
  }
  return cycles;
}

} // namespace spricka::life
