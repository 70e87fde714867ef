// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/length.hpp"

#include "analysis/recover/net_errors.hpp"
#include "analysis/recover/recover_step.hpp"
#include "analysis/scene/patch_region.hpp"
#include "analysis/scene/scene_loads.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

std::unique_ptr<CrackLengthAnalysis>
CrackLengthAnalysis::create(const CrackLengthContext& parts,
                            const std::vector<mesh::CrackLine>& lines, CrackRegionPlan& plan,
                            base::Diagnostics& diagnostics) {
  std::optional<Discretisation> scene = discretise(parts.model, lines, plan, diagnostics);
  if (!scene) {
    return nullptr;
  }
  if (follow_patches(parts.model.mesh, scene->cracked, plan)) {
    mark_rest_elements(plan, *scene);
  }
  return std::make_unique<CrackLengthAnalysis>(parts, std::move(*scene));
}

std::unique_ptr<CrackLengthAnalysis> CrackLengthAnalysis::create(const CrackLengthContext& parts,
                                                                 double a, CrackRegionPlan& plan,
                                                                 base::Diagnostics& diagnostics) {
  const std::optional<std::vector<mesh::CrackLine>> lines =
      growth::crack_lines(parts.model, a, diagnostics);
  return lines ? create(parts, *lines, plan, diagnostics) : nullptr;
}

CrackLengthAnalysis::CrackLengthAnalysis(const CrackLengthContext& parts, Discretisation scene)
    : parts_(parts), scene_(std::move(scene)) {}

CrackLengthAnalysis::PostProcessors::PostProcessors(const CrackLengthAnalysis& length)
    : K(length.model(), length.scene_),
      paths(length.parts_.with_paths != nullptr ? *length.parts_.with_paths : length.model(),
            length.scene_, length.bodies_, K),
      adjoints(length.scene_, length.bodies_, K),
      bars(length.model(), length.scene_, length.parts_.modes),
      sensitivities(length.model(), length.scene_, length.bodies_),
      fronts(length.model(), length.scene_, length.bodies_, K) {}

double CrackLengthAnalysis::first_crack_size() const {
  return scene_.cracked.fronts.empty() ? 0.0 : scene_.cracked.fronts.front().a;
}

CondensationRequest CrackLengthAnalysis::condensation_request() const {
  return {.model = parts_.model,
          .mesh = scene_.cracked.mesh,
          .cls = scene_.cls,
          .ties = scene_.ties,
          .rest_element = scene_.rest_element,
          .case_load = base::Matrix(),
          .threads = parts_.threads,
          .rows = scene_.reduced_contact_rows(),
          .condensing = parts_.condensing,
          .engine = parts_.engine};
}

void CrackLengthAnalysis::number_freedoms() {
  processors_.reset();
  bodies_ = partition_bodies(condensation_request());
}

bool CrackLengthAnalysis::condense(CondensationStatistics& figures) {
  processors_.reset();
  CondensationRequest asked = condensation_request();
  // Prescribed displacements are loads on what is free, before anything is condensed.
  asked.case_load = reduced_case_loads(parts_.model, scene_);
  bodies_ = condense_bodies(asked, parts_.cache, figures);
  if (figures.trouble) {
    bodies_.clear();
    return false;
  }
  processors_.emplace(*this);
  return true;
}

void CrackLengthAnalysis::add_face_contact(const std::vector<std::size_t>& lines) {
  processors_.reset(); // they stand on the bodies, and those on the scene
  bodies_.clear();
  add_crack_face_pairs(parts_.model, lines, scene_);
}

std::unique_ptr<StepSolver> CrackLengthAnalysis::make_solver() const {
  return std::make_unique<StepSolver>(parts_.model, scene_, bodies_, parts_.mounted,
                                      parts_.contact);
}

std::vector<std::size_t>
CrackLengthAnalysis::cracks_with_overlapping_faces(const base::Vector& u) const {
  return find_cracks_with_face_overlap(parts_.model, scene_, u);
}

results::LoadStepResult CrackLengthAnalysis::recover_step(const model::Step& step,
                                                          const StepState& state) const {
  return collect_step_results(parts_.model, scene_, bodies_, step, state);
}

const StressIntensityAdjoints& CrackLengthAnalysis::solve_adjoints(const StepSolver& solver) {
  return processors_->adjoints.solve_adjoint_of_last_step(solver);
}

bool CrackLengthAnalysis::begin_error_bars(const StepSolver& solver, const StepState& state,
                                           bool sensitivities, results::LoadStepResult& result,
                                           const ProcessorEndCallback& ended) {
  if (scene_.cracked.fronts.empty()) {
    return true;
  }
  if (!scene_.has_tips()) {
    return processors_->fronts.begin_bars(solver, state, sensitivities, result, ended);
  }
  const StressIntensityAdjoints& of_K = solve_adjoints(solver);
  if (!ended("ADJOINT", fmt::format("{} tips", scene_.cracked.fronts.size()))) {
    return false;
  }
  processors_->bars.add_to_tips(state, of_K, processors_->adjoints.fixed_active_set(), result);
  if (!ended("ESTIMATE", "error bars of K")) {
    return false;
  }
  if (!sensitivities) {
    return true;
  }
  processors_->sensitivities.add_to_tips(solver, state, processors_->adjoints, result);
  return ended("SENSITIVITY", "loads, fits, moduli, lengths");
}

CrackLengthAnalysis::WaitingBars CrackLengthAnalysis::waiting_bars() const {
  const FrontErrorsAndSensitivities& fronts = processors_->fronts;
  return fronts.unfinished_steps() == 0 ? WaitingBars::none
         : fronts.is_full()             ? WaitingBars::full
                                        : WaitingBars::some;
}

void CrackLengthAnalysis::finish_error_bars(const std::vector<results::LoadStepResult*>& steps) {
  processors_->fronts.finish_bars(steps);
}

bool CrackLengthAnalysis::add_error_bars_and_sensitivities(const StepSolver& solver,
                                                           const StepState& state,
                                                           bool sensitivities,
                                                           results::LoadStepResult& result,
                                                           const ProcessorEndCallback& ended) {
  const bool goes_on = begin_error_bars(solver, state, sensitivities, result, ended);
  if (waiting_bars() == WaitingBars::none) {
    return goes_on;
  }
  finish_error_bars({&result});
  return goes_on && ended("ESTIMATE", "error bars of K");
}

void CrackLengthAnalysis::add_net_errors(const std::vector<double>& energy,
                                         results::LoadStepResult& result) const {
  add_energy_errors(parts_.model, scene_, energy, result);
}

} // namespace spricka::analysis
