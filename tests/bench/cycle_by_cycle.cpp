// SPDX-License-Identifier: GPL-3.0-or-later
// What a cycle costs whose tip remembers overloads: the program over maps of K between stations,
// against a bare loop over the same states of a centre crack whose K is a formula, in one run.
// Usage: bench_cycle_by_cycle [CYCLES] [REPEATS].
#include "growth/cycle_by_cycle.hpp"
#include "best_of.hpp"
#include "model/steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <vector>

#include <fmt/format.h>

namespace {

using namespace spricka;
using bench::best_of;

constexpr double stress = 40.0;
const double metre = std::sqrt(1000.0);
constexpr double yield = 365.0;
constexpr double kappa = 0.5 * std::numbers::inv_pi;
constexpr double shut_off = 3.0;

double K_of(double a) {
  return stress * std::sqrt(std::numbers::pi * a);
}

std::vector<growth::SolvedStation> stations() {
  std::vector<growth::SolvedStation> all;
  for (double a = 8.0; a < 400.0; a *= 1.1) {
    growth::TipStation tip;
    tip.a = a;
    tip.K_max = K_of(a);
    tip.rate = 1e-4;
    tip.K_over_path = base::PiecewiseLinear({-1.0, 0.0, 1.0}, {-K_of(a), 0.0}, {K_of(a), K_of(a)});
    all.push_back({.s = a, .tips = {tip}});
  }
  return all;
}

// Generalised Willenborg over the formula; `rate` of K_max and K_min.
template <class Rate>
double bare_loop(const model::SpectrumDefinition& spectrum, double threshold, const Rate& rate) {
  double a = 8.0;
  double at = 0.0;
  double zone = 0.0;
  double largest = 0.0;
  for (const auto& [low, high, count] : spectrum.cycles) {
    const double K = K_of(a);
    const double up = high * K;
    const double down = low * K;
    const double own = kappa * up * up / (yield * yield);
    if (a + own >= at + zone) {
      at = a;
      zone = own;
      largest = up;
      a += rate(up, down);
    } else {
      const double required = largest * std::sqrt(1.0 - (a - at) / zone);
      const double off = std::max(0.0, 1.0 - threshold / up) / (shut_off - 1.0) * (required - up);
      a += rate(up - off, down - off);
    }
  }
  return a;
}

template <class Rate>
void compare(const char* name, model::CrackGrowthLaw law,
             const model::GrowthLawConstants& constants, const model::SpectrumDefinition& spectrum,
             int repeats, const Rate& rate) {
  model::LoadInteractionDefinition with;
  with.rule = model::InteractionRule::willenborg;
  with.zone_factor = kappa;
  with.yield_stress = yield;
  with.shut_off_ratio = shut_off;
  with.threshold = 3.2 * metre;
  const life::LoadInteraction interaction(with, life::GrowthRateLaw(law, constants));
  const std::vector<growth::SolvedStation> all = stations();
  const life::CountedSpectrum counted = life::CountedSpectrum::from_definition(spectrum);
  const growth::CycleByCycleGrowth by_cycles(all, counted);
  const auto cycles = static_cast<double>(spectrum.cycles.size());
  double a = 0.0;
  const double program = best_of(
      repeats, [&] { a = by_cycles.extent_after_passes(1.0, interaction, 1e12).value_or(0.0); });
  double b = 0.0;
  const double bare = best_of(repeats, [&] { b = bare_loop(spectrum, *with.threshold, rate); });
  fmt::print("{}: {:.3f} us a cycle, bare loop {:.3f} us, ratio {:.2f} (a {:.9g} and {:.9g})\n",
             name, 1e6 * program / cycles, 1e6 * bare / cycles, program / bare, a, b);
}

} // namespace

int main(int argc, char** argv) {
  const auto count = static_cast<std::size_t>(argc > 1 ? std::atoll(argv[1]) : 1000000);
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 5;
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> u(0.0, 1.0);
  model::SpectrumDefinition spectrum;
  for (std::size_t i = 0; i < count; ++i) {
    const double high = 0.3 + 0.7 * std::pow(u(engine), 2);
    spectrum.cycles.push_back({high * (0.7 * u(engine) - 0.1), high, 1.0});
  }
  model::GrowthLawConstants walker;
  walker.C = 3.1e-8;
  walker.m = 3.273;
  walker.p = 0.618;
  walker.k_unit = metre;
  const double C = 3.1e-8 / std::pow(metre, 3.273);
  compare("Walker", model::CrackGrowthLaw::walker, walker, spectrum, repeats,
          [C](double high, double low) {
            const double R = low / high;
            return R > 0.0 ? C * std::pow((high - low) / std::pow(1.0 - R, 1.0 - 0.618), 3.273)
                           : C * std::pow(high, 3.273);
          });
  model::GrowthLawConstants nasgro;
  nasgro.C = 1.5e-7;
  nasgro.m = 3.2;
  nasgro.p = 0.25;
  nasgro.q = 1.0;
  nasgro.k_c = 200.0 * metre;
  nasgro.threshold = 1.0 * metre;
  nasgro.k_unit = metre;
  const life::NewmanClosure opening(2.0, 0.3);
  const double D = 1.5e-7 / std::pow(metre, 3.2);
  compare("NASGRO", model::CrackGrowthLaw::nasgro, nasgro, spectrum, repeats,
          [&, D](double high, double low) {
            const double range = high - std::max(low, 0.0);
            return range > metre
                       ? D * std::pow((1.0 - opening(low / high)) * high, 3.2) *
                             std::pow(1.0 - metre / range, 0.25) / (1.0 - high / (200.0 * metre))
                       : 0.0;
          });
  return 0;
}
