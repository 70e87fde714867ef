// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/length.hpp"
#include "base/outcome.hpp"
#include "model/model.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace spricka::program {

/// What a bench is made of; all must outlive it.
struct InteractiveSolverInputs {
  const model::Model& model; ///< its cracks have the lengths wanted
  analysis::CondensationCache& cache;
  analysis::ContactDataForNextLength& contact; ///< compliances that lengths share
  analysis::MountOffsetMemory* memory =
      nullptr;               ///< of what was mounted at the first length; null: none is kept
  bool fills_memory = false; ///< this is the first length
  int threads = 1;
  base::EquationEngine engine = base::EquationEngine::automatic;
  std::function<bool()> stopped; ///< asked between the stages of a computation; may be empty
};

/// Where steps have led, all of them or up to the one in which faces met.
struct ReachedShellState {
  std::unique_ptr<analysis::StepSolver> solver;
  std::optional<analysis::StepState> state;
  std::vector<std::size_t> touching; ///< lines to close before this is an answer
};

/// One set of crack lengths of a deck, condensed and ready to be asked: loads and fits change the
/// contact solution only. Nothing in it prints or reads. An operation that fails leaves the state
/// as it was, or the bench not is_ready().
class InteractiveSolver {
public:
  /// Cuts the cracks and condenses the nets. Mistakes that only show here go to `diagnostics`.
  static std::unique_ptr<InteractiveSolver> make(const InteractiveSolverInputs& parts,
                                                 analysis::CrackRegionPlan& plan,
                                                 base::Diagnostics& diagnostics,
                                                 base::OptionalFailure& trouble);
  InteractiveSolver(const InteractiveSolver&) = delete;
  InteractiveSolver& operator=(const InteractiveSolver&) = delete;

  /// From the unloaded state through all these steps; their end is the present state.
  base::OptionalFailure solve_from_unloaded(const std::vector<model::Step>& way);
  /// On from the present state by one more step; `way` leads to the same end.
  base::OptionalFailure solve_further_step(const model::Step& step,
                                           const std::vector<model::Step>& way);

  /// One increment with the mesh and the present state as its step NOW; then what was asked of the
  /// deck's own steps, and the load paths that were followed.
  [[nodiscard]] const results::RunResult& run_results() const { return run_; }
  [[nodiscard]] const results::LoadStepResult& current_result() const {
    return run_.increments.front().steps[0];
  }
  /// The model as it is shown: its only step with results is NOW.
  [[nodiscard]] const model::Model& displayed_model() const { return shown_; }
  [[nodiscard]] const analysis::StepActionFactors& action_factors() const {
    return solver_->factors();
  }
  /// False when an operation failed so late that nothing is left to ask: make a new bench.
  [[nodiscard]] bool is_ready() const { return solver_ != nullptr; }
  /// Figures of the last condensation.
  [[nodiscard]] const analysis::CondensationStatistics& condensation_figures() const {
    return condensed_;
  }

  /// Error bars and sensitivities of the present state, once.
  base::OptionalFailure estimate_accuracy();
  /// Estimated errors of the nets in the energy norm, once.
  void estimate_net_errors();
  /// The end of a step of the deck becomes a further step of run_results().
  base::OptionalFailure add_deck_step_result(std::size_t step);
  /// The straight path between two steps that follow `way`, t from 0 to `beyond`; it replaces paths
  /// of that name in run_results(). Without friction only.
  base::OptionalFailure follow_load_path(const model::LoadPathDefinition& card,
                                         const std::vector<model::Step>& from,
                                         const std::vector<model::Step>& to);

private:
  explicit InteractiveSolver(const InteractiveSolverInputs& parts);
  base::OptionalFailure prepare();
  /// Lines whose faces would overlap become pairs, and everything that stood on it is made anew.
  base::OptionalFailure close(const std::vector<std::size_t>& lines);
  /// Solves the steps from the unloaded state, faces closed where they meet.
  base::OptionalFailure reach(const std::vector<model::Step>& way, ReachedShellState& reached);
  void take(ReachedShellState reached, const std::vector<model::Step>& way);
  [[nodiscard]] results::LoadStepResult gather(const ReachedShellState& reached,
                                               const std::string& name) const;
  base::OptionalFailure correct_K(const ReachedShellState& reached, results::LoadStepResult& found);
  [[nodiscard]] bool stopped() const { return parts_.stopped && parts_.stopped(); }

  InteractiveSolverInputs parts_;
  model::Model shown_;
  std::unique_ptr<analysis::CrackLengthAnalysis> length_;
  int closings_ = 0; ///< times that faces were closed
  analysis::CondensationStatistics condensed_;
  std::unique_ptr<analysis::StepSolver> fresh_; ///< at the unloaded state
  std::unique_ptr<analysis::StepSolver> solver_;
  std::optional<analysis::StepState> state_;
  std::vector<model::Step> way_;
  bool estimated_ = false;
  results::RunResult run_;
};

} // namespace spricka::program
