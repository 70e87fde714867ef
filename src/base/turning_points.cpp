// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/turning_points.hpp"

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

} // namespace spricka::base
