// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/length.hpp"

#include "analysis/recover/net_errors.hpp"
#include "analysis/recover/recover_step.hpp"
#include "analysis/scene/scene_loads.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "growth/crack_lines.hpp"

#include <utility>

namespace spricka::analysis {

std::unique_ptr<Length> Length::make(const LengthParts& parts,
                                     const std::vector<mesh::CrackLine>& lines,
                                     const RegionPlan& plan, base::Diagnostics& diagnostics) {
  std::optional<Scene> scene = make_scene(parts.model, lines, plan, diagnostics);
  return scene ? std::make_unique<Length>(parts, std::move(*scene)) : nullptr;
}

std::unique_ptr<Length> Length::make(const LengthParts& parts, double a, const RegionPlan& plan,
                                     base::Diagnostics& diagnostics) {
  const std::optional<std::vector<mesh::CrackLine>> lines =
      growth::crack_lines(parts.model, a, diagnostics);
  return lines ? make(parts, *lines, plan, diagnostics) : nullptr;
}

Length::Length(const LengthParts& parts, Scene scene) : parts_(parts), scene_(std::move(scene)) {}

Length::Processors::Processors(const Length& length)
    : paths(length.parts_.with_paths != nullptr ? *length.parts_.with_paths : length.model(),
            length.scene_, length.bodies_),
      adjoints(length.model(), length.scene_, length.bodies_),
      bars(length.model(), length.scene_, length.parts_.modes),
      sensitivities(length.model(), length.scene_, length.bodies_),
      fronts(length.model(), length.scene_, length.bodies_) {}

double Length::size_of_first() const {
  return !scene_.cracked.fronts.empty() ? scene_.cracked.fronts.front().a
         : !scene_.fronts.empty()       ? scene_.fronts.front().front.a
                                        : 0.0;
}

CondenseRequest Length::request() const {
  return {.model = parts_.model,
          .mesh = scene_.cracked.mesh,
          .cls = scene_.cls,
          .ties = scene_.ties,
          .rest_element = scene_.rest_element,
          .case_load = base::Matrix(),
          .threads = parts_.threads,
          .rows = scene_.acting_rows(),
          .condensing = parts_.condensing};
}

void Length::prepare() {
  processors_.reset();
  bodies_ = prepare_bodies(request());
}

bool Length::condense(CondenseLog& figures) {
  processors_.reset();
  CondenseRequest asked = request();
  // Prescribed displacements are loads on what is free, before anything is condensed.
  asked.case_load = loads_with_supports(parts_.model, scene_);
  bodies_ = condense_bodies(asked, parts_.cache, figures);
  if (figures.trouble) {
    bodies_.clear();
    return false;
  }
  processors_.emplace(*this);
  return true;
}

void Length::close_faces(const std::vector<std::size_t>& lines) {
  processors_.reset(); // they stand on the bodies, and those on the scene
  bodies_.clear();
  add_crack_face_pairs(parts_.model, lines, scene_);
}

std::unique_ptr<StepSolver> Length::start() const {
  return std::make_unique<StepSolver>(parts_.model, scene_, bodies_, parts_.mounted,
                                      parts_.contact);
}

std::vector<std::size_t> Length::touching(const base::Vector& u) const {
  return touching_lines(parts_.model, scene_, u);
}

results::StepResult Length::recover(const model::Step& step, const StepState& state) const {
  return gather_step(parts_.model, scene_, bodies_, step, state);
}

const std::vector<estimate::IntensityAdjoint>& Length::solve_adjoints(const StepSolver& solver) {
  processors_->of_K = &processors_->adjoints.of_last_step(solver);
  return *processors_->of_K;
}

void Length::add_bars(const StepState& state, results::StepResult& result) {
  processors_->bars.add(state, *processors_->of_K, processors_->adjoints.held(), result);
}

void Length::add_sensitivities(const StepSolver& solver, const StepState& state,
                               results::StepResult& result) {
  processors_->sensitivities.add(solver, state, processors_->adjoints, result);
}

void Length::add_of_fronts(const StepSolver& solver, const StepState& state,
                           results::StepResult& result) {
  processors_->fronts.add(solver, state, result);
}

void Length::add_net_errors(const StepState& state, results::StepResult& result) const {
  add_errors(parts_.model, scene_, state.energy, result);
}

} // namespace spricka::analysis
