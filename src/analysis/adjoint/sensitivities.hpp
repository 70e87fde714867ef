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
struct KCause {
  results::Sensitivity is; ///< without its derivatives
  base::Vector load;       ///< [dim * node] by its value; empty: none
  base::Vector gap;        ///< [table row] by its value; empty: none
  base::Matrix direct;     ///< [2, tip] dK by its value with u kept
};

class Sensitivities {
public:
  /// All must outlive it; nothing is computed yet.
  Sensitivities(const model::Model& model, const Scene& scene, const std::vector<BodyNet>& bodies);

  /// Adds to the tips of `result` what the end of the step that `solver` solved last gives.
  void add(const StepSolver& solver, const StepState& state, Adjoints& adjoints,
           results::StepResult& result);

private:
  void prepare();
  void add_loads(const StepSolver& solver, const std::vector<estimate::IntensityAdjoint>& adjoints,
                 std::vector<KCause>& causes) const;
  void add_fits(const StepSolver& solver, std::vector<KCause>& causes) const;
  void add_moduli(const StepState& state, const std::vector<estimate::IntensityAdjoint>& adjoints,
                  std::vector<KCause>& causes) const;
  void add_lengths(const StepState& state, const std::vector<bool>& closed,
                   results::StepResult& result, std::vector<KCause>& causes) const;
  [[nodiscard]] KCause cause(results::Cause kind, std::string name, double value) const;
  /// Of the first causes, loads and fits only.
  Rates rates(const StepSolver& solver, const std::vector<KCause>& causes, std::size_t count);
  Rates all_rates(const StepSolver& solver, const std::vector<KCause>& causes);
  void one_sided(const StepSolver& solver, const FrozenContact& contact, Adjoints& adjoints,
                 std::vector<KCause>& causes, results::StepResult& result);

  const model::Model& model_;
  const Scene& scene_;
  const std::vector<BodyNet>& bodies_;
  base::Matrix case_load_;                   ///< [dim * node, case] with the pull of supports
  std::vector<base::Matrix> case_externals_; ///< [body of the contact system] condensed
  contact::UnconstrainedResponse of_cases_;
  std::vector<base::Matrix> of_loads_;  ///< [tip][2, case]
  std::vector<base::Matrix> of_moduli_; ///< [tip][2, case] E d/dE of those, E of the tip's material
  std::vector<std::unique_ptr<TipAdvance>> advances_; ///< [tip]
};

} // namespace spricka::analysis
