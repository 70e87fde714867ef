// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/step_sequence.hpp"

#include "analysis/lengths/growth_measure.hpp"
#include "analysis/lengths/path_correction.hpp"
#include "analysis/lengths/shown_results.hpp"
#include "analysis/recover/finite_results.hpp"
#include "analysis/steps/let_go.hpp"
#include "model/model.hpp"
#include "results/shown_step.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

bool rubs(const Discretisation& scene) {
  return std::ranges::any_of(scene.contacts,
                             [](const model::Contact& contact) { return contact.mu > 0.0; });
}

void log_paths(const std::vector<results::LoadPathResult>& paths, LogWriter& log) {
  for (const results::LoadPathResult& path : paths) {
    if (path.t.empty()) {
      continue;
    }
    log.add_line(
        "LOADPATH",
        fmt::format("path {}: {} breakpoints, {} pivots, {} factorisations, residual {:.1e}, K "
                    "of its steps to {:.1e}",
                    path.name, path.t.size() < 2 ? 0 : path.t.size() - 2, path.pivots,
                    path.factorisations, path.residual, path.mismatch));
  }
}

void log_compliances(const StepSolver& solver, LogWriter& log) {
  const double row_flops =
      solver.contact_system() == nullptr ? 0.0 : solver.contact_system()->compliance_flops();
  log.add_line("CONTACT",
               fmt::format("compliances of the contact rows{}",
                           row_flops > 0.0 ? fmt::format(", {:.3g} flops", row_flops) : ""),
               row_flops > 0.0 ? std::optional(row_flops) : std::nullopt);
}

// Which results of a step are no numbers; empty: none.
base::OptionalFailure unsound_numbers(const results::LoadStepResult& result,
                                      const model::Step& step) {
  const std::string what = find_nonfinite_result(result);
  if (what.empty()) {
    return std::nullopt;
  }
  return base::OperationFailure{.kind = base::ProgramOutcome::not_solvable,
                                .why = fmt::format("step {}: {}", step.name, what),
                                .span = step.span};
}

base::OptionalFailure unsound_numbers(const std::vector<results::LoadPathResult>& paths) {
  for (const results::LoadPathResult& path : paths) {
    if (const std::string what = find_nonfinite_result(path); !what.empty()) {
      return base::OperationFailure{.kind = base::ProgramOutcome::not_solvable,
                                    .why = fmt::format("load path {}: {}", path.name, what)};
    }
  }
  return std::nullopt;
}

} // namespace

std::string describe_fronts(const Discretisation& scene) {
  const std::size_t count = scene.cracked.fronts.size();
  return count == 0 || scene.has_tips()
             ? fmt::format("{} tips", count)
             : fmt::format("{} {} of {} points", count, count == 1 ? "front" : "fronts",
                           scene.k_layout().points());
}

StepSequence::StepSequence(const StepSequenceContext& context, CrackLengthAnalysis& length)
    : context_(context), length_(length), solver_(length.make_solver()),
      repeated_(context.model, context.pictured.known),
      history_(context.model, length.discretisation(), length.bodies(), length.load_paths()) {}

base::OptionalFailure StepSequence::solve(results::CrackLengthResult& increment,
                                          InheritedContactState& carried) {
  log_compliances(*solver_, context_.log);
  for (std::size_t s = 0; s < context_.model.steps.size(); ++s) {
    if (repeated_.earlier_step(s) != nullptr) {
      copy_step(s, increment);
    } else if (solve_step(s, increment) == Continuation::end) {
      if (trouble_) { // what was found so far counts
        finish_error_bars(increment);
      }
      return trouble_;
    }
  }
  finish_error_bars(increment);
  repeated_.drop_extra_stresses(increment.steps);
  add_stresses_of_most_loaded_step(increment);
  if (!trouble_) {
    solve_paths(increment, carried);
  }
  return trouble_;
}

void StepSequence::copy_step(std::size_t s, results::CrackLengthResult& increment) {
  finish_error_bars(increment); // of the step that is copied
  const std::vector<model::Step>& steps = context_.model.steps;
  repeated_.copy_step(s, *solver_, increment.steps);
  show(increment);
  context_.log.add_line("CONTACT",
                        fmt::format("step {}: the same as step {}, taken over", steps[s].name,
                                    steps[*repeated_.earlier_step(s)].name));
  length_.load_paths().store_step_end_state(s, *solver_, increment.steps.back());
}

StepSequence::Continuation StepSequence::solve_step(std::size_t s,
                                                    results::CrackLengthResult& increment) {
  const std::optional<StepState> state = solve_contact(s);
  if (!state) {
    return Continuation::end;
  }
  if (touching_.empty()) {
    touching_ = length_.cracks_with_overlapping_faces(state->u);
  }
  if (!touching_.empty() && !context_.passes_overlap) {
    return Continuation::end;
  }
  if (!recover_step(s, *state, increment)) {
    return Continuation::end;
  }
  begin_error_bars(s, *state, context_.sensitivities && touching_.empty(), increment.steps.back());
  unfinished_.push_back({.step = s, .overlaps = !touching_.empty()});
  if (touching_.empty()) {
    if (context_.pictured.most_loaded) {
      unfinished_.back().energy = state->energy;
    }
    add_stresses(s, *state, increment.steps.back());
    if (trouble_) {
      return Continuation::end;
    }
  }
  if (length_.waiting_bars() != CrackLengthAnalysis::WaitingBars::some) {
    finish_error_bars(increment);
  }
  return Continuation::next_step;
}

// Empty: no answer, with trouble but where faces may overlap.
std::optional<StepState> StepSequence::solve_contact(std::size_t s) {
  const model::Step& step = context_.model.steps[s];
  const Discretisation& scene = length_.discretisation();
  // The closed rows of this step at the last length are the best guess.
  if (std::vector<bool> start =
          context_.contact.guess_closed_rows(scene, s, solver_->closed_contact_rows());
      !start.empty()) {
    solver_->set_initial_closed_rows(std::move(start));
  }
  base::OptionalFailure trouble;
  std::optional<StepState> state = solver_->solve(step, trouble);
  if (!state) {
    if (touching_.empty()) {
      trouble->why = fmt::format("step {}: {}", step.name, trouble->why);
      trouble->why += explain_release(context_.model, scene, length_.bodies(), step, trouble->why);
      trouble_ = std::move(trouble);
    }
    return state;
  }
  report_stage(fmt::format("step {}: contact", step.name));
  context_.log.add_line("CONTACT",
                        fmt::format("step {}: {} iterations, {} pivots, imbalance {:.1e}",
                                    step.name, state->iterations, state->pivots, state->imbalance));
  // Rows that rub start from their own history, not from those of another length.
  if (!rubs(scene)) {
    context_.contact.store_closed_rows(scene, s, solver_->closed_contact_rows());
  }
  repeated_.store_closed_rows(s, *solver_);
  return state;
}

// K, pressures, balance; false: some are no numbers.
bool StepSequence::recover_step(std::size_t s, const StepState& state,
                                results::CrackLengthResult& increment) {
  const model::Step& step = context_.model.steps[s];
  increment.steps.push_back(length_.recover_step(step, state));
  const results::LoadStepResult& result = increment.steps.back();
  if (base::OptionalFailure unsound = unsound_numbers(result, step)) {
    trouble_ = std::move(unsound);
    return false;
  }
  context_.log.add_line("VCE", fmt::format("step {}: {}, pressures, balance", step.name,
                                           describe_fronts(length_.discretisation())));
  show(increment);
  report_stage(fmt::format("step {}: K", step.name));
  length_.load_paths().store_step_end_state(s, *solver_, result);
  if (depends_on_load_order(context_.model)) {
    history_.store_step_end_state(s, *solver_, result);
  }
  return true;
}

void StepSequence::begin_error_bars(std::size_t s, const StepState& state, bool sensitivities,
                                    results::LoadStepResult& result) {
  if (context_.bars) {
    length_.begin_error_bars(*solver_, state, sensitivities, result,
                             [&](const std::string& processor, const std::string& did) {
                               context_.log.add_line(
                                   processor,
                                   fmt::format("step {}: {}", context_.model.steps[s].name, did));
                               return true;
                             });
  }
}

// Of the steps that wait: together they cost less.
void StepSequence::finish_error_bars(results::CrackLengthResult& increment) {
  if (length_.waiting_bars() != CrackLengthAnalysis::WaitingBars::none) {
    std::vector<results::LoadStepResult*> waiting;
    std::vector<std::string> names;
    for (const UnfinishedStep& unfinished : unfinished_) {
      waiting.push_back(&increment.steps[unfinished.step]);
      names.push_back(waiting.back()->step);
    }
    length_.finish_error_bars(waiting);
    context_.log.add_line("ESTIMATE", fmt::format("{} {}: error bars of K",
                                                  names.size() == 1 ? "step" : "steps",
                                                  fmt::join(names, ", ")));
  }
  const std::vector<UnfinishedStep> finished = std::exchange(unfinished_, {});
  for (const UnfinishedStep& step : finished) {
    end_step(step, increment);
  }
}

void StepSequence::end_step(const UnfinishedStep& step,
                            const results::CrackLengthResult& increment) {
  if (step.overlaps || trouble_) {
    return;
  }
  if (context_.pictured.most_loaded && results::most_loaded_step(increment) == step.step) {
    energy_ = step.energy;
  }
  show(increment);
  ++solved_;
  report_stage(fmt::format("step {}", context_.model.steps[step.step].name));
}

void StepSequence::add_stresses(std::size_t s, const StepState& state,
                                results::LoadStepResult& result) {
  if (context_.pictured.known[s] || repeated_.stresses_needed_later(s)) {
    recover_stresses(s, state.energy, result);
  }
}

// Energy: of strain, by element.
void StepSequence::recover_stresses(std::size_t s, const std::vector<double>& energy,
                                    results::LoadStepResult& result) {
  add_stress_fields(context_.model, length_.discretisation().cracked.mesh, result);
  context_.log.add_line("RECOVER", fmt::format("step {}: stresses", result.step));
  trouble_ = unsound_numbers(result, context_.model.steps[s]);
  if (trouble_) {
    return;
  }
  length_.add_net_errors(energy, result);
  context_.log.add_line("ESTIMATE", fmt::format("step {}: energy error {:.1f} %", result.step,
                                                100.0 * result.errors.back().part));
}

// A step that repeats an earlier one is loaded as much and comes later: it is none of them.
void StepSequence::add_stresses_of_most_loaded_step(results::CrackLengthResult& increment) {
  if (!context_.pictured.most_loaded || !touching_.empty()) {
    return;
  }
  const std::size_t s = results::most_loaded_step(increment);
  if (increment.steps[s].stress.empty()) {
    recover_stresses(s, energy_, increment.steps[s]);
  }
}

void StepSequence::solve_paths(results::CrackLengthResult& increment,
                               InheritedContactState& carried) {
  LoadPathSolver& paths = length_.load_paths();
  increment.paths = paths.solve_paths(*solver_);
  trouble_ = unsound_numbers(increment.paths);
  if (trouble_) {
    return;
  }
  correct_paths(increment);
  if (!touching_.empty()) {
    return;
  }
  if (depends_on_load_order(context_.model) && !follow_growth_loads(carried)) {
    return;
  }
  // Between the steps faces may overlap, too.
  touching_ = paths.cracks_with_overlapping_faces();
  if (touching_.empty()) {
    log_paths(increment.paths, context_.log);
  }
}

// By the errors at the ends of the paths.
void StepSequence::correct_paths(results::CrackLengthResult& increment) const {
  for (std::size_t p = 0; p < increment.paths.size(); ++p) {
    const model::LoadPathDefinition& card = context_.model.load_paths[p];
    correct_path_K(increment.steps[card.from.index()], increment.steps[card.to.index()],
                   increment.paths[p]);
  }
}

bool StepSequence::follow_growth_loads(InheritedContactState& carried) {
  LoadHistoryKResult loads;
  if (!history_.solve_load_history(*solver_, carried, loads, trouble_)) {
    return false;
  }
  if (loads.none.empty()) {
    context_.log.add_line("CONTACT",
                          fmt::format("loads of the growth followed: {} passes, {} increments, K "
                                      "changes by {:.1e} in the last",
                                      loads.passes, loads.increments, loads.change));
  }
  followed_ = std::move(loads);
  return true;
}

void StepSequence::report_stage(std::string stage) const {
  if (context_.options.progress) {
    context_.options.progress(
        {.stage = std::move(stage), .step = solved_, .steps = repeated_.solved_step_count()});
  }
}

// Tells that the last step of the increment under way has its K, or the bars of it.
void StepSequence::show(const results::CrackLengthResult& increment) const {
  if (context_.options.found) {
    context_.options.found(increment);
  }
}

} // namespace spricka::analysis
