// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/front_bars.hpp"
#include "analysis/adjoint/front_sensitivities.hpp"

#include <functional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// Told as a processor ends, by its name and what it did; false: go no further.
using ProcessorEndCallback =
    std::function<bool(const std::string& processor, const std::string& did)>;

/// Bars and derivatives of K along fronts in space at the ends of the steps of one crack length.
/// Bars of several steps together cost less: they wait until they are finished.
class FrontErrorsAndSensitivities {
public:
  /// All must outlive it; nothing is computed before the first step.
  FrontErrorsAndSensitivities(const model::Model& model, const Discretisation& scene,
                              const std::vector<SubstructuredBody>& bodies, const KFunctionals& K);

  /// ESTIMATE and SENSITIVITY: begins the bars of a step that `solver` solved last and, where they
  /// are asked for, adds its derivatives. False: `ended` went no further.
  bool begin_bars(const StepSolver& solver, const StepState& state, bool sensitivities,
                  results::LoadStepResult& result, const ProcessorEndCallback& ended);
  /// Steps whose bars have been begun.
  [[nodiscard]] std::size_t unfinished_steps() const { return unfinished_.size(); }
  /// Whether no more steps should wait: what is kept of them grows.
  [[nodiscard]] bool is_full() const;
  /// Gives the steps whose bars have been begun, in this order, their bars.
  void finish_bars(const std::vector<results::LoadStepResult*>& steps);

private:
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  const KFunctionals& K_;
  FrontErrorBars bars_;
  FrontSensitivityAnalysis sensitivities_;
  std::vector<UnfinishedFrontBars> unfinished_;
};

} // namespace spricka::analysis
