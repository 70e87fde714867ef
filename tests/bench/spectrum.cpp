// SPDX-License-Identifier: GPL-3.0-or-later
// What a spectrum of many reversals costs: rainflow and sorting once, then the growth of a pass for
// each crack length, by every law. Usage: bench_spectrum [REVERSALS] [REPEATS].
#include "life/spectrum.hpp"
#include "best_of.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

#include <fmt/format.h>

namespace {

using namespace spricka;
using bench::best_of;

// Peaks and valleys, each of its own height.
std::vector<double> reversals(std::size_t count) {
  std::mt19937 engine(1);
  std::normal_distribution<double> load(0.0, 0.14);
  std::vector<double> history(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double away = std::fabs(load(engine));
    history[i] = std::clamp(0.4 + (i % 2 == 0 ? away : -away), 0.0, 1.0);
  }
  return history;
}

// K that bends upwards in 200 segments, as that of a press-fitted lug does.
base::PiecewiseLinear map() {
  constexpr int segments = 200;
  std::vector<double> knot, value, slope;
  const auto K = [](double t) { return 230.0 + 130.0 * t + 270.0 * t * t * t; };
  for (int i = 0; i <= segments; ++i) {
    knot.push_back(static_cast<double>(i) / segments);
  }
  for (int i = 0; i < segments; ++i) {
    const auto k = static_cast<std::size_t>(i);
    value.push_back(K(knot[k]));
    slope.push_back((K(knot[k + 1]) - K(knot[k])) * segments);
  }
  return {knot, value, slope};
}

} // namespace

int main(int argc, char** argv) {
  const auto count = static_cast<std::size_t>(argc > 1 ? std::atoll(argv[1]) : 1000000);
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 5;
  const std::vector<double> history = reversals(count);
  fmt::print("{} reversals\n", count);
  std::vector<life::LoadCycle> cycles;
  fmt::print("rainflow {:.1f} ms\n",
             1e3 * best_of(repeats, [&] { cycles = life::count_rainflow_cycles(history, true); }));
  life::CountedSpectrum spectrum = life::CountedSpectrum::from_cycles(cycles);
  fmt::print(
      "rainflow and sorting {:.1f} ms, {} different cycles\n",
      1e3 * best_of(repeats, [&] { spectrum = life::CountedSpectrum::from_sequence(history); }),
      spectrum.cycles().size());
  model::GrowthLawConstants constants;
  constants.C = 1e-12;
  constants.m = 3.1;
  constants.p = 0.5;
  constants.q = 0.5;
  constants.k_c = 2000.0;
  constants.threshold = 20.0;
  constants.delta_k = {20.0, 100.0, 200.0, 400.0, 1000.0};
  constants.growth = {1e-8, 1e-6, 1e-5, 1e-4, 2e-3};
  const base::PiecewiseLinear K = map();
  constexpr std::array laws{std::pair(model::CrackGrowthLaw::paris, "Paris"),
                            std::pair(model::CrackGrowthLaw::walker, "Walker"),
                            std::pair(model::CrackGrowthLaw::forman, "Forman"),
                            std::pair(model::CrackGrowthLaw::nasgro, "NASGRO"),
                            std::pair(model::CrackGrowthLaw::table, "table")};
  for (const auto& [law, name] : laws) {
    const life::GrowthRateLaw growth(law, constants);
    double da = 0.0;
    const double time = best_of(repeats, [&] { da = spectrum.growth_per_pass(growth, K); });
    fmt::print("{}: growth of a pass {:.1f} ms a length (da {:.6g})\n", name, 1e3 * time, da);
  }
  return 0;
}
