// SPDX-License-Identifier: GPL-3.0-or-later
// A spectrum of a million reversals on a deck with $LOADPATH and lengths of $GROW: time to count it
// once, and for the growth of a pass at every length once the maps are known.
#include "analysis/lengths/solve_lengths.hpp"
#include "base/clock.hpp"
#include "deck/read_deck.hpp"
#include "life/spectrum.hpp"
#include "model/model.hpp"

#include <cstdint>
#include <cstdio>
#include <optional>
#include <vector>

#include <fmt/format.h>

int main(int argc, char** argv) {
  using namespace spricka;
  if (argc < 2) {
    fmt::print(stderr, "usage: bench_lug_spectrum DECK\n");
    return 2;
  }
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const std::optional<model::Model> model = deck::read_deck(argv[1], {}, sources, diagnostics);
  if (!model || diagnostics.has_errors() || model->load_paths.empty()) {
    fmt::print(stderr, "no deck with a $LOADPATH\n");
    return 2;
  }
  base::OptionalFailure trouble;
  const std::optional<results::RunResult> run =
      analysis::solve_run(*model, {.threads = 1, .progress = {}}, diagnostics, trouble);
  if (!run) {
    fmt::print(stderr, "not solved\n");
    return 4;
  }
  constexpr std::size_t reversals = 1000000;
  const double last = model->load_paths.front().beyond;
  std::vector<double> t;
  std::uint64_t state = 88172645463325252U; // xorshift: the same numbers everywhere
  for (std::size_t i = 0; i < reversals; ++i) {
    state ^= state << 13U;
    state ^= state >> 7U;
    state ^= state << 17U;
    const double x = static_cast<double>(state >> 11U) * 0x1.0p-53;
    t.push_back(last * (i % 2 == 0 ? 0.5 * x : 0.3 + 0.7 * x));
  }
  const base::Stopwatch counting;
  const life::CountedSpectrum spectrum = life::CountedSpectrum::from_sequence(t);
  const double counted = counting.cpu_time();
  model::GrowthLawConstants constants;
  constants.C = 1e-13;
  constants.m = 3.0;
  const life::GrowthRateLaw law(model::CrackGrowthLaw::paris, constants);
  const base::Stopwatch growing;
  double sum = 0.0;
  for (const results::CrackLengthResult& increment : run->increments) {
    sum +=
        spectrum.growth_per_pass(law, increment.paths.front().fronts.front().single_point().K[0]);
  }
  const double grown = growing.cpu_time();
  fmt::print("{} reversals: counted in {:.3f} s, growth of a pass at {} lengths {:.3f} s, in all "
             "{:.3f} s (sum {:.6g})\n",
             reversals, counted, run->increments.size(), grown, counted + grown, sum);
  return 0;
}
