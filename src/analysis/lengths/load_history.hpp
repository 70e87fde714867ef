// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/recover/load_paths.hpp"
#include "analysis/steps/carried_state.hpp"
#include "analysis/steps/history_program.hpp"
#include "analysis/steps/step_solver.hpp"
#include "base/outcome.hpp"

#include <string>
#include <utility>
#include <vector>

/// Loads one after another as increments with friction, until K of a pass repeats itself.
namespace spricka::analysis {

/// K of all tips, along fronts the smooth one, increment by increment: [crack::KLayout].
using KSequence = std::vector<base::Vector>;

struct LoadPassResult {
  KSequence way;   ///< from place to place, without what `cycles` has
  KSequence marks; ///< K at each mark of the program, when it came by last
  std::vector<std::pair<KSequence, double>> cycles; ///< closed cycles, with how often
};

struct LoadHistoryKResult {
  LoadPassResult first, last;
  std::size_t grow_at = 0, smallest = 0; ///< marks, as GrowthLoadHistory
  int passes = 0;
  int increments = 0;  ///< solved in all
  double change = 0.0; ///< of K at marks from the last pass but one to the last, over the largest K
  double mismatch = 0.0; ///< K against that of the recovered displacements, over the largest K
  std::string none;      ///< why nothing was followed; empty: it was
};

/// K repeats itself when nothing changes by more than this part of the largest K; so many passes,
/// and so many cycles of one line of blocks, are tried.
inline constexpr double repeats_to = 1e-6;
inline constexpr int most_passes = 20;

class CyclicLoadHistorySolver {
public:
  CyclicLoadHistorySolver(const model::Model& model, const Discretisation& scene,
                          const std::vector<SubstructuredBody>& bodies, LoadPathSolver& paths)
      : model_(model), scene_(scene), bodies_(bodies), paths_(paths) {}

  /// Keeps what the history needs of this step; called behind each.
  void store_step_end_state(std::size_t step, const StepSolver& solver,
                            const results::LoadStepResult& result);

  /// Follows the loads from their first step on, or from what `carried` holds; where the crack
  /// grows is in `carried` after it. The solver is left as it was. False: an increment has no
  /// answer.
  bool solve_load_history(StepSolver& solver, InheritedContactState& carried,
                          LoadHistoryKResult& out, base::OptionalFailure& trouble);

private:
  bool go(const LoadHistoryPoint& place, KSequence& way, base::OptionalFailure& trouble);
  bool begin(const GrowthLoadHistory& program, const InheritedContactState& carried,
             KSequence& before, base::OptionalFailure& trouble);
  bool pass(const GrowthLoadHistory& program, LoadPassResult& out, base::OptionalFailure& trouble);
  bool leg(const GrowthLoadHistory& program, const RepeatedLoadSegment& leg, LoadPassResult& out,
           base::OptionalFailure& trouble);
  bool compare_with_recovered(LoadHistoryKResult& out, base::OptionalFailure& trouble);
  [[nodiscard]] double change(const KSequence& a, const KSequence& b) const;

  const model::Model& model_;
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  LoadPathSolver& paths_;
  std::vector<StepActionFactors> of_step_;
  std::vector<StepSolverState> places_; ///< [step]
  KSequence of_steps_;                  ///< [step] K of its result
  std::vector<int> parts_;              ///< [step] increments it was cut into
  // while it is followed
  StepSolver* solver_ = nullptr;
  contact::ContactSystem::IncrementSolution solution_; ///< of the last increment
  base::Vector here_;                                  ///< K there
  double t_ = 0.0, per_unit_ = 1.0;
  double largest_ = 0.0;   ///< K so far
  double unsettled_ = 0.0; ///< of cycles of blocks in the last pass
  int increments_ = 0;
  StepSolverState at_growth_;
};

} // namespace spricka::analysis
