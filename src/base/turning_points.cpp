// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/turning_points.hpp"

#include <cstddef>

namespace spricka::base {

std::vector<double> turning_points(std::span<const double> history) {
  std::vector<double> points;
  points.reserve(history.size());
  for (const double x : history) {
    const std::size_t n = points.size();
    if (n > 0 && x == points[n - 1]) {
      continue;
    }
    if (n > 1 && (points[n - 1] > points[n - 2]) == (x > points[n - 1])) {
      points[n - 1] = x;
    } else {
      points.push_back(x);
    }
  }
  return points;
}

std::vector<double> closed_turning_points(std::span<const double> history) {
  std::vector<double> points = turning_points(history);
  std::size_t first = 0;
  while (points.size() - first > 1) {
    const double start = points[first];
    const double end = points.back();
    if (end == start || (end > points[points.size() - 2]) == (start > end)) {
      points.pop_back();
    } else if ((start > end) == (points[first + 1] > start)) {
      ++first;
    } else {
      break;
    }
  }
  points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first));
  return points;
}

} // namespace spricka::base
