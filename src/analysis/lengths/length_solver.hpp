// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/length.hpp"
#include "analysis/lengths/load_history.hpp"
#include "analysis/lengths/log_writer.hpp"
#include "analysis/lengths/pictured_steps.hpp"
#include "analysis/lengths/solve_options.hpp"
#include "analysis/scene/free_faces.hpp"
#include "analysis/steps/carried_state.hpp"
#include "analysis/steps/contact_memory.hpp"
#include "analysis/steps/mount_memory.hpp"
#include "analysis/steps/step_solver.hpp"
#include "base/diagnostics.hpp"
#include "base/outcome.hpp"
#include "estimate/enrichment.hpp"
#include "growth/crack_kinematics.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/model.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// One state of the cracks to be solved.
struct CrackStateRequest {
  growth::CrackGeometry cracks; ///< in space none: those of the deck
  double a = 0.0;               ///< for the record; 0: that of the first tip
  PicturedSteps pictured;       ///< at their ends stresses are recovered
  bool bars = true;             ///< error bars of K, by which it is corrected
  bool sensitivities = true;    ///< with bars: derivatives of K
};

/// Solves all steps for one state of the cracks after another; what one leaves for the next (nets
/// that did not change, what was mounted) stays in its members.
class CrackStateSolver {
public:
  CrackStateSolver(const model::Model& model, const SolveOptions& options,
                   std::vector<results::LogLine>& log, base::Diagnostics& diagnostics,
                   base::OptionalFailure& trouble)
      : model_(model), options_(options), log_(log), diagnostics_(diagnostics), trouble_(trouble) {}

  /// Empty: a mistake of the deck (in the diagnostics) or a model that cannot be solved (trouble).
  std::optional<results::CrackLengthResult> solve(const CrackStateRequest& request,
                                                  CrackRegionPlan& plan);

  /// Of the state that was solved last.
  [[nodiscard]] const std::vector<mesh::CrackFront>& crack_fronts() const { return fronts_; }

  /// Whether some body of that state was condensed in parts.
  [[nodiscard]] bool bodies_are_divided() const { return divided_; }

  /// By front in space, with SFLOW: force and moments of the section before it at the growth's
  /// largest load, over their plastic limit.
  [[nodiscard]] const std::vector<double>& plastic_load_ratios() const { return plastic_; }

  /// K of that state with faces that may overlap, where they close and the law wants it.
  [[nodiscard]] const std::optional<OverlappingFaceResults>& overlap_results() const {
    return free_;
  }
  /// K of the loads of the growth, one after another; empty without friction.
  [[nodiscard]] const std::optional<LoadHistoryKResult>& load_history() const { return followed_; }
  /// The state that was solved last counts: what slipped there is carried on from.
  void accept_solved_state() { carried_ = next_carried_; }

  /// What the next state takes over from the last, for a restart file, and back from there.
  void save_state(results::NamedArrays& arrays) const {
    mounted_.save_state(arrays);
    carried_.save_state(arrays);
    contact_.save_state(arrays);
  }
  /// Back from a restart file: mounting offsets, contact state and closed rows of the last state,
  /// so that the next one is no first one.
  void restore_state(const results::NamedArrays& arrays) {
    mounted_ = MountOffsetMemory::restore_state(arrays);
    carried_ = InheritedContactState::restore_state(arrays);
    contact_ = ContactDataForNextLength::restore_state(arrays, model_.steps.size());
    first_ = false;
  }

private:
  [[nodiscard]] CrackLengthContext parts();
  /// `news`: of nets that one engine has given up and another solved, for the reader.
  bool condense(CrackLengthAnalysis& length, LogWriter& log, std::vector<std::string>& news);
  void close_faces(const std::vector<std::size_t>& lines, CrackLengthAnalysis& length,
                   LogWriter& log);
  /// Tells that a stage of the increment is done.
  void report_stage(std::string stage) const;

  const model::Model& model_;
  std::optional<model::Model> grown_; ///< in space: with the cracks of the state that is solved
  const SolveOptions& options_;
  std::vector<results::LogLine>& log_;
  base::Diagnostics& diagnostics_;
  base::OptionalFailure& trouble_;
  CondensationCache cache_;
  MountOffsetMemory mounted_;
  InheritedContactState carried_, next_carried_;
  std::optional<LoadHistoryKResult> followed_;
  std::optional<OverlappingFaceResults> free_;
  ContactDataForNextLength contact_;
  estimate::ModeMatrixCache modes_;
  std::vector<mesh::CrackFront> fronts_;
  std::vector<double> plastic_;
  bool first_ = true;
  bool divided_ = false;
};

} // namespace spricka::analysis
