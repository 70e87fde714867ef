// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace spricka::life {

/// One reading of a crack growth test.
struct CrackReading {
  double cycles = 0.0;
  double a = 0.0; ///< [length]
};

/// How da/dN is found from readings a(N); equations in manual/theory/life.md.
enum class GrowthRateMethod {
  secant,     ///< between neighbours (ASTM E647, X1.1; life.15)
  e647,       ///< parabola through a(N) round each reading (ASTM E647, X1.2; life.16)
  polynomial, ///< the same through log a(N), weighted for readings of a (life.17)
  spline      ///< smoothing spline of log a(N) (life.19)
};

struct MeasuredRate {
  double cycles = 0.0;
  double a = 0.0;          ///< smoothed; of a secant half way
  double rate = 0.0;       ///< da/dN [length per cycle]; scatter may make it negative
  double half_width = 0.0; ///< the rate lies within rate +- this with 95 %
};

struct MeasuredRates {
  std::vector<MeasuredRate> points; ///< by cycles
  double scatter = 0.0;             ///< standard deviation of the readings of a [length]
  double freedoms = 0.0;            ///< spline: how many parameters it is worth
};

/// How many readings a method needs; `window`: of e647 and polynomial, odd.
std::size_t readings_needed(GrowthRateMethod method, int window);

/// da/dN from readings [>= readings_needed] with ascending cycles and a > 0.
MeasuredRates measured_rates(std::span<const CrackReading> readings, GrowthRateMethod method,
                             int window = 7);

} // namespace spricka::life
