// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"
#include "model/crack_growth.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace spricka::model {

/// How da/dN is found from readings a(N); equations in manual/theory/life.md.
enum class TestRateMethod {
  secant,     ///< between neighbours (ASTM E647, X1.1; life.15)
  polynomial, ///< parabola through log a(N) round each reading, weighted for a (life.17)
  e647,       ///< the same through a(N) (ASTM E647, X1.2; life.16)
  spline      ///< smoothing spline of log a(N) (life.19)
};

/// How many readings a method needs; `window`: of e647 and polynomial, odd.
constexpr std::size_t readings_needed(TestRateMethod method, int window) {
  return method == TestRateMethod::secant   ? 2
         : method == TestRateMethod::spline ? 8
                                            : static_cast<std::size_t>(window);
}

/// Readings of a crack growth test, and the reference that says at what K a crack grows so.
struct GrowthTestReadings {
  std::string name;
  base::CrackId crack;
  TestRateMethod method = TestRateMethod::polynomial;
  int window = 7;                              ///< readings of a parabola, odd
  std::vector<std::array<double, 2>> readings; ///< N ascending, a > 0 [length]
  /// In space the half axis that is read: C, else A; and the other where it was read too.
  bool on_c = false;
  std::vector<double> other;   ///< [reading, or none]
  std::optional<double> ratio; ///< K_min / K_max of the test; else from the steps
  /// Units and rates of the reference, both ascending; without rates it is the law of $GROW.
  GrowthLawConstants reference;
  base::SourceSpan span;
};

} // namespace spricka::model
