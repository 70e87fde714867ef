// SPDX-License-Identifier: GPL-3.0-or-later
// What a further crack length costs: all lengths of a deck's $GROW solved one after another without
// error bars and stresses (topology, condensation, contact, steps, K), each against the first,
// which condenses the whole host: once without reading and meshing of the host, once from the start
// of the program to its first K. Reports are in neither. Usage:
// bench_increment DECK [fine] [REPEATS]
#include "analysis/lengths/length_solver.hpp"
#include "base/clock.hpp"
#include "base/diagnostics.hpp"
#include "base/messages.hpp"
#include "deck/read_deck.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace {

using namespace spricka;

struct DeckCost {
  double a = 0.0;
  double cpu = 0.0;
  std::map<std::string, double> of; ///< [processor]
};

/// The lengths in their order, and the program's CPU time when the first was done [s].
struct Costs {
  std::vector<DeckCost> lengths;
  double first_answer = 0.0;
};

Costs solve_all(const model::Model& model) {
  base::Diagnostics diagnostics;
  base::OptionalFailure trouble;
  std::vector<results::LogLine> lines;
  const analysis::SolveOptions options{.threads = 1, .progress = {}};
  const std::vector<double> lengths = growth::growth_loop_crack_lengths(model);
  Costs costs;
  base::Stopwatch watch;
  const analysis::CrackRegionPlan plan = analysis::plan_crack_region(model, lengths, diagnostics);
  analysis::CrackStateSolver solver(model, options, lines, diagnostics, trouble);
  for (const double a : lengths) {
    lines.clear();
    auto cracks = growth::crack_lines(model, a, diagnostics);
    const std::vector<bool> pictured(model.steps.size(), false);
    if (!cracks || !solver.solve({{.lines = std::move(*cracks)}, a, pictured, false}, plan)) {
      return {};
    }
    if (costs.lengths.empty()) {
      costs.first_answer = base::cpu_seconds();
    }
    DeckCost& cost = costs.lengths.emplace_back();
    cost.a = a;
    cost.cpu = watch.cpu_time();
    for (const results::LogLine& line : lines) {
      cost.of[line.processor] += line.cpu;
    }
    watch = base::Stopwatch();
  }
  return costs;
}

} // namespace

int main(int argc, char** argv) {
  base::return_large_blocks_on_free();
  deck::DeckReadOptions options;
  if (argc > 2) {
    options.defines.emplace_back("fine", argv[2]);
  }
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const auto model =
      argc > 1 ? deck::read_deck(argv[1], options, sources, diagnostics) : std::nullopt;
  if (!model) {
    fmt::print(stderr, "usage: bench_increment DECK [fine] [REPEATS]\n{}",
               base::format_messages(sources, diagnostics));
    return 2;
  }
  std::vector<DeckCost> best;
  double first_answer = 0.0;
  for (int i = 0; i < (argc > 3 ? std::atoi(argv[3]) : 7); ++i) {
    const Costs costs = solve_all(*model);
    first_answer = i == 0 ? costs.first_answer : first_answer;
    for (std::size_t k = 0; k < costs.lengths.size(); ++k) {
      if (best.size() == k || costs.lengths[k].cpu < best[k].cpu) {
        best.resize(std::max(best.size(), k + 1));
        best[k] = costs.lengths[k];
      }
    }
  }
  if (best.empty()) {
    fmt::print(stderr, "not solved\n");
    return 4;
  }
  fmt::print("host of {} freedoms\n", 2 * model->mesh.node_count());
  double further = 0.0;
  for (std::size_t k = 0; k < best.size(); ++k) {
    fmt::print("a = {:<8.6g} {:.4f} s, {:.3f} of the first:", best[k].a, best[k].cpu,
               best[k].cpu / best.front().cpu);
    for (const auto& [processor, cpu] : best[k].of) {
      fmt::print(" {} {:.4f}", processor, cpu);
    }
    fmt::print("\n");
    further += k > 0 ? best[k].cpu : 0.0;
  }
  if (best.size() > 1) {
    further /= static_cast<double>(best.size() - 1);
    fmt::print("an increment in the mean {:.4f} s: {:.3f} of the first solve's {:.4f} s, {:.3f} of "
               "the {:.4f} s from the start of the program to the first K\n",
               further, further / best.front().cpu, best.front().cpu, further / first_answer,
               first_answer);
  }
  return 0;
}
