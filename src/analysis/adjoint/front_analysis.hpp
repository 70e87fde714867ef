// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/front_bars.hpp"
#include "analysis/adjoint/front_sensitivities.hpp"

namespace spricka::analysis {

/// Bars and derivatives of K along fronts in space at the ends of the steps of one crack length.
class FrontErrorsAndSensitivities {
public:
  /// All must outlive it; nothing is computed before the first step.
  FrontErrorsAndSensitivities(const model::Model& model, const Discretisation& scene,
                              const std::vector<SubstructuredBody>& bodies, const KFunctionals& K);

  /// Of a step that `solver` solved last; without `sensitivities` bars alone.
  void add_to_fronts(const StepSolver& solver, const StepState& state, bool sensitivities,
                     results::LoadStepResult& result);

private:
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  const KFunctionals& K_;
  FrontErrorBars bars_;
  FrontSensitivityAnalysis sensitivities_;
};

} // namespace spricka::analysis
