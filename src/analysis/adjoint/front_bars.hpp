// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/edge_changes.hpp"
#include "analysis/adjoint/error_bars_base.hpp"
#include "analysis/adjoint/frozen_step.hpp"
#include "estimate/space_enrichment.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// Processor ESTIMATE in space: error bars of K along fronts, from the solution that cubic elements
/// would have (manual, estimate.20 to 24).
class FrontErrorBars : private ErrorBarsBase {
public:
  /// All must outlive it; nothing is computed before the first step that needs it.
  FrontErrorBars(const model::Model& model, const Discretisation& scene);

  /// Gives the fronts of a step, which was solved last, their bars, or says why they have none.
  void add_to_fronts(const FrozenContactStep& step, const FrontKFunctionals& K,
                     results::LoadStepResult& result);

private:
  void prepare();
  /// Loads of a step and pressures of its contacts on the modes.
  [[nodiscard]] base::Vector load(const StepState& state);
  /// What cubic elements add to K. [K]; empty: a solution failed
  [[nodiscard]] std::optional<base::Vector> changes(const FrozenContactStep& step,
                                                    const FrontKFunctionals& K);
  /// The same from the residual of the modes.
  [[nodiscard]] std::optional<base::Vector> solve(const FrozenContactStep& step,
                                                  const FrontKFunctionals& K, base::Vector r) const;
  void estimate_bars(const StepState& state, const base::Vector& eta,
                     const ContactEdgeKChange& edges, std::size_t f, std::size_t first_point,
                     results::FrontResult& front, results::LoadStepResult& result) const;

  std::optional<estimate::SolidEnrichment> enrichment_;
  crack::SparseLinearFunctionals goals_; ///< [freedoms of modes, K]
  /// Steps with bars: where the same rows are closed in another and its residual is a multiple of
  /// this one's, as in load cycles, so is the rest.
  struct ReusableFrontEstimate {
    std::vector<bool> mounted, closed;
    base::Vector residual, eta;
  };
  std::vector<ReusableFrontEstimate> known_;
};

} // namespace spricka::analysis
