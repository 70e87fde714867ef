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
  void add_to_fronts(const FrozenContactStep& step, const KFunctionals& K,
                     results::LoadStepResult& result);

private:
  void prepare();
  /// Loads of a step and pressures of its contacts on the modes.
  [[nodiscard]] base::Vector load(const StepState& state);
  /// What cubic elements add to K. [K]; empty: a solution failed
  [[nodiscard]] std::optional<base::Vector> changes(const FrozenContactStep& step,
                                                    const KFunctionals& K);
  /// The modes of a solution, with the nodes eliminated, and what they add to K. [K]
  struct ModeSolution {
    base::Vector modes, eta;
  };
  /// What displacements of modes do to the modes' own forces and to K; empty: a solution failed.
  struct ModeResponse {
    base::Vector force, K;
  };
  [[nodiscard]] std::optional<ModeResponse>
  respond(const FrozenContactStep& step, const KFunctionals& K, const base::Vector& modes) const;
  /// The solution for loads r on the modes, from `start` on; empty: a solution failed.
  [[nodiscard]] std::optional<ModeSolution> solve(const FrozenContactStep& step,
                                                  const KFunctionals& K, base::Vector r,
                                                  base::Vector start) const;
  void estimate_bars(const StepState& state, const base::Vector& eta,
                     const ContactEdgeKChange& edges, std::size_t f, std::size_t first_point,
                     results::FrontResult& front, results::LoadStepResult& result) const;

  std::optional<estimate::SolidEnrichment> enrichment_;
  crack::SparseLinearFunctionals goals_; ///< [freedoms of modes, K]
  /// Steps with bars: where the residual of another is a multiple of this one's, as in load cycles,
  /// and the same rows are closed, so is the rest; with other rows the solution is near.
  struct ReusableFrontEstimate {
    std::vector<bool> mounted, closed;
    base::Vector residual;
    ModeSolution solution;
  };
  std::vector<ReusableFrontEstimate> known_;
};

} // namespace spricka::analysis
