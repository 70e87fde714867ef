// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/length.hpp"
#include "analysis/lengths/load_history.hpp"
#include "analysis/lengths/log_writer.hpp"
#include "analysis/lengths/pictured_steps.hpp"
#include "analysis/lengths/solve_options.hpp"
#include "analysis/steps/contact_memory.hpp"
#include "analysis/steps/repeated_steps.hpp"
#include "base/outcome.hpp"
#include "model/forward.hpp"
#include "results/results.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// What the steps of one crack length are solved with; all must outlive the sequence.
struct StepSequenceContext {
  const model::Model& model;
  const SolveOptions& options;
  const PicturedSteps& pictured; ///< at their ends stresses are recovered
  bool bars = true;              ///< error bars of K, by which it is corrected
  bool sensitivities = true;     ///< with bars: derivatives of K
  bool passes_overlap = false;   ///< goes on with faces that overlap, without derivatives, pictures
  ContactDataForNextLength& contact;
  LogWriter& log;
};

/// The steps of a deck on one condensed crack length, one after another, then its load paths and
/// the loads of the growth.
class StepSequence {
public:
  StepSequence(const StepSequenceContext& context, CrackLengthAnalysis& length);

  /// Adds all steps and paths to `increment`; with friction the growth's loads are followed from
  /// `carried` on. It ends early at the first step whose crack faces would overlap, unless it
  /// passes_overlap. Not empty: there is no answer.
  base::OptionalFailure solve(results::CrackLengthResult& increment,
                              InheritedContactState& carried);
  /// Crack lines whose faces would overlap.
  [[nodiscard]] const std::vector<std::size_t>& cracks_with_overlapping_faces() const {
    return touching_;
  }
  /// K of the loads of the growth; empty without friction.
  [[nodiscard]] std::optional<LoadHistoryKResult>& load_history() { return followed_; }

private:
  /// Whether the next step is to be solved.
  enum class Continuation { next_step, end };

  void copy_step(std::size_t s, results::CrackLengthResult& increment);
  Continuation solve_step(std::size_t s, results::CrackLengthResult& increment);
  std::optional<StepState> solve_contact(std::size_t s);
  bool recover_step(std::size_t s, const StepState& state, results::CrackLengthResult& increment);
  void begin_error_bars(std::size_t s, const StepState& state, bool sensitivities,
                        results::LoadStepResult& result);
  void finish_error_bars(results::CrackLengthResult& increment);
  struct UnfinishedStep;
  void end_step(const UnfinishedStep& step, const results::CrackLengthResult& increment);
  void add_stresses(std::size_t s, const StepState& state, results::LoadStepResult& result);
  void recover_stresses(std::size_t s, const std::vector<double>& energy,
                        results::LoadStepResult& result);
  void add_stresses_of_most_loaded_step(results::CrackLengthResult& increment);
  void solve_paths(results::CrackLengthResult& increment, InheritedContactState& carried);
  void correct_paths(results::CrackLengthResult& increment) const;
  bool follow_growth_loads(InheritedContactState& carried);
  void report_stage(std::string stage) const;
  void show(const results::CrackLengthResult& increment) const;

  const StepSequenceContext context_;
  CrackLengthAnalysis& length_;
  std::unique_ptr<StepSolver> solver_;
  RepeatedSteps repeated_;
  CyclicLoadHistorySolver history_;
  std::vector<std::size_t> touching_;
  /// A step whose bars wait.
  struct UnfinishedStep {
    std::size_t step = 0;
    bool overlaps = false;           ///< faces of cracks do, so that there are no pictures
    std::vector<double> energy = {}; ///< [element] of strain; empty: not asked for
  };
  std::vector<UnfinishedStep> unfinished_;
  std::vector<double> energy_; ///< [element] of the most loaded step so far
  std::optional<LoadHistoryKResult> followed_;
  base::OptionalFailure trouble_;
  std::size_t solved_ = 0;
};

/// What has K on the cracked mesh, in words: "2 tips", "1 front of 13 points".
std::string describe_fronts(const Discretisation& scene);

} // namespace spricka::analysis
