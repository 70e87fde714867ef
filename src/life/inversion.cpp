// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/inversion.hpp"

#include <algorithm>

namespace spricka::life {

std::vector<MeasuredK> measured_K(const MeasuredRates& rates, const GrowthLaw& reference,
                                  const std::function<double(double)>& R) {
  std::vector<MeasuredK> found;
  for (const MeasuredRate& point : rates.points) {
    MeasuredK k;
    k.cycles = point.cycles;
    k.a = point.a;
    k.rate = point.rate;
    k.rate_low = point.rate - point.half_width;
    k.rate_high = point.rate + point.half_width;
    k.R = R(point.a);
    const double open = 1.0 - std::max(k.R, 0.0);
    const double range = reference.range(k.rate, k.R);
    k.K_max = range / open;
    k.low = reference.range(k.rate_low, k.R) / open;
    k.high = reference.range(k.rate_high, k.R) / open;
    k.covered = reference.covers(range);
    found.push_back(k);
  }
  return found;
}

} // namespace spricka::life
