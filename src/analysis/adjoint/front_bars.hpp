// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/coarse_surface_effect.hpp"
#include "analysis/adjoint/edge_changes.hpp"
#include "analysis/adjoint/error_bars_base.hpp"
#include "analysis/adjoint/frozen_step.hpp"
#include "analysis/adjoint/mode_solver.hpp"
#include "results/results.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// What the bars of a step hang on, but for the solution that cubic elements would have.
struct UnfinishedFrontBars {
  std::string why_not; ///< empty: there can be bars
  ModeLoad load;
  ContactEdgeKChange edges;
  std::vector<CoarseNeighbourEffect> coarse; ///< [front]
};

/// Processor ESTIMATE in space: error bars of K along fronts, from the solution that cubic elements
/// would have (manual, estimate.20 to 24).
class FrontErrorBars : private ErrorBarsBase {
public:
  /// All must outlive it; nothing is computed before the first step that needs it.
  FrontErrorBars(const model::Model& model, const Discretisation& scene);

  /// What the bars of a step, which was solved last, hang on; `system` is that of the step.
  UnfinishedFrontBars begin(const FrozenContactStep& step,
                            std::shared_ptr<const FrozenContactSystem> system,
                            const KFunctionals& K);
  /// Gives the fronts of steps [step] their bars, or says why they have none.
  void finish(const std::vector<UnfinishedFrontBars>& steps, const KFunctionals& K,
              const std::vector<results::LoadStepResult*>& results);

private:
  void prepare(const KFunctionals& K);
  /// Loads of a step and pressures of its contacts on the modes.
  [[nodiscard]] base::Vector load(const StepState& state);
  void estimate_bars(const UnfinishedFrontBars& step, const base::Vector& eta, std::size_t f,
                     std::size_t first_point, results::FrontResult& front,
                     results::LoadStepResult& result) const;

  std::unique_ptr<CubicModeSolver> modes_;
};

} // namespace spricka::analysis
