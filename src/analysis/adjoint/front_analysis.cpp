// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/front_analysis.hpp"

namespace spricka::analysis {

FrontErrorsAndSensitivities::FrontErrorsAndSensitivities(
    const model::Model& model, const Discretisation& scene,
    const std::vector<SubstructuredBody>& bodies, const KFunctionals& K)
    : scene_(scene), bodies_(bodies), K_(K), bars_(model, scene), sensitivities_(model, scene) {}

void FrontErrorsAndSensitivities::add_to_fronts(const StepSolver& solver, const StepState& state,
                                                bool sensitivities,
                                                results::LoadStepResult& result) {
  const ClosedContactRows rows = closed_contact_rows(solver, scene_);
  const FrozenContactSystem system(solver, scene_, bodies_,
                                   rows.rubs ? std::vector<bool>(rows.closed.size(), false)
                                             : rows.closed);
  const FrozenContactStep step{solver, state, rows, system};
  bars_.add_to_fronts(step, K_, result);
  if (sensitivities) {
    sensitivities_.add_to_fronts(step, K_, result);
  }
}

} // namespace spricka::analysis
