// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/adjoints.hpp"
#include "analysis/adjoint/contact_rates.hpp"
#include "analysis/adjoint/tip_advance.hpp"
#include "results/results.hpp"

#include <memory>
#include <vector>

/// Processor SENSITIVITY: derivatives of K by loads, fits, moduli and crack lengths, all from the
/// adjoint of K.
namespace spricka::analysis {

/// One thing that K depends on: loads, gaps and a part of K that it changes by itself.
struct TipParameterDerivative {
  results::Sensitivity is; ///< without its derivatives
  base::Vector load;       ///< [dim * node] by its value; empty: none
  base::Vector gap;        ///< [table row] by its value; empty: none
  base::Matrix direct;     ///< [2, tip] dK by its value with u kept
};

class TipSensitivityAnalysis {
public:
  /// All must outlive it; nothing is computed yet.
  TipSensitivityAnalysis(const model::Model& model, const Discretisation& scene,
                         const std::vector<SubstructuredBody>& bodies);

  /// Adds to the tips of `result` what the end of the step that `solver` solved last gives.
  void add_to_tips(const StepSolver& solver, const StepState& state, KAdjoints& adjoints,
                   results::StepResult& result);

private:
  void prepare();
  void add_loads(const StepSolver& solver, const std::vector<estimate::IntensityAdjoint>& adjoints,
                 std::vector<TipParameterDerivative>& causes) const;
  void add_fits(const StepSolver& solver, std::vector<TipParameterDerivative>& causes) const;
  void add_moduli(const StepState& state, const std::vector<estimate::IntensityAdjoint>& adjoints,
                  std::vector<TipParameterDerivative>& causes) const;
  void add_lengths(const StepState& state, const std::vector<bool>& closed,
                   results::StepResult& result, std::vector<TipParameterDerivative>& causes) const;
  [[nodiscard]] TipParameterDerivative cause(results::SensitivityParameter kind, std::string name,
                                             double value) const;
  /// Of the first causes, loads and fits only.
  LoadAndGapRates rates(const StepSolver& solver, const std::vector<TipParameterDerivative>& causes,
                        std::size_t count);
  LoadAndGapRates all_rates(const StepSolver& solver,
                            const std::vector<TipParameterDerivative>& causes);
  void one_sided(const StepSolver& solver, const FrozenContact& contact, KAdjoints& adjoints,
                 std::vector<TipParameterDerivative>& causes, results::StepResult& result);

  const model::Model& model_;
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  base::Matrix case_load_;                   ///< [dim * node, case] with the pull of supports
  std::vector<base::Matrix> case_externals_; ///< [body of the contact system] condensed
  contact::UnconstrainedResponse of_cases_;
  std::vector<base::Matrix> of_loads_;  ///< [tip][2, case]
  std::vector<base::Matrix> of_moduli_; ///< [tip][2, case] E d/dE of those, E of the tip's material
  std::vector<std::unique_ptr<VirtualTipExtension>> advances_; ///< [tip]
};

} // namespace spricka::analysis
