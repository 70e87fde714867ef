// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/inversion.hpp"

#include <algorithm>

namespace spricka::life {

std::vector<InferredK> infer_K_from_growth(const MeasuredGrowthRates& rates,
                                           const GrowthRateLaw& reference,
                                           const std::function<double(double)>& R) {
  std::vector<InferredK> found;
  for (const MeasuredGrowthRate& point : rates.points) {
    InferredK k;
    k.cycles = point.cycles;
    k.a = point.a;
    k.rate = point.rate;
    k.rate_low = point.rate - point.half_width;
    k.rate_high = point.rate + point.half_width;
    k.R = R(point.a);
    const double open = 1.0 - std::max(k.R, 0.0);
    const model::PlaceOnCrack place{point.a};
    const double range = reference.K_range_for_rate(k.rate, k.R, place);
    k.K_max = range / open;
    k.low = reference.K_range_for_rate(k.rate_low, k.R, place) / open;
    k.high = reference.K_range_for_rate(k.rate_high, k.R, place) / open;
    k.covered = reference.is_within_table(range, k.R);
    found.push_back(k);
  }
  return found;
}

} // namespace spricka::life
