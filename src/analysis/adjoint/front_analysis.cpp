// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/front_analysis.hpp"

namespace spricka::analysis {

FrontAnalysis::FrontAnalysis(const model::Model& model, const Scene& scene,
                             const std::vector<BodyNet>& bodies)
    : model_(model), scene_(scene), bodies_(bodies), bars_(model, scene),
      sensitivities_(model, scene) {}

void FrontAnalysis::add(const StepSolver& solver, const StepState& state,
                        results::StepResult& result) {
  if (!functionals_) {
    functionals_.emplace(
        FrontFunctionals{front_rows(model_, scene_), front_rows_of_forces(model_, scene_)});
  }
  const ClosedRows rows = closed_rows(solver, scene_);
  const FrozenSystem system(solver, scene_, bodies_,
                            rows.rubs ? std::vector<bool>(rows.closed.size(), false) : rows.closed);
  const FrozenStep step{solver, state, rows, system};
  bars_.add(step, *functionals_, result);
  sensitivities_.add(step, *functionals_, result);
}

} // namespace spricka::analysis
