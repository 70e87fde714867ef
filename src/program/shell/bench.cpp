// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/bench.hpp"

#include "analysis/lengths/path_correction.hpp"
#include "analysis/lengths/shown_results.hpp"
#include "analysis/recover/finite_results.hpp"
#include "analysis/scene/gone_nodes.hpp"
#include "base/tidy.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr std::size_t path_from = 0; // steps of `shown_`, which give a path's ends their names
constexpr std::size_t path_to = 1;

base::OperationFailure interrupted() {
  return {.kind = base::ProgramOutcome::stopped, .why = "stopped; everything is as it was before"};
}

// The deck with three steps of no content in the place of its own: the ends of a path, and NOW.
model::Model model_to_show(const model::Model& model) {
  model::Model shown = model;
  shown.growth.reset();
  shown.load_paths.clear();
  shown.checks.clear();
  shown.steps.clear();
  for (const char* name : {"FROM", "TO", "NOW"}) {
    shown.steps.emplace_back().name = name;
  }
  return shown;
}

// Whether a way is another one and a single step more.
bool is_one_further(const std::vector<model::Step>& way, const std::vector<model::Step>& than) {
  return way.size() == than.size() + 1 &&
         std::ranges::equal(than, std::span(way).first(than.size()),
                            [](const model::Step& a, const model::Step& b) {
                              return a.substeps == b.substeps && a.actions == b.actions;
                            });
}

// The only increment of the run, with the mesh of a length and no step yet.
results::CrackLengthResult first_increment(const analysis::CrackLengthAnalysis& length,
                                           const model::Mesh& host) {
  const analysis::Discretisation& scene = length.discretisation();
  const mesh::CrackedMesh& cracked = scene.cracked;
  results::CrackLengthResult increment;
  increment.number = 1;
  increment.a = base::restore_short_decimal(length.first_crack_size());
  increment.notes = results::make_plain_notes(scene.notes);
  increment.mesh = cracked.mesh;
  increment.surface = analysis::outer_faces_by_nodes(increment.mesh);
  analysis::keep_removed_set_members(host, increment.mesh);
  increment.kept = static_cast<std::size_t>(
      std::ranges::count_if(cracked.host, [](base::ElementId e) { return e.valid(); }));
  return increment;
}

// Solves the steps one by one; stops where faces touch.
base::OptionalFailure advance(const analysis::CrackLengthAnalysis& length,
                              const std::function<bool()>& stopped,
                              const std::vector<model::Step>& steps, ReachedShellState& reached) {
  for (const model::Step& step : steps) {
    if (stopped && stopped()) {
      return interrupted();
    }
    base::OptionalFailure trouble;
    reached.state = reached.solver->solve(step, trouble);
    if (!reached.state) {
      trouble->why = fmt::format("step {}: {}", step.name, trouble->why);
      return trouble;
    }
    results::LoadStepResult numbers;
    numbers.u = reached.state->u;
    numbers.reaction = reached.state->reaction;
    if (const std::string what = analysis::find_nonfinite_result(numbers); !what.empty()) {
      return base::OperationFailure{.kind = base::ProgramOutcome::not_solvable,
                                    .why = fmt::format("step {}: {}", step.name, what)};
    }
    // Overlap in any step counts: all of them are solved anew with the faces as a pair.
    reached.touching = length.cracks_with_overlapping_faces(reached.state->u);
    if (!reached.touching.empty()) {
      return {};
    }
  }
  return {};
}

} // namespace

InteractiveSolver::InteractiveSolver(const InteractiveSolverInputs& parts)
    : parts_(parts), shown_(model_to_show(parts.model)) {}

std::unique_ptr<InteractiveSolver> InteractiveSolver::make(const InteractiveSolverInputs& parts,
                                                           analysis::CrackRegionPlan& plan,
                                                           base::Diagnostics& diagnostics,
                                                           base::OptionalFailure& trouble) {
  std::unique_ptr<InteractiveSolver> bench(new InteractiveSolver(parts));
  bench->length_ = analysis::CrackLengthAnalysis::create({.model = parts.model,
                                                          .cache = parts.cache,
                                                          .threads = parts.threads,
                                                          .mounted = parts.memory,
                                                          .contact = &parts.contact,
                                                          .with_paths = &bench->shown_,
                                                          .engine = parts.engine},
                                                         0.0, plan, diagnostics);
  if (!bench->length_) {
    return nullptr;
  }
  bench->run_.increments.push_back(first_increment(*bench->length_, parts.model.mesh));
  trouble = bench->stopped() ? interrupted() : bench->prepare();
  if (!trouble && bench->stopped()) {
    trouble = interrupted();
  }
  return trouble ? nullptr : std::move(bench);
}

base::OptionalFailure InteractiveSolver::prepare() {
  condensed_ = {};
  if (!length_->condense(condensed_)) {
    return condensed_.trouble;
  }
  fresh_ = length_->make_solver();
  solver_.reset();
  state_.reset();
  estimated_ = false;
  run_.increments.front().steps.clear();
  run_.increments.front().paths.clear();
  return {};
}

base::OptionalFailure InteractiveSolver::close(const std::vector<std::size_t>& lines) {
  solver_.reset(); // it looks at the rows of the scene
  fresh_.reset();
  ++closings_;
  length_->add_face_contact(lines);
  if (parts_.fills_memory && parts_.memory != nullptr) {
    *parts_.memory = analysis::MountOffsetMemory(); // of steps that do not count
  }
  return prepare();
}

base::OptionalFailure InteractiveSolver::reach(const std::vector<model::Step>& way,
                                               ReachedShellState& reached) {
  while (true) {
    if (parts_.memory != nullptr) {
      parts_.memory->begin_new_length();
    }
    // A copy: the compliances of the rows are computed once, each way begins as a run does.
    reached = {std::make_unique<analysis::StepSolver>(*fresh_), {}, {}};
    if (base::OptionalFailure trouble = advance(*length_, parts_.stopped, way, reached)) {
      return trouble;
    }
    if (reached.touching.empty()) {
      return {};
    }
    if (base::OptionalFailure trouble = close(reached.touching)) {
      return trouble;
    }
  }
}

results::LoadStepResult InteractiveSolver::gather(const ReachedShellState& reached,
                                                  const std::string& name) const {
  model::Step step;
  step.name = name;
  results::LoadStepResult out = length_->recover_step(step, *reached.state);
  const model::Mesh& mesh = length_->discretisation().cracked.mesh;
  analysis::fill_removed_node_displacements(
      mesh, analysis::locate_removed_nodes(parts_.model.mesh, mesh), out.u);
  return out;
}

void InteractiveSolver::take(ReachedShellState reached, const std::vector<model::Step>& way) {
  std::vector<results::LoadStepResult>& steps = run_.increments.front().steps;
  results::LoadStepResult now = gather(reached, "NOW");
  // The present state is the first of the steps; those that add_deck_step_result() adds stand
  // behind it.
  if (steps.empty()) {
    steps.push_back(std::move(now));
  } else {
    steps.front() = std::move(now);
  }
  solver_ = std::move(reached.solver);
  state_ = std::move(reached.state);
  estimated_ = false;
  way_ = way;
}

base::OptionalFailure InteractiveSolver::solve_from_unloaded(const std::vector<model::Step>& way) {
  const std::vector<model::Step> before = way_;
  ReachedShellState reached;
  if (base::OptionalFailure trouble = reach(way, reached)) {
    if (!solver_ && !before.empty() && !reach(before, reached)) { // faces were closed meanwhile
      take(std::move(reached), before);
    }
    return trouble;
  }
  take(std::move(reached), way);
  return {};
}

base::OptionalFailure InteractiveSolver::solve_further_step(const model::Step& step,
                                                            const std::vector<model::Step>& way) {
  // A copy: the present state stays if the step has no answer.
  ReachedShellState reached{std::make_unique<analysis::StepSolver>(*solver_), {}, {}};
  if (base::OptionalFailure trouble = advance(*length_, parts_.stopped, {step}, reached)) {
    return trouble;
  }
  if (!reached.touching.empty()) { // solved anew with contact between them, from the beginning
    return solve_from_unloaded(way);
  }
  take(std::move(reached), way);
  return {};
}

// Bars of K, by which it is corrected, without derivatives.
base::OptionalFailure InteractiveSolver::correct_K(const ReachedShellState& reached,
                                                   results::LoadStepResult& found) {
  return length_->add_error_bars_and_sensitivities(
             *reached.solver, *reached.state, false, found,
             [&](const std::string&, const std::string&) { return !stopped(); })
             ? base::OptionalFailure()
             : interrupted();
}

base::OptionalFailure InteractiveSolver::estimate_accuracy() {
  if (estimated_ || length_->discretisation().cracked.fronts.empty()) {
    return {};
  }
  results::LoadStepResult found = current_result();
  if (!length_->add_error_bars_and_sensitivities(
          *solver_, *state_, true, found,
          [&](const std::string&, const std::string&) { return !stopped(); })) {
    return interrupted();
  }
  run_.increments.front().steps.front() = std::move(found);
  estimated_ = true;
  return {};
}

void InteractiveSolver::estimate_net_errors() {
  results::LoadStepResult& step = run_.increments.front().steps.front();
  if (step.errors.empty()) {
    length_->add_net_errors(state_->energy, step);
  }
}

base::OptionalFailure InteractiveSolver::add_deck_step_result(std::size_t step) {
  const std::vector<model::Step>& steps = parts_.model.steps;
  if (results::find_step(run_.increments.front(), steps[step].name) != nullptr) {
    return {};
  }
  const std::vector<model::Step> now = way_;
  ReachedShellState reached;
  const std::vector<model::Step> way(steps.begin(),
                                     steps.begin() + static_cast<std::ptrdiff_t>(step) + 1);
  base::OptionalFailure trouble = reach(way, reached);
  if (!solver_) { // its faces met, so that the present state is to be found again
    ReachedShellState present;
    if (base::OptionalFailure missing = reach(now, present)) {
      return missing;
    }
    take(std::move(present), now);
  }
  if (!trouble) {
    results::LoadStepResult found = gather(reached, steps[step].name);
    trouble = correct_K(reached, found);
    run_.increments.front().steps.push_back(std::move(found));
  }
  return trouble;
}

base::OptionalFailure InteractiveSolver::follow_load_path(const model::LoadPathDefinition& card,
                                                          const std::vector<model::Step>& from,
                                                          const std::vector<model::Step>& to) {
  const std::vector<model::Step> now = way_;
  model::LoadPathDefinition own = card;
  own.from = base::StepId(path_from);
  own.to = base::StepId(path_to);
  std::vector<results::LoadPathResult> found;
  base::OptionalFailure trouble;
  const auto to_end = [&](const std::vector<model::Step>& way, ReachedShellState& reached) {
    // The present state is the beginning of this way: its last step is all that is missing.
    if (solver_ && is_one_further(way, now)) {
      reached = {std::make_unique<analysis::StepSolver>(*solver_), {}, {}};
      base::OptionalFailure stuck = advance(*length_, parts_.stopped, {way.back()}, reached);
      // Faces that meet are closed and solved from the beginning, below.
      if (stuck || reached.touching.empty()) {
        return stuck;
      }
    }
    return reach(way, reached);
  };
  while (!trouble) {
    shown_.load_paths = {own};
    ReachedShellState at_from;
    ReachedShellState at_to;
    trouble = to_end(from, at_from);
    const int before = closings_;
    trouble = trouble ? trouble : to_end(to, at_to);
    if (trouble || closings_ != before) {
      continue; // faces met at the second end: the first is not the same any more
    }
    analysis::LoadPathSolver& paths = length_->load_paths();
    results::LoadStepResult first = gather(at_from, "FROM");
    results::LoadStepResult last = gather(at_to, "TO");
    paths.store_step_end_state(path_from, *at_from.solver, first);
    paths.store_step_end_state(path_to, *at_to.solver, last);
    found = paths.solve_paths(*at_to.solver);
    const std::vector<std::size_t> touching = paths.cracks_with_overlapping_faces();
    if (touching.empty()) {
      trouble = correct_K(at_from, first);
      trouble = trouble ? trouble : correct_K(at_to, last);
      analysis::correct_path_K(first, last, found.front());
      break;
    }
    trouble = close(touching);
  }
  shown_.load_paths.clear();
  if (!solver_) {
    ReachedShellState present;
    if (base::OptionalFailure missing = reach(now, present)) {
      return missing;
    }
    take(std::move(present), now);
  }
  if (!trouble) {
    found.front().from = from.back().name;
    found.front().to = to.back().name;
    std::vector<results::LoadPathResult>& paths = run_.increments.front().paths;
    std::erase_if(paths, [&](const results::LoadPathResult& p) { return p.name == card.name; });
    paths.push_back(std::move(found.front()));
  }
  return trouble;
}

} // namespace spricka::program
