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

// Rainflow of points that turn: calls visit(i, j, count) for the ranges between points i < j in the
// order in which they close, and for those that are left; `repeated`: the first and the last point
// are the highest, so that all of them close.
template <class Visit>
void visit_ranges(const std::vector<double>& points, bool repeated, const Visit& visit) {
  std::vector<std::size_t> open; // points whose ranges are not counted yet
  for (std::size_t i = 0; i < points.size(); ++i) {
    open.push_back(i);
    while (open.size() >= 3) {
      std::size_t* last = &open.back();
      const double range = std::fabs(points[last[-1]] - points[last[-2]]);
      if (std::fabs(points[last[0]] - points[last[-1]]) < range) {
        break;
      }
      // a range with the start of the history has not closed
      const bool half = open.size() == 3 && !repeated;
      visit(last[-2], last[-1], half ? 0.5 : 1.0);
      if (half) {
        open.erase(open.begin());
      } else {
        last[-2] = last[0];
        open.resize(open.size() - 2);
      }
    }
  }
  for (std::size_t i = 1; i < open.size(); ++i) {
    visit(open[i - 1], open[i], 0.5);
  }
}

// Turning points of a history that repeats, from its highest one round to that again.
struct RoundFromPeak {
  std::vector<double> points;
  std::size_t peak = 0; ///< where in the pass they begin
};

RoundFromPeak round_from_peak(std::span<const double> history) {
  RoundFromPeak round;
  const std::vector<double> closed = base::closed_turning_points(history);
  const auto peak = std::max_element(closed.begin(), closed.end());
  round.peak = static_cast<std::size_t>(peak - closed.begin());
  round.points.reserve(closed.size() + 1);
  round.points.assign(peak, closed.end());
  round.points.insert(round.points.end(), closed.begin(), peak + 1);
  return round;
}

} // namespace

std::vector<LoadCycle> count_rainflow_cycles(std::span<const double> history, bool repeated) {
  if (history.empty()) {
    return {};
  }
  const std::vector<double> points =
      repeated ? round_from_peak(history).points : base::turning_points(history);
  std::vector<LoadCycle> cycles;
  if (points.size() < 2 || (repeated && points.size() < 3)) {
    return cycles;
  }
  cycles.reserve(points.size() / 2 + 1);
  visit_ranges(points, repeated, [&](std::size_t i, std::size_t j, double count) {
    cycles.push_back(cycle(points[i], points[j], count));
  });
  return cycles;
}

std::vector<LoadCycle> count_rainflow_in_order_of_peaks(std::span<const double> history) {
  if (history.empty()) {
    return {};
  }
  const RoundFromPeak round = round_from_peak(history);
  const std::vector<double>& points = round.points;
  const std::size_t turns = points.size() - 1; // of a pass
  if (turns < 2) {
    return {};
  }
  // A place has one peak, and a peak one cycle.
  std::vector<LoadCycle> at_peak(turns, LoadCycle{.count = 0.0});
  visit_ranges(points, true, [&](std::size_t i, std::size_t j, double count) {
    const std::size_t peak = points[i] > points[j] ? i : j;
    at_peak[(round.peak + peak) % turns] = cycle(points[i], points[j], count);
  });
  std::erase_if(at_peak, [](const LoadCycle& c) { return c.count == 0.0; });
  return at_peak;
}

} // namespace spricka::life
