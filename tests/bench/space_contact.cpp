// SPDX-License-Identifier: GPL-3.0-or-later
// What contact between solids costs: factors of the bodies, compliances of the rows and the steps
// of a deck at its first length, in flops over dgemm's rate in the same run, and memory against its
// forecast.
// Usage: bench_space_contact DECK [NAME=VALUE ...]
#include "analysis/lengths/length.hpp"
#include "analysis/steps/step_solver.hpp"
#include "base/clock.hpp"
#include "base/diagnostics.hpp"
#include "base/memory.hpp"
#include "base/messages.hpp"
#include "deck/read_deck.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"
#include "program/preview/forecast.hpp"
#include "solve/blas.hpp"
#include "solve/rate.hpp"

#include <cstdio>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace {

using namespace spricka;

// [flop/s] of products of this size, by CPU time: others use the machine.
double dgemm_rate(int n) {
  const base::Matrix A = base::Matrix::Constant(n, n, 1.0 / n);
  const base::Matrix B = base::Matrix::Constant(n, n, 1.0 / n);
  base::Matrix C(n, n);
  const double begin = base::cpu_seconds();
  int products = 0;
  while (base::cpu_seconds() - begin < 0.5) {
    solve::blas::gemm({.m = n, .n = n, .k = n}, solve::blas::as_matrix_block(A),
                      solve::blas::as_matrix_block(B), solve::blas::as_matrix_block(C));
    ++products;
  }
  return 2.0 * n * n * n * products / (base::cpu_seconds() - begin);
}

void line(const char* what, double seconds, double flops, double rate) {
  fmt::print("{:<24} {:8.2f} s  {:9.3g} flops  {:5.1f} Gflop/s, {:.0f} % of dgemm\n", what, seconds,
             flops, 1e-9 * flops / seconds, 100.0 * flops / seconds / rate);
}

} // namespace

int main(int argc, char** argv) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  deck::DeckReadOptions options;
  for (int i = 2; i < argc; ++i) {
    const std::string_view text = argv[i];
    const std::size_t equals = text.find('=');
    if (equals != std::string_view::npos) {
      options.defines.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
  }
  const auto model =
      argc > 1 ? deck::read_deck(argv[1], options, sources, diagnostics) : std::nullopt;
  if (!model) {
    fmt::print(stderr, "usage: bench_space_contact DECK [NAME=VALUE ...]\n{}",
               base::format_messages(sources, diagnostics));
    return 2;
  }
  analysis::CondensationCache cache;
  analysis::CrackRegionPlan plan =
      analysis::plan_crack_region(*model, growth::growth_loop_crack_lengths(*model), diagnostics);
  const double before = base::cpu_seconds();
  const auto length = analysis::CrackLengthAnalysis::create(
      {.model = *model, .cache = cache}, growth::growth_loop_crack_lengths(*model).front(), plan,
      diagnostics);
  if (!length) {
    fmt::print(stderr, "{}", base::format_messages(sources, diagnostics));
    return 3;
  }
  fmt::print("rows made {:.2f} s\n", base::cpu_seconds() - before);
  const solve::FlopRate rate = solve::measure_flop_rate(0.5);
  const double first = dgemm_rate(1000);
  length->number_freedoms();
  results::CrackLengthPreview told;
  program::CostForecast(*model, {.threads = 1, .rate = rate, .exact = true})
      .forecast_crack_length(length->condensation_request(), length->bodies(),
                             length->discretisation(), 0.0, told);
  fmt::print("{} equations, {} rows, {:.0f} MB foretold\n", told.unknowns,
             length->discretisation().table.size(), 1e-6 * told.memory);
  analysis::CondensationStatistics log;
  if (!length->condense(log)) {
    fmt::print(stderr, "{}\n", log.trouble->why);
    return 4;
  }
  const double condensed = base::cpu_seconds();
  const auto solver = length->make_solver();
  const double rows = base::cpu_seconds() - condensed;
  const double flops =
      solver->contact_system() == nullptr ? 0.0 : solver->contact_system()->compliance_flops();
  // Others use the machine: what dgemm does now counts as well.
  const double dgemm = 0.5 * (first + dgemm_rate(1000));
  fmt::print("dgemm {:.1f} Gflop/s; stiffness {:.2f} s, analysis {:.2f} s\n", 1e-9 * dgemm,
             log.stiffness_cpu, log.analysis_cpu);
  line("factors", log.numeric_cpu, log.flops, dgemm);
  if (flops > 0.0) {
    line("compliances of rows", rows, flops, dgemm);
    line("both", log.numeric_cpu + rows, log.flops + flops, dgemm);
  } else {
    fmt::print("dense algebra of rows {:.2f} s\n", rows);
  }
  for (const model::Step& step : model->steps) {
    base::OptionalFailure trouble;
    const double from = base::cpu_seconds();
    const auto state = solver->solve(step, trouble);
    if (!state) {
      fmt::print(stderr, "{}\n", trouble->why);
      return 5;
    }
    fmt::print("step {:<10} {:.2f} s, {} iterations, {} increments, {} pivots\n", step.name,
               base::cpu_seconds() - from, state->iterations, state->increments, state->pivots);
  }
  fmt::print("{:.0f} MB at most, {:.0f} % of the forecast\n",
             1e-6 * static_cast<double>(base::peak_memory()),
             100.0 * static_cast<double>(base::peak_memory()) / told.memory);
  return 0;
}
