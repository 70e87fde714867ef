// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/front_analysis.hpp"

#include "analysis/scene/front_functionals.hpp"

namespace spricka::analysis {

FrontErrorsAndSensitivities::FrontErrorsAndSensitivities(
    const model::Model& model, const Discretisation& scene,
    const std::vector<SubstructuredBody>& bodies)
    : model_(model), scene_(scene), bodies_(bodies), bars_(model, scene),
      sensitivities_(model, scene) {}

void FrontErrorsAndSensitivities::add_to_fronts(const StepSolver& solver, const StepState& state,
                                                bool sensitivities,
                                                results::LoadStepResult& result) {
  if (!functionals_) {
    functionals_.emplace(FrontKFunctionals{displacement_K_functionals(model_, scene_),
                                           contact_force_K_functionals(model_, scene_)});
  }
  const ClosedContactRows rows = closed_contact_rows(solver, scene_);
  const FrozenContactSystem system(solver, scene_, bodies_,
                                   rows.rubs ? std::vector<bool>(rows.closed.size(), false)
                                             : rows.closed);
  const FrozenContactStep step{solver, state, rows, system};
  bars_.add_to_fronts(step, *functionals_, result);
  if (sensitivities) {
    sensitivities_.add_to_fronts(step, *functionals_, result);
  }
}

} // namespace spricka::analysis
