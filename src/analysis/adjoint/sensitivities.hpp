// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/adjoints.hpp"
#include "analysis/adjoint/contact_rates.hpp"
#include "analysis/adjoint/parameter_derivatives.hpp"
#include "analysis/adjoint/tip_advance.hpp"
#include "results/results.hpp"

#include <memory>
#include <vector>

/// Processor SENSITIVITY: derivatives of K by loads, fits, moduli and crack lengths, all from the
/// adjoint of K.
namespace spricka::analysis {

class TipSensitivityAnalysis {
public:
  /// All must outlive it; nothing is computed yet.
  TipSensitivityAnalysis(const model::Model& model, const Discretisation& scene,
                         const std::vector<SubstructuredBody>& bodies);

  /// Adds to the fronts of `result`, each a tip, what the end of the step that `solver` solved last
  /// gives.
  void add_to_tips(const StepSolver& solver, const StepState& state,
                   IntensityAdjointSolver& adjoints, results::LoadStepResult& result);

private:
  void prepare();
  void add_lengths(const StepState& state, const std::vector<bool>& closed,
                   std::vector<ParameterPartialDerivatives>& causes,
                   results::LoadStepResult& result) const;
  /// Of the first causes, loads and fits only.
  LoadAndGapRates rates(const StepSolver& solver,
                        const std::vector<ParameterPartialDerivatives>& causes, std::size_t count);
  LoadAndGapRates all_rates(const StepSolver& solver,
                            const std::vector<ParameterPartialDerivatives>& causes);
  void one_sided(const StepSolver& solver, const FrozenContact& contact,
                 IntensityAdjointSolver& adjoints,
                 const std::vector<ParameterPartialDerivatives>& causes,
                 results::LoadStepResult& result);

  const model::Model& model_;
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  base::Matrix case_load_;                   ///< [dim * node, case] with the pull of supports
  std::vector<base::Matrix> case_externals_; ///< [body of the contact system] condensed
  contact::ResponseWithoutContact of_cases_;
  base::Matrix of_loads_; ///< [K, case] what loads add to K themselves
  std::vector<std::unique_ptr<VirtualTipExtension>> advances_; ///< [tip]
};

} // namespace spricka::analysis
