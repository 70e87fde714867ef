// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/adjoints.hpp"
#include "analysis/adjoint/error_bars_base.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "contact/held_contact.hpp"
#include "estimate/contact_load.hpp"
#include "estimate/goal_error.hpp"
#include "results/results.hpp"

#include <optional>
#include <vector>

/// Processor ESTIMATE in the plane: error bars of K from its adjoints.
namespace spricka::analysis {

class TipErrorBars : private ErrorBarsBase {
public:
  /// All must outlive it; nothing is computed before the first step that needs it. `memory`: what
  /// one length leaves for the next, or null.
  TipErrorBars(const model::Model& model, const Discretisation& scene,
               estimate::ModeMatrixCache* memory = nullptr);

  /// Gives the fronts of a step, each a tip, which was solved last, their bars, or says why they
  /// have none. `held`: the contact that the adjoints keep, null where there is none.
  void add_to_tips(const StepState& state, const StressIntensityAdjoints& adjoint,
                   const contact::FixedActiveSet* held, results::LoadStepResult& step);

private:
  void prepare();
  [[nodiscard]] estimate::ModeFreedomMap modes(const StepState& state) const;
  void add_pressures(const StepState& state, const StressIntensityAdjoints& adjoint,
                     base::Vector& f, base::Matrix& g) const;
  [[nodiscard]] bool coarse_contact(const StepState& state, const mesh::CrackFront& front) const;
  struct StepErrors;
  [[nodiscard]] StepErrors step_errors(const StepState& state,
                                       const StressIntensityAdjoints& adjoint,
                                       const contact::FixedActiveSet* held);
  void estimate_bars(const StepState& state, const StepErrors& errors, std::size_t t,
                     results::FrontResult& front, results::LoadStepResult& step);
  void tell_of_cancelling(const results::FrontResult& front, results::LoadStepResult& step);
  void tell_of_meshes(const StepState& state, results::LoadStepResult& step);

  estimate::ModeMatrixCache* memory_;
  std::optional<estimate::CubicEnrichment> enrichment_;
  estimate::ModeSupports supports_;
  std::vector<std::vector<estimate::ContactEdge>> contact_edges_;      ///< [contact]
  std::vector<std::vector<estimate::ContactModeWeight>> mode_weights_; ///< [contact]
  base::Matrix goals_; ///< [freedoms of modes, 2 tips]
};

} // namespace spricka::analysis
