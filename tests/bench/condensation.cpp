// SPDX-License-Identifier: GPL-3.0-or-later
// What condensing costs: analysis and numeric phase of all nets of the first increment of a deck,
// against analysis and numeric phase of one plain factorisation of the whole model, in one run.
// Usage: bench_condensation DECK [REPEATS]
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/bodies/whole_stiffness.hpp"
#include "discretised_deck.hpp"
#include "solve/rate.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

namespace {

using namespace spricka;

analysis::CondensationStatistics condense(const model::Model& model,
                                          const analysis::Discretisation& scene) {
  analysis::CondensationCache cache;
  analysis::CondensationStatistics log;
  analysis::condense_bodies(
      {model, scene.cracked.mesh, scene.cls, scene.ties, scene.rest_element, scene.case_load, 1},
      cache, log);
  return log;
}

void line(const char* what, double analysis, double numeric, double flops) {
  fmt::print("{:<28} analysis {:.4f} s, numeric {:.4f} s, {:.3g} flops\n", what, analysis, numeric,
             flops);
}

} // namespace

int main(int argc, char** argv) {
  const bench::DiscretisedDeck deck(argc > 1 ? argv[1] : nullptr,
                                    "bench_condensation DECK [REPEATS]");
  if (deck.exit_code() != 0) {
    return deck.exit_code();
  }
  analysis::CondensationStatistics nets;
  solve::FactorReport plain;
  const auto total = [](const auto& r) { return r.analysis_cpu + r.numeric_cpu; };
  for (int i = 0; i < (argc > 2 ? std::atoi(argv[2]) : 7); ++i) {
    const analysis::CondensationStatistics log = condense(deck.model(), deck.scene());
    const solve::FactorReport report =
        solve::Condensation(analysis::regularised_global_stiffness(deck.model(), deck.scene()), 0)
            .report();
    nets = i == 0 || total(log) < total(nets) ? log : nets;
    plain = i == 0 || total(report) < total(plain) ? report : plain;
  }
  line(fmt::format("{} nets condensed", nets.condensed).c_str(), nets.analysis_cpu,
       nets.numeric_cpu, nets.flops);
  if (plain.status != solve::FactorStatus::ok) {
    fmt::print("the plain factorisation failed: status {}, row {}, {:.0f} of {:.0f} MB\n",
               static_cast<int>(plain.status), plain.failed_row, 1e-6 * plain.memory,
               1e-6 * plain.memory_left);
  }
  line("one plain factorisation", plain.analysis_cpu, plain.numeric_cpu, plain.flops);
  fmt::print("time {:.2f} times, flops {:.2f} times\n", total(nets) / total(plain),
             nets.flops / plain.flops);
  const double peak = solve::measure_flop_rate(0.5).measured;
  fmt::print("numeric phase at {:.0f} % of dgemm on one core ({:.1f} Gflop/s)\n",
             100.0 * nets.flops / nets.numeric_cpu / peak, 1e-9 * peak);
  fmt::print("stiffness of all elements {:.4f} s, {:.3f} of the plain factorisation\n",
             nets.stiffness_cpu, nets.stiffness_cpu / total(plain));
  return 0;
}
