// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/front_bars.hpp"
#include "analysis/adjoint/front_sensitivities.hpp"

#include <optional>

namespace spricka::analysis {

/// Bars and derivatives of K along fronts in space at the ends of the steps of one crack length.
class FrontAnalysis {
public:
  /// All must outlive it; nothing is computed before the first step.
  FrontAnalysis(const model::Model& model, const Scene& scene, const std::vector<BodyNet>& bodies);

  /// Of a step that `solver` solved last.
  void add(const StepSolver& solver, const StepState& state, results::StepResult& result);

private:
  const model::Model& model_;
  const Scene& scene_;
  const std::vector<BodyNet>& bodies_;
  std::optional<FrontFunctionals> functionals_;
  FrontBars bars_;
  FrontSensitivities sensitivities_;
};

} // namespace spricka::analysis
