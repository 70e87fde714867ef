// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/frozen_step.hpp"
#include "analysis/adjoint/parameter_derivatives.hpp"

#include <memory>
#include <vector>

namespace spricka::analysis {

class VirtualAxisExtension;

/// Processor SENSITIVITY in space: derivatives of K along fronts by loads, fits, moduli and the
/// axes of ellipses. There are fewer causes than K: each is solved for, where the plane has an
/// adjoint for each K; the numbers are the same (manual, sensitivity.14).
class FrontSensitivityAnalysis {
public:
  /// All must outlive it; nothing is computed yet.
  FrontSensitivityAnalysis(const model::Model& model, const Discretisation& scene);
  ~FrontSensitivityAnalysis();

  /// Adds to the fronts of `result` what the end of a step, which was solved last, gives.
  void add_to_fronts(const FrozenContactStep& step, const KFunctionals& K,
                     results::LoadStepResult& result);

private:
  void prepare();
  void add_axes(const FrozenContactStep& step, const KFunctionals& K,
                std::vector<ParameterPartialDerivatives>& causes, results::LoadStepResult& result);
  [[nodiscard]] const std::vector<std::unique_ptr<VirtualAxisExtension>>& axis_extensions();
  void solve(const FrozenContactStep& step, const KFunctionals& K,
             const std::vector<ParameterPartialDerivatives>& causes,
             results::LoadStepResult& result) const;

  const model::Model& model_;
  const Discretisation& scene_;
  bool prepared_ = false;
  base::Matrix case_load_; ///< [dim * node, case] with the pull of supports
  base::Matrix of_loads_;  ///< [K, case] what loads add to K themselves
  std::vector<std::unique_ptr<VirtualAxisExtension>> extensions_; ///< by the axes of ellipses
  bool extended_ = false;                                         ///< they have been made
};

} // namespace spricka::analysis
