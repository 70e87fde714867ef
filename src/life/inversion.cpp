// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/inversion.hpp"

#include <algorithm>

namespace spricka::life {

std::vector<MeasuredK> infer_K_from_growth(const MeasuredRates& rates,
                                           const GrowthRateLaw& reference,
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
    const double range = reference.K_range_for_rate(k.rate, k.R);
    k.K_max = range / open;
    k.low = reference.K_range_for_rate(k.rate_low, k.R) / open;
    k.high = reference.K_range_for_rate(k.rate_high, k.R) / open;
    k.covered = reference.table_covers(range);
    found.push_back(k);
  }
  return found;
}

} // namespace spricka::life
