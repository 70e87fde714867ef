// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/solve_run.hpp"

#include "base/clock.hpp"
#include "base/memory.hpp"
#include "growth/crack_lines.hpp"
#include "run/growth_loop.hpp"
#include "run/length_solver.hpp"
#include "run/resume.hpp"

#include <utility>

namespace spricka::run {

namespace {

// The lengths of the deck, one after another.
bool solve_lengths(const model::Model& model, const SolveOptions& options,
                   base::Diagnostics& diagnostics, std::optional<Refusal>& refusal,
                   results::Run& run) {
  const std::vector<double> lengths = growth::crack_lengths(model);
  const RegionPlan plan = plan_region(model, lengths, diagnostics);
  if (diagnostics.has_errors()) {
    return false;
  }
  LengthSolver solver(model, options, run.log, diagnostics, refusal);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    const std::vector<bool> pictured = pictured_steps(model, i + 1 == lengths.size());
    if (auto kept = resume(model, options.checkpoint, number, lengths[i], pictured)) {
      solver.go_on(kept->state);
      take_over(std::move(*kept), run);
      continue;
    }
    if (stop_here(options.checkpoint, refusal)) {
      return false;
    }
    const IncrementMark mark(run.log);
    std::optional<std::vector<mesh::CrackLine>> lines =
        growth::crack_lines(model, lengths[i], diagnostics);
    if (!lines) {
      return false;
    }
    std::optional<results::Increment> increment =
        solver.solve({std::move(*lines), lengths[i], pictured}, plan);
    if (!increment) {
      return false;
    }
    increment->number = number;
    run.increments.push_back(std::move(*increment));
    results::NamedArrays state;
    solver.save(state);
    mark.keep(options.checkpoint, lengths[i], run.increments.back(), std::move(state));
    if (options.progress) {
      options.progress(i + 1, lengths.size());
    }
  }
  return true;
}

} // namespace

std::optional<results::Run> solve_run(const model::Model& model, const SolveOptions& options,
                                      base::Diagnostics& diagnostics,
                                      std::optional<Refusal>& refusal) {
  const base::Stopwatch watch;
  results::Run run;
  if (options.checkpoint != nullptr) {
    options.checkpoint->begin_round();
  }
  const bool done = grows_by_law(model) ? grow_by_law(model, options, diagnostics, refusal, run)
                                        : solve_lengths(model, options, diagnostics, refusal, run);
  if (!done) {
    return std::nullopt;
  }
  run.cpu += watch.cpu();
  run.wall += watch.wall();
  run.peak_memory = base::peak_memory();
  return run;
}

} // namespace spricka::run
