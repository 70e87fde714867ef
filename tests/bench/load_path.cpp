// SPDX-License-Identifier: GPL-3.0-or-later
// What the map of K over a load path costs, and a later K from it. Usage: bench_load_path DECK
// [REPEATS]: the first length and the first $LOADPATH of the deck.
#include "analysis/lengths/length.hpp"
#include "base/diagnostics.hpp"
#include "best_of.hpp"
#include "deck/read_deck.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cstdlib>
#include <random>

#include <fmt/format.h>

namespace {

using namespace spricka;
using bench::best_of;

void measure_path(const solve::ParametricProblem& problem, double end,
                  const std::vector<bool>& start, int repeats) {
  solve::SolutionPath path;
  const double whole = best_of(repeats, [&] {
    path = solve::follow_solution_path(problem, 0.0, end, solve::SolutionPathSettings{}, start);
  });
  const double first = path.segments.front().to;
  solve::SolutionPath none;
  const double begin = best_of(repeats, [&] {
    none = solve::follow_solution_path(problem, 0.0, 0.5 * first, solve::SolutionPathSettings{},
                                       start);
  });
  const auto kinks = static_cast<double>(path.segments.size() - 1);
  fmt::print("{} rows, {} breakpoints, {} pivots, {} factorisations, residual {:.1e}\n",
             problem.db.size(), path.segments.size() - 1, path.pivots, path.factorisations,
             path.residual);
  fmt::print("whole path {:.1f} ms, of that its beginning {:.1f} ms; {:.0f} us for each further "
             "breakpoint\n",
             1e3 * whole, 1e3 * begin, 1e6 * (whole - begin) / kinks);
}

void measure_values(const results::LoadPathResult& path, int repeats) {
  constexpr std::size_t count = 1 << 16;
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> place(path.t.front(), path.t.back());
  std::vector<double> t(count);
  for (double& x : t) {
    x = place(engine);
  }
  double sum = 0.0;
  const base::PiecewiseLinear& K = path.fronts.front().single_point().K[0];
  const double time = best_of(repeats, [&] {
    for (const double x : t) {
      sum += K(x);
    }
  });
  fmt::print("a K1 at any t: {:.1f} ns (mean K1 {:.6g})\n", 1e9 * time / count,
             sum / static_cast<double>(count) / repeats);
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: bench_load_path DECK [REPEATS]\n");
    return 2;
  }
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 5;
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const std::optional<model::Model> model = deck::read_deck(argv[1], {}, sources, diagnostics);
  if (!model || diagnostics.has_errors() || model->load_paths.empty()) {
    fmt::print(stderr, "no deck with a $LOADPATH\n");
    return 2;
  }
  const std::vector<double> lengths = growth::growth_loop_crack_lengths(*model);
  analysis::CrackRegionPlan plan = analysis::plan_crack_region(*model, lengths, diagnostics);
  analysis::CondensationCache cache;
  analysis::CondensationStatistics log;
  const std::unique_ptr<analysis::CrackLengthAnalysis> length =
      analysis::CrackLengthAnalysis::create({.model = *model, .cache = cache}, lengths.front(),
                                            plan, diagnostics);
  if (!length || !length->condense(log)) {
    fmt::print(stderr, "the deck has mistakes\n");
    return 2;
  }
  const std::unique_ptr<analysis::StepSolver> first = length->make_solver();
  analysis::StepSolver& solver = *first;
  analysis::LoadPathSolver& paths = length->load_paths();
  for (std::size_t s = 0; s < model->steps.size(); ++s) {
    base::OptionalFailure trouble;
    const auto state = solver.solve(model->steps[s], trouble);
    if (!state) {
      fmt::print(stderr, "{}\n", trouble->why);
      return 4;
    }
    paths.store_step_end_state(s, solver, length->recover_step(model->steps[s], *state));
  }
  const model::LoadPathDefinition& card = model->load_paths.front();
  const base::Stopwatch posing;
  const solve::ParametricProblem problem = paths.parametric_path_problem(card, solver);
  fmt::print("functionals of K and the problem {:.1f} ms\n", 1e3 * posing.cpu_time());
  measure_path(problem, card.beyond, {}, repeats);
  std::vector<results::LoadPathResult> found;
  const double all = best_of(repeats, [&] { found = paths.solve_paths(solver); });
  fmt::print("all of it, K of its ends and contact arcs included: {:.1f} ms\n", 1e3 * all);
  measure_values(found.front(), repeats);
  return 0;
}
