// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/length_solver.hpp"

#include "analysis/lengths/growth_measure.hpp"
#include "analysis/lengths/shown_results.hpp"
#include "analysis/recover/finite_results.hpp"
#include "analysis/steps/let_go.hpp"
#include "analysis/steps/repeated_steps.hpp"
#include "base/tidy.hpp"
#include "growth/section_limit.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

std::string fronts_in_words(const Discretisation& scene) {
  const std::size_t count = scene.cracked.fronts.size();
  return count == 0 || scene.has_tips()
             ? fmt::format("{} tips", count)
             : fmt::format("{} {} of {} points", count, count == 1 ? "front" : "fronts",
                           scene.k_layout().points());
}

bool rubs(const Discretisation& scene) {
  return std::ranges::any_of(scene.contacts,
                             [](const model::Contact& contact) { return contact.mu > 0.0; });
}

std::size_t unknowns(const std::vector<SubstructuredBody>& bodies) {
  std::size_t n = 0;
  for (const SubstructuredBody& body : bodies) {
    n += body.region.map.freedom.size();
    for (const std::unique_ptr<Substructure>& part : body.parts) {
      // Externals of a part are unknowns of the region already.
      n += static_cast<std::size_t>(part->map.locals);
    }
  }
  return n;
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

// By front in space, with SFLOW: force and moments of the section before it at the growth's largest
// load, over their plastic limit.
std::vector<double> section_load_ratios(const model::Model& model, const Discretisation& scene,
                                        const results::CrackLengthResult& increment) {
  std::vector<double> ratios;
  if (!model.growth || !model.growth->flow_stress) {
    return ratios;
  }
  for (const mesh::CrackFront& front : scene.cracked.fronts) {
    if (!front.is_tip()) {
      ratios.push_back(growth::plastic_load_ratio(
          {model, scene.cracked, *scene.ties, scene.cls}, front,
          increment.steps[largest_load_step(model)].u, *model.growth->flow_stress));
    }
  }
  return ratios;
}

// Tells that a stage of an increment is done.
void report_stage(const SolveOptions& options, std::string stage, std::size_t step = 0,
                  std::size_t steps = 0) {
  if (options.progress) {
    options.progress({.stage = std::move(stage), .step = step, .steps = steps});
  }
}

// Tells that the last step of an increment under way has its K, or the bars of it.
void show_increment(const SolveOptions& options, const results::CrackLengthResult& increment) {
  if (options.found) {
    options.found(increment);
  }
}

// Which results of a step are no numbers; empty: none.
base::OptionalFailure unsound_numbers(const results::LoadStepResult& result,
                                      const model::Step& step) {
  const std::string what = find_nonfinite_result(result);
  if (what.empty()) {
    return std::nullopt;
  }
  return base::OperationFailure{.kind = base::Outcome::not_solvable,
                                .why = fmt::format("step {}: {}", step.name, what),
                                .span = step.span};
}

/// A step of the deck and the state it ended in.
struct SolvedStep {
  const model::Step& step;
  const StepSolver& solver;
  const StepState& state;
  bool bars = true;
  bool pictured = false; ///< it, or a step that repeats it, is to have its stresses
};

// Bars, sensitivities, stresses of a step's end, as far as they are asked for; not empty: some are
// no numbers.
base::OptionalFailure add_estimates(const model::Model& model, const SolvedStep& solved,
                                    CrackLengthAnalysis& length, LogWriter& log,
                                    results::LoadStepResult& result) {
  const model::Step& step = solved.step;
  if (solved.bars) {
    length.add_error_bars_and_sensitivities(
        solved.solver, solved.state, result,
        [&](const std::string& processor, const std::string& did) {
          log.add_line(processor, fmt::format("step {}: {}", step.name, did));
          return true;
        });
  }
  if (!solved.pictured) {
    return std::nullopt;
  }
  add_stress(model, length.discretisation().cracked.mesh, result);
  log.add_line("RECOVER", fmt::format("step {}: stresses", step.name));
  if (base::OptionalFailure trouble = unsound_numbers(result, step)) {
    return trouble;
  }
  length.add_net_errors(solved.state, result);
  log.add_line("ESTIMATE", fmt::format("step {}: energy error {:.1f} %", step.name,
                                       100.0 * result.errors.back().part));
  return std::nullopt;
}

// Takes K of faces that may overlap from the first solution of a state whose faces meet, where the
// law wants it.
std::optional<OverlappingFaceResults> take_overlap_results(const model::Model& model,
                                                           results::CrackLengthResult& increment) {
  const bool whole = increment.steps.size() == model.steps.size();
  if (!whole || !continues_K_below_closing(model)) {
    return std::nullopt;
  }
  OverlappingFaceResults free;
  for (results::LoadStepResult& step : increment.steps) {
    free.steps.push_back(std::move(step.fronts));
  }
  free.paths = std::move(increment.paths);
  return free;
}

void log_compliances(const StepSolver& solver, LogWriter& log) {
  const double row_flops =
      solver.contact_system() == nullptr ? 0.0 : solver.contact_system()->row_flops();
  log.add_line("CONTACT",
               fmt::format("compliances of the contact rows{}",
                           row_flops > 0.0 ? fmt::format(", {:.3g} flops", row_flops) : ""),
               row_flops > 0.0 ? std::optional(row_flops) : std::nullopt);
}

base::OptionalFailure unsound_numbers(const std::vector<results::LoadPathResult>& paths) {
  for (const results::LoadPathResult& path : paths) {
    if (const std::string what = find_nonfinite_result(path); !what.empty()) {
      return base::OperationFailure{.kind = base::Outcome::not_solvable,
                                    .why = fmt::format("load path {}: {}", path.name, what)};
    }
  }
  return std::nullopt;
}

} // namespace

CrackLengthContext CrackStateSolver::parts() {
  const bool keep = model_.growth && model_.growth->mounted == model::ContactMountingPolicy::first;
  return {.model = grown_ ? *grown_ : model_,
          .cache = cache_,
          .threads = options_.threads,
          .mounted = keep ? &mounted_ : nullptr,
          .contact = &contact_,
          .modes = model_.growth ? &modes_ : nullptr,
          .condensing = options_.condensing};
}

std::optional<results::CrackLengthResult> CrackStateSolver::solve(const CrackStateRequest& request,
                                                                  const CrackRegionPlan& plan) {
  LogWriter log(log_, options_.recorder);
  const double a = request.a;
  if (!request.cracks.solids.empty()) {
    if (!grown_) {
      grown_.emplace(model_);
    }
    grown_->cracks = request.cracks.solids;
  }
  std::unique_ptr<CrackLengthAnalysis> length =
      CrackLengthAnalysis::create(parts(), request.cracks.lines, plan, diagnostics_);
  if (!length) {
    return std::nullopt;
  }
  base::return_free_memory_to_system();
  const Discretisation& cut = length->discretisation();
  const double first = length->first_crack_size();
  // Fronts that K shapes are told by their stations.
  const double reported = a > 0.0 ? a : request.cracks.solids.empty() ? first : 0.0;
  log.add_line("TOPOLOGY",
               fmt::format("{}{} nodes, {} elements, {} contact rows, {}",
                           reported > 0.0 ? fmt::format("a = {:.6g}: ", reported) : "",
                           cut.cracked.mesh.node_count(), cut.cracked.mesh.element_count(),
                           cut.table.size(), fronts_in_words(cut)));
  report_stage(options_, "meshed");
  results::CrackLengthResult increment;
  std::vector<std::size_t> touching;
  free_.reset();
  // Each round but the last makes a pair of one crack at least: there are no more rounds than
  // cracks and one.
  do {
    if (!condense(*length, log)) {
      return std::nullopt;
    }
    report_stage(options_, "condensed");
    increment = {};
    increment.a = a > 0.0 ? a : base::restore_short_decimal(first);
    increment.notes = results::make_plain_notes(cut.notes);
    touching.clear();
    if (!walk_steps(*length, request, log, increment, touching)) {
      return std::nullopt;
    }
    // Of tips alone: the law is given K_min = 0 of fronts in space whose faces touch.
    if (!touching.empty() && !free_ && cut.has_tips()) {
      free_ = take_overlap_results(model_, increment);
    }
    close_faces(touching, *length, log);
  } while (!touching.empty());
  increment.unknowns = unknowns(length->bodies());
  Discretisation scene = CrackLengthAnalysis::take_discretisation(std::move(length));
  fronts_ = scene.cracked.fronts;
  plastic_ = section_load_ratios(model_, scene, increment);
  // From here on what was mounted stands, for MOUNTED=FIRST.
  first_ = false;
  add_shown_results(model_, scene, increment);
  log.record_in_profile("RECOVER", "surface, results of the nodes that the patches took");
  return increment;
}

bool CrackStateSolver::condense(CrackLengthAnalysis& length, LogWriter& log) {
  CondensationStatistics figures;
  const bool condensed = length.condense(figures);
  log.record_net_costs(std::move(figures.nets));
  if (!condensed) {
    trouble_ = figures.trouble;
    return false;
  }
  log.add_line(
      "CONDENSE",
      fmt::format("{} nets condensed, {} reused, {} unknowns, {:.3g} flops; stiffness {:.3f} "
                  "s, analysis {:.3f} s, numeric {:.3f} s",
                  figures.condensed, figures.reused, unknowns(length.bodies()), figures.flops,
                  figures.stiffness_cpu, figures.analysis_cpu, figures.numeric_cpu),
      figures.flops > 0.0 || figures.condensed == 0 ? std::optional(figures.flops) : std::nullopt);
  return true;
}

// Faces that would overlap are a pair from now on, and all steps are solved anew.
void CrackStateSolver::close_faces(const std::vector<std::size_t>& lines,
                                   CrackLengthAnalysis& length, LogWriter& log) {
  if (lines.empty()) {
    return;
  }
  length.add_face_contact(lines);
  const Discretisation& scene = length.discretisation();
  for (const std::size_t i : lines) {
    log.add_line("TOPOLOGY",
                 fmt::format("the faces of {} meet: solved anew with contact between them, {} rows",
                             model_.cracks[i].name,
                             scene.pairs[scene.crack_face_pairs[i]->pair].normal.size()));
  }
  if (first_) {
    mounted_ = MountOffsetMemory(); // of steps that do not count
  }
}

bool CrackStateSolver::follow(CyclicLoadHistorySolver& history, StepSolver& solver,
                              LogWriter& log) {
  next_carried_ = carried_;
  LoadHistoryKResult loads;
  if (!history.solve_load_history(solver, next_carried_, loads, trouble_)) {
    return false;
  }
  if (loads.none.empty()) {
    log.add_line("CONTACT", fmt::format("loads of the growth followed: {} passes, {} increments, K "
                                        "changes by {:.1e} in the last",
                                        loads.passes, loads.increments, loads.change));
  }
  followed_ = std::move(loads);
  return true;
}

// Stops at the first step with faces that would overlap: `touching` says which. Only where K of
// such faces is wanted the first solution goes on with them, without bars and pictures.
bool CrackStateSolver::walk_steps(CrackLengthAnalysis& length, const CrackStateRequest& request,
                                  LogWriter& log, results::CrackLengthResult& increment,
                                  std::vector<std::size_t>& touching) {
  const Discretisation& scene = length.discretisation();
  const std::unique_ptr<StepSolver> first = length.make_solver();
  StepSolver& solver = *first;
  RepeatedSteps repeated(model_, request.pictured);
  LoadPathSolver& paths = length.load_paths();
  CyclicLoadHistorySolver history(model_, scene, length.bodies(), paths);
  const bool follows = depends_on_load_order(model_);
  const bool goes_on = continues_K_below_closing(model_);
  log_compliances(solver, log);
  std::size_t solved = 0;
  for (std::size_t s = 0; s < model_.steps.size(); ++s) {
    const model::Step& step = model_.steps[s];
    if (const std::size_t* earlier = repeated.earlier_step(s)) {
      repeated.copy_step(s, solver, increment.steps);
      show_increment(options_, increment);
      log.add_line("CONTACT", fmt::format("step {}: the same as step {}, taken over", step.name,
                                          model_.steps[*earlier].name));
      paths.store_step_end_state(s, solver, increment.steps.back());
      continue;
    }
    // The closed rows of this step at the last length are the best guess.
    if (std::vector<bool> start =
            contact_.guess_closed_rows(scene, s, solver.closed_contact_rows());
        !start.empty()) {
      solver.set_start_rows(std::move(start));
    }
    base::OptionalFailure trouble;
    const std::optional<StepState> state = solver.solve(step, trouble);
    if (!state && !touching.empty()) {
      return true; // with faces that may overlap there is no answer
    }
    if (!state) {
      trouble->why = fmt::format("step {}: {}", step.name, trouble->why);
      trouble->why += explain_release(model_, scene, length.bodies(), step, trouble->why);
      trouble_ = std::move(trouble);
      return false;
    }
    report_stage(options_, fmt::format("step {}: contact", step.name), solved,
                 repeated.solved_step_count());
    log.add_line("CONTACT",
                 fmt::format("step {}: {} iterations, {} pivots, imbalance {:.1e}", step.name,
                             state->iterations, state->pivots, state->imbalance));
    // Rows that rub start from their own history, not from those of another length.
    if (!rubs(scene)) {
      contact_.store_closed_rows(scene, s, solver.closed_contact_rows());
    }
    repeated.store_closed_rows(s, solver);
    if (touching.empty()) {
      touching = length.cracks_with_overlapping_faces(state->u);
    }
    if (!touching.empty() && !(goes_on && !free_)) {
      return true;
    }
    increment.steps.push_back(length.recover_step(step, *state));
    if (base::OptionalFailure unsound = unsound_numbers(increment.steps.back(), step)) {
      trouble_ = std::move(unsound);
      return false;
    }
    log.add_line("VCE",
                 fmt::format("step {}: {}, pressures, balance", step.name, fronts_in_words(scene)));
    show_increment(options_, increment);
    report_stage(options_, fmt::format("step {}: K", step.name), solved,
                 repeated.solved_step_count());
    paths.store_step_end_state(s, solver, increment.steps.back());
    if (follows) {
      history.store_step_end_state(s, solver, increment.steps.back());
    }
    if (!touching.empty()) {
      continue;
    }
    if (base::OptionalFailure unsound =
            add_estimates(model_,
                          {step, solver, *state, request.bars,
                           request.pictured[s] || repeated.stresses_needed_later(s)},
                          length, log, increment.steps.back())) {
      trouble_ = std::move(unsound);
      return false;
    }
    show_increment(options_, increment);
    report_stage(options_, fmt::format("step {}", step.name), ++solved,
                 repeated.solved_step_count());
  }
  repeated.drop_extra_stresses(increment.steps);
  increment.paths = paths.solve_paths(solver);
  if (base::OptionalFailure unsound = unsound_numbers(increment.paths)) {
    trouble_ = std::move(unsound);
    return false;
  }
  if (!touching.empty()) {
    return true;
  }
  if (follows && !follow(history, solver, log)) {
    return false;
  }
  // Between the steps faces may overlap, too.
  touching = paths.cracks_with_overlapping_faces();
  if (!touching.empty()) {
    return true;
  }
  log_paths(increment.paths, log);
  return true;
}

} // namespace spricka::analysis
