// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "tests/unit/support/solved_text.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include <gtest/gtest.h>

/// How many error bars of K along a front hold, and how tight they are.
namespace spricka::test {

/// K1, K2 and K3 of a step at the angle phi of a front.
using Exact = std::function<std::array<double, 3>(const std::string& step, double phi)>;

inline constexpr double counts_from =
    1e-3; // errors of raw K of this part of the largest K count for the width

struct Tally {
  int all = 0, inside = 0, large = 0, tight = 0;
  double raw = 0.0, error = 0.0; ///< squares of the errors of raw K and of K, of the largest K

  Tally& operator+=(const Tally& t) {
    all += t.all;
    inside += t.inside;
    large += t.large;
    tight += t.tight;
    raw += t.raw;
    error += t.error;
    return *this;
  }
};

inline Tally tally_of(const results::LoadStepResult& step, const Exact& exact) {
  Tally tally;
  const results::FrontResult& front = step.fronts.front();
  EXPECT_EQ(front.missing_bar_reason, "");
  double size = 0.0;
  for (const results::FrontPointResult& place : front.points) {
    size = std::max(size, std::hypot(place.K1, place.K2, place.K3));
  }
  for (const results::FrontPointResult& place : front.points) {
    if (place.at_surface) {
      continue;
    }
    const std::array<double, 3> truth = exact(step.step, place.phi);
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = std::abs(truth[k] - place.K()[k]);
      const double raw = std::abs(truth[k] - place.raw_K()[k]);
      const double bar = place.bar[k].size();
      tally.all += 1;
      tally.inside += error <= bar ? 1 : 0;
      if (raw > counts_from * size) {
        tally.large += 1;
        tally.tight += error <= bar && bar <= 1.5 * raw ? 1 : 0;
      }
      tally.raw += std::pow(raw / size, 2);
      tally.error += std::pow(error / size, 2);
    }
  }
  return tally;
}

inline Tally tally_of(const Solved& solved, const Exact& exact) {
  Tally tally;
  for (const results::LoadStepResult& step : solved.run.increments.front().steps) {
    tally += tally_of(step, exact);
  }
  return tally;
}

inline void expect_good(const Tally& t) {
  std::printf("%d of %d inside, %d of %d tight, rms error %.3f %%, of raw K %.3f %%\n", t.inside,
              t.all, t.tight, t.large, 100.0 * std::sqrt(t.error / t.all),
              100.0 * std::sqrt(t.raw / t.all));
  EXPECT_GE(t.inside, 0.95 * t.all);
  EXPECT_GE(t.tight, 0.8 * t.large);
  EXPECT_LT(t.error, t.raw / 4.0);
}

} // namespace spricka::test
