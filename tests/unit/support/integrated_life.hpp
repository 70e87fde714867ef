// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/growth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace spricka::test {

using Rate = std::function<double(double K_max, double R)>;

/// The cycles of one tip by its K(a) at the stations, without any code of the program: ln K_max and
/// R over ln a through the four nearest stations (manual, growth.3), by Neville's scheme; the life
/// by Simpson's rule.
inline double integrated_life(const results::GrowthResult& growth, const Rate& rate) {
  const auto& stations = growth.stations;
  const std::size_t n = stations.size();
  const auto through = [&](std::size_t first, double x, const auto& value) {
    std::vector<double> p;
    std::vector<double> at;
    for (std::size_t k = first; k < first + std::min<std::size_t>(4, n); ++k) {
      at.push_back(std::log(stations[k].points[0].a));
      p.push_back(value(stations[k].points[0]));
    }
    for (std::size_t m = 1; m < p.size(); ++m) {
      for (std::size_t i = 0; i + m < p.size(); ++i) {
        p[i] = ((x - at[i + m]) * p[i] + (at[i] - x) * p[i + 1]) / (at[i] - at[i + m]);
      }
    }
    return p[0];
  };
  double cycles = 0.0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const std::size_t first = std::min(i > 0 ? i - 1 : 0, n - std::min<std::size_t>(4, n));
    const double a0 = stations[i].points[0].a;
    const double h = (stations[i + 1].points[0].a - a0) / 200.0;
    for (int k = 0; k <= 200; ++k) {
      const double x = std::log(a0 + k * h);
      const double K = std::exp(
          through(first, x, [](const results::GrownPointResult& t) { return std::log(t.K_max); }));
      const double R =
          through(first, x, [](const results::GrownPointResult& t) { return t.K_min / t.K_max; });
      cycles += h / 3.0 * (k == 0 || k == 200 ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) / rate(K, R);
    }
  }
  return cycles;
}

} // namespace spricka::test
