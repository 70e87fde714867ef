// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/measured_growth.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace spricka::results {

GrowthTestComparison compare_test_k(const GrowthTestResult& test, double from, double to) {
  GrowthTestComparison sum;
  for (const GrowthTestPoint& point : test.points) {
    const double ratio = point.ratio();
    if (!(point.a >= from && point.a <= to) || std::isnan(ratio)) {
      continue;
    }
    ++sum.points;
    sum.ratio += std::log(ratio);
    sum.rms += (ratio - 1.0) * (ratio - 1.0);
    // a band whose lower end has no K reaches down to nothing, and so for the upper one
    sum.inside += !(point.computed < point.low) && !(point.computed > point.high) ? 1.0 : 0.0;
  }
  const double n = sum.points;
  return {.points = sum.points,
          .ratio = std::exp(sum.ratio / n),
          .rms = std::sqrt(sum.rms / n),
          .inside = sum.inside / n};
}

double measured_k_at(const GrowthTestResult& test, double a) {
  std::vector<GrowthTestPoint> points;
  std::ranges::copy_if(test.points, std::back_inserter(points),
                       [](const GrowthTestPoint& p) { return !std::isnan(p.K); });
  std::ranges::stable_sort(points, {}, &GrowthTestPoint::a);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const GrowthTestPoint& before = points[i - 1];
    const GrowthTestPoint& behind = points[i];
    if (a >= before.a && a <= behind.a && behind.a > before.a) {
      const double t = std::log(a / before.a) / std::log(behind.a / before.a);
      return before.K * std::pow(behind.K / before.K, t);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace spricka::results
