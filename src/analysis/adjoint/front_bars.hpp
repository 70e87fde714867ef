// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/frozen_step.hpp"
#include "estimate/space_enrichment.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// Processor ESTIMATE in space: error bars of K along fronts, from the solution that cubic elements
/// would have (manual, estimate.20 to 24).
class FrontErrorBars {
public:
  /// All must outlive it; nothing is computed before the first step that needs it.
  FrontErrorBars(const model::Model& model, const Discretisation& scene);

  /// Gives the fronts of a step, which was solved last, their bars, or says why they have none.
  void add_to_fronts(const FrozenContactStep& step, const FrontKFunctionals& K,
                     results::StepResult& result);

private:
  void prepare();
  [[nodiscard]] base::Vector load(const StepState& state);
  [[nodiscard]] std::string why_not(const FrozenContactStep& step) const;
  /// What cubic elements add to K. [K]; empty: a solution failed
  [[nodiscard]] std::optional<base::Vector> changes(const FrozenContactStep& step,
                                                    const FrontKFunctionals& K);
  /// The same from the residual of the modes.
  [[nodiscard]] std::optional<base::Vector> solve(const FrozenContactStep& step,
                                                  const FrontKFunctionals& K, base::Vector r) const;
  void tell(const results::FrontResult& front, results::StepResult& result);

  const model::Model& model_;
  const Discretisation& scene_;
  bool prepared_ = false;
  std::string why_not_; ///< of the whole mesh
  std::optional<estimate::SolidEnrichment> enrichment_;
  crack::SparseRows goals_;                            ///< [freedoms of modes, K]
  std::vector<std::optional<base::Vector>> case_load_; ///< [case] on the modes
  /// Steps with bars: where the same rows are closed in another and its residual is a multiple of
  /// this one's, as in load cycles, so is the rest.
  struct ReusableFrontEstimate {
    std::vector<bool> mounted, closed;
    base::Vector residual, eta;
  };
  std::vector<ReusableFrontEstimate> known_;
  std::vector<results::Note> reported_;
};

} // namespace spricka::analysis
