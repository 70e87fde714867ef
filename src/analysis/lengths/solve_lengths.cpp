// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/solve_lengths.hpp"

#include "analysis/lengths/growth_loop.hpp"
#include "analysis/lengths/length_solver.hpp"
#include "analysis/lengths/pictured_steps.hpp"
#include "analysis/lengths/recorder.hpp"
#include "analysis/lengths/resume.hpp"
#include "archive/increment_store.hpp"
#include "base/clock.hpp"
#include "base/memory.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// With given lengths nothing grows by KMAX and KMIN, but delta K and a test's K are taken from
// them.
void compare_extremes(const model::Model& model, results::RunResult& run) {
  constexpr double clearly = 1e-3;
  const bool named = model.growth && model.growth->kmax.valid() && model.growth->kmin.valid();
  if (!named || run.increments.empty()) {
    return;
  }
  const std::size_t high = model.growth->kmax.index();
  const std::size_t low = model.growth->kmin.index();
  results::CrackLengthResult& last = run.increments.back();
  for (const results::FrontResult& tip : last.steps[high].fronts) {
    const auto upside_down = [&](const results::CrackLengthResult& increment) {
      const results::FrontResult* most = results::find_front(increment.steps[high], tip.name);
      const results::FrontResult* least = results::find_front(increment.steps[low], tip.name);
      return most != nullptr && least != nullptr &&
             most->single_point().K1 <
                 least->single_point().K1 - clearly * std::abs(least->single_point().K1);
    };
    if (tip.is_tip() && std::ranges::all_of(run.increments, upside_down)) {
      last.steps[high].notes.push_back(results::questionable_input_note(
          fmt::format("K1 of {} is larger at KMIN, step {}, than at KMAX, step {}: are "
                      "the two steps exchanged?",
                      tip.name, model.steps[low].name, model.steps[high].name)));
    }
  }
}

// The cracks of one increment; empty, with errors: they do not fit.
std::optional<growth::CrackGeometry> cracks_of(const model::Model& model, double a,
                                               base::Diagnostics& diagnostics) {
  auto lines = growth::crack_lines(model, a, diagnostics);
  if (!lines) {
    return std::nullopt;
  }
  growth::CrackGeometry cracks{.lines = std::move(*lines)};
  if (cracks.lines.empty() && a > 0.0) {
    cracks.solids = growth::resize_solid_cracks(model, a);
  }
  return cracks;
}

// One region for all lengths, so that the rest is condensed once.
CrackRegionPlan one_region(const model::Model& model, const SolveOptions& options,
                           const std::vector<double>& lengths, base::Diagnostics& diagnostics) {
  const ScopedProfileInterval span(options.recorder, "TOPOLOGY", "region of the cracks");
  return plan_crack_region(model, lengths, diagnostics);
}

// The lengths of the deck, one after another.
bool solve_lengths(const model::Model& model, const SolveOptions& options,
                   base::Diagnostics& diagnostics, base::OptionalFailure& trouble,
                   results::RunResult& run) {
  const std::vector<double> lengths = growth::growth_loop_crack_lengths(model);
  CrackRegionPlan plan = one_region(model, options, lengths, diagnostics);
  if (diagnostics.has_errors()) {
    return false;
  }
  CrackStateSolver solver(model, options, run.log, diagnostics, trouble);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    const PicturedSteps pictured =
        steps_with_stress_recovery(model, run.increments, i + 1 == lengths.size());
    const base::Stopwatch resuming;
    if (auto kept =
            accept_stored_increment(model, options.checkpoint, number, lengths[i], pictured)) {
      // What was mounted and closed goes on from the last length that was kept.
      restore_or_report_damage([&] { solver.restore_state(kept->state); });
      append_increment(std::move(*kept), run);
      report_resumed_increment(options, run, lengths.size());
      if (options.recorder != nullptr) {
        options.recorder->add_work("RESTART", "an increment taken over", resuming);
      }
      continue;
    }
    // Lengths that were kept cost nothing: time is asked for before one is solved.
    if (is_time_up(options.checkpoint, trouble)) {
      return false;
    }
    ScopedProfileCrackLength length(options.recorder);
    const IncrementRecorder mark(run.log);
    std::optional<growth::CrackGeometry> cracks = cracks_of(model, lengths[i], diagnostics);
    if (!cracks) {
      return false;
    }
    if (options.progress && i == 0) {
      options.progress({.increments = lengths.size(), .stage = "read"});
    }
    std::optional<results::CrackLengthResult> increment =
        solver.solve({std::move(*cracks), lengths[i], pictured}, plan);
    if (!increment) {
      return false;
    }
    length.set_length(increment->a);
    length.mark_increment();
    const ScopedProfileInterval keeping(options.checkpoint != nullptr ? options.recorder : nullptr,
                                        "RESTART", "state of the increment");
    increment->number = number;
    run.increments.push_back(std::move(*increment));
    results::NamedArrays state;
    solver.save_state(state);
    mark.store_increment(options.checkpoint, lengths[i], run.increments.back(), std::move(state));
    if (options.progress) {
      options.progress({.increment = i + 1, .increments = lengths.size()});
    }
  }
  compare_extremes(model, run);
  return true;
}

} // namespace

std::optional<results::RunResult> solve_run(const model::Model& model, const SolveOptions& options,
                                            base::Diagnostics& diagnostics,
                                            base::OptionalFailure& trouble) {
  const base::Stopwatch watch;
  results::RunResult run;
  if (options.checkpoint != nullptr) {
    options.checkpoint->begin_tolerance_round();
  }
  if (options.recorder != nullptr) {
    options.recorder->begin_tolerance_round();
  }
  const bool done = grows_by_law(model)
                        ? run_growth_by_law(model, options, diagnostics, trouble, run)
                        : solve_lengths(model, options, diagnostics, trouble, run);
  if (!done) {
    return std::nullopt;
  }
  run.cpu += watch.cpu_time();
  run.wall += watch.wall_time();
  run.peak_memory = base::peak_memory();
  return run;
}

} // namespace spricka::analysis
