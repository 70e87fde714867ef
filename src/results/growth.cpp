// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/growth.hpp"

#include <limits>

namespace spricka::results {

double cycles_at_length(const GrowthResult& growth, std::size_t point, double a) {
  constexpr double same = 1e-12;
  const std::vector<LifeCurvePoint>& curve = growth.curve;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double here = curve[i].a[point];
    if (here >= a * (1.0 - same)) {
      if (i == 0 || here <= a * (1.0 + same)) {
        return i == 0 && here > a * (1.0 + same) ? std::numeric_limits<double>::quiet_NaN()
                                                 : curve[i].cycles;
      }
      const double before = curve[i - 1].a[point];
      return curve[i - 1].cycles +
             (a - before) / (here - before) * (curve[i].cycles - curve[i - 1].cycles);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace spricka::results
