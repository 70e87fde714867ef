// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/note.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

/// Measured crack growth turned back into K, beside the computed one.
namespace spricka::results {

/// A length at which a test has a rate. Values that there are not are not numbers.
struct GrowthTestPoint {
  double cycles = 0.0;
  double a = 0.0;                                     ///< [length]
  double rate = 0.0, rate_low = 0.0, rate_high = 0.0; ///< da/dN, with its 95 % band
  double R = 0.0;                                     ///< K_min / K_max there
  double K = 0.0, low = 0.0, high = 0.0;              ///< K_exp, with the band of the rate
  double computed = 0.0;                              ///< K_max of the finite elements
  bool covered = true;                                ///< the reference reaches to this rate

  [[nodiscard]] double ratio() const { return K / computed; }
};

struct GrowthTestResult {
  std::string name;
  std::string tip;                             ///< that is compared
  std::string method;                          ///< as the card names it
  std::string reference;                       ///< what gave K, in words
  std::vector<std::array<double, 2>> readings; ///< N, a
  std::vector<GrowthTestPoint> points;
  std::vector<std::array<double, 2>> computed; ///< length, ascending, and K1 of the tip at KMAX
  double scatter = 0.0;                        ///< standard deviation of the readings [length]
  double freedoms = 0.0;                       ///< of a spline
  /// From the first to the last point that has a computed K: cycles of the test, and those that
  /// the computed K gives by the reference, with their error by the lengths between which K is
  /// interpolated. Not numbers where there are not.
  double cycles = 0.0, computed_cycles = 0.0, cycles_error = 0.0;
  std::vector<Note> notes;

  /// Computed over measured cycles.
  [[nodiscard]] double life_ratio() const { return computed_cycles / cycles; }
};

/// Comparison over the points with a in [from, to] that have a K and a computed one.
struct GrowthTestComparison {
  int points = 0;
  double ratio = 0.0;  ///< geometric mean of K_exp / computed
  double rms = 0.0;    ///< of K_exp / computed - 1
  double inside = 0.0; ///< share of points whose band holds the computed K
};
/// Compares measured and computed K over the points in the range; without any, the numbers are no
/// numbers and `points` is 0.
GrowthTestComparison compare_test_k(const GrowthTestResult& test, double from, double to);

/// K_exp at a length between two points, straight in the logarithms; not a number elsewhere.
double measured_k_at(const GrowthTestResult& test, double a);

} // namespace spricka::results
