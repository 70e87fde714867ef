// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/contact_memory.hpp"
#include "analysis/steps/increment_state.hpp"
#include "analysis/steps/step_incrementation.hpp"
#include "analysis/steps/step_state.hpp"
#include "base/outcome.hpp"
#include "contact/recovery.hpp"
#include "contact/system.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Processor CONTACT: walks the steps on the condensed bodies.
namespace spricka::analysis {

class StepSolver {
public:
  /// `memory`: of what was mounted at the first length, or null: each length mounts anew.
  /// `contact`: what the last length has left of use, or null.
  StepSolver(const model::Model& model, const Discretisation& scene,
             const std::vector<SubstructuredBody>& bodies, MountOffsetMemory* memory = nullptr,
             ContactDataForNextLength* contact = nullptr);

  /// Carries out the actions of a step and solves for its end. Steps are called in deck order.
  std::optional<StepState> solve(const model::Step& step, base::OptionalFailure& trouble);

  [[nodiscard]] StepSolverState solver_state() const { return increment_state_.solver_state(); }
  /// Puts back a state that solver_state has given, so that the next increment starts from there.
  void restore_state(const StepSolverState& place) { increment_state_.restore_state(place); }
  /// Loads and fits go in a straight line to others in equal increments, contacts as they are:
  /// nothing is recovered. Empty: refused.
  std::optional<contact::ContactSystem::IncrementSolution>
  solve_increments(const StepActionFactors& to, int increments, const SeenIncrement& seen,
                   base::OptionalFailure& trouble);
  /// The state at the end of solve_increments(), from its answer; empty: refused.
  std::optional<StepState> recover_state(contact::ContactSystem::IncrementSolution solution,
                                         base::OptionalFailure& trouble);
  /// Instead: goes on from an earlier step that ended in the same state (repeated_steps), from its
  /// displacements and closed rows.
  void adopt_earlier_step(const model::Step& step, const base::Vector& u,
                          const std::vector<bool>& closed);
  /// Rows [row] closed at the end of the last step; empty: not known.
  [[nodiscard]] const std::vector<bool>& closed_contact_rows() const {
    return increment_state_.closed_rows();
  }
  /// Where the next step without friction begins to look for its closed rows, if it mounts nothing.
  void set_initial_closed_rows(std::vector<bool> closed) {
    increment_state_.set_closed_rows(std::move(closed));
  }

  /// What the last step asked of the contact system, with the closed rows it ended with.
  [[nodiscard]] contact::ContactSystem::IncrementProblem contact_problem() const {
    return increment_state_.contact_problem();
  }
  /// Null when no body has externals; its bodies are condensed_body_indices(), indices of the
  /// solver's.
  [[nodiscard]] const contact::ContactSystem* contact_system() const {
    return system_ ? &*system_ : nullptr;
  }
  [[nodiscard]] const std::vector<std::size_t>& condensed_body_indices() const {
    return condensed_;
  }
  /// Which body moves how by a combination of modes [m] that is loaded and not held.
  [[nodiscard]] std::string describe_unsupported_motion(const base::Vector& mode,
                                                        bool slides = false) const;
  [[nodiscard]] const StepActionFactors& factors() const { return increment_state_.factors(); }
  /// [row] since MOUNT
  [[nodiscard]] const base::Vector& gap_offset_at_mounting() const {
    return increment_state_.gap_offset();
  }

private:
  /// The answer at the end of the step, in increments from the factors `from` where contacts rub;
  /// none: refused.
  std::optional<contact::ContactSystem::IncrementSolution> walk(const StepActionFactors& from,
                                                                const model::Step& step,
                                                                StepState& state,
                                                                base::OptionalFailure& trouble);
  /// Displacements of all bodies and what follows from them; false: not in equilibrium.
  bool complete(std::vector<base::Vector> external, StepState& state,
                base::OptionalFailure& trouble) const;
  void note_uniqueness(const StepIncrementation& walk, StepState& state);
  /// Empty: the answer is one.
  [[nodiscard]] base::OptionalFailure
  trouble_of(const contact::ContactSystem::IncrementSolution& solution) const;
  [[nodiscard]] bool accept(const contact::ContactSystem::IncrementSolution& solution,
                            const contact::ContactSystem::IncrementProblem& problem,
                            StepState& state, base::OptionalFailure& trouble);

  const model::Model& model_;
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  std::vector<std::size_t> condensed_; ///< bodies that have externals
  std::optional<contact::ContactSystem> system_;
  IncrementState increment_state_;
  base::Vector u_;           ///< [dim * node] end of the last step
  std::vector<bool> tested_; ///< contacts in force when uniqueness was tested last
  bool certain_ = false;     ///< that test's answer
};

} // namespace spricka::analysis
