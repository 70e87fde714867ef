// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/growth_test.hpp"

#include <span>
#include <vector>

namespace spricka::life {

/// One reading of a crack growth test.
struct CrackReading {
  double cycles = 0.0;
  double a = 0.0; ///< [length]
};

struct MeasuredGrowthRate {
  double cycles = 0.0;
  double a = 0.0;          ///< smoothed; of a secant half way
  double rate = 0.0;       ///< da/dN [length per cycle]; scatter may make it negative
  double half_width = 0.0; ///< the rate lies within rate +- this with 95 %
};

struct MeasuredGrowthRates {
  std::vector<MeasuredGrowthRate> points; ///< by cycles
  double scatter = 0.0;                   ///< standard deviation of the readings of a [length]
  double freedoms = 0.0;                  ///< spline: how many parameters it is worth
};

/// da/dN from readings [>= model::readings_needed] with ascending cycles and a > 0.
MeasuredGrowthRates compute_growth_rates(std::span<const CrackReading> readings,
                                         model::TestRateMethod method, int window = 7);

} // namespace spricka::life
