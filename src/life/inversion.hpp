// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "life/growth_law.hpp"
#include "life/growth_rate.hpp"

#include <functional>
#include <vector>

namespace spricka::life {

/// K that a crack must have had to grow as it was measured to.
struct InferredK {
  double cycles = 0.0;
  double a = 0.0;
  double rate = 0.0, rate_low = 0.0, rate_high = 0.0; ///< with their 95 % band
  double R = 0.0;                                     ///< K_min / K_max that was assumed
  double K_max = 0.0, low = 0.0, high = 0.0;          ///< not a number where no K gives the rate
  bool covered = true;                                ///< the rate lies within the rows of a table
};

/// The range of K at which the reference grows as the part did (Ansell, Fredriksson 1984, equations
/// 12 and 13; life.21): K_max = delta K / (1 - max(R, 0)) of every rate. R(a): the ratio of K.
std::vector<InferredK> infer_K_from_growth(const MeasuredGrowthRates& rates,
                                           const GrowthRateLaw& reference,
                                           const std::function<double(double)>& R);

} // namespace spricka::life
