// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/contact_memory.hpp"
#include "analysis/steps/friction_history.hpp"
#include "analysis/steps/mount_memory.hpp"
#include "analysis/steps/step_factors.hpp"
#include "analysis/steps/step_state.hpp"
#include "base/outcome.hpp"
#include "contact/recovery.hpp"
#include "contact/system.hpp"
#include "solve/contact_qp.hpp"

#include <functional>
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
             ContactMemory* contact = nullptr);

  /// Carries out the actions of a step and solves for its end. Steps are called in deck order.
  std::optional<StepState> solve(const model::Step& step, base::OptionalFailure& trouble);

  /// All that the next increment depends on.
  struct StepSolverState {
    StepActionFactors factors;
    base::Vector offset;      ///< [row]
    std::vector<bool> closed; ///< [row] a start for the solution; may be empty
    FrictionState friction;
  };
  [[nodiscard]] StepSolverState solver_state() const;
  /// Puts back a state that solver_state has given, so that the next increment starts from there.
  void restore_state(const StepSolverState& place);
  /// Is shown each solved increment.
  using Seen = std::function<void(const contact::ContactSystem::IncrementProblem&,
                                  const contact::ContactSystem::IncrementSolution&)>;
  /// Loads and fits go in a straight line to others in equal increments, contacts as they are:
  /// nothing is recovered. Empty: refused.
  std::optional<contact::ContactSystem::IncrementSolution>
  solve_increments(const StepActionFactors& to, int increments, const Seen& seen,
                   base::OptionalFailure& trouble);
  /// The state at the end of solve_increments(), from its answer; empty: refused.
  std::optional<StepState> recover_state(contact::ContactSystem::IncrementSolution solution,
                                         base::OptionalFailure& trouble);
  /// Instead: goes on from an earlier step that ended in the same state (repeated_steps), from its
  /// displacements and closed rows.
  void adopt_earlier_step(const model::Step& step, const base::Vector& u,
                          const std::vector<bool>& closed);
  /// Rows [row] closed at the end of the last step; empty: not known.
  [[nodiscard]] const std::vector<bool>& closed_contact_rows() const { return closed_; }
  /// Where the next step without friction begins to look for its closed rows, if it mounts nothing.
  void set_start_rows(std::vector<bool> closed) { closed_ = std::move(closed); }

  /// What the last step asked of the contact system, with the closed rows it ended with.
  [[nodiscard]] contact::ContactSystem::IncrementProblem contact_problem() const;
  /// Null when no body has externals; its bodies are condensed_bodies(), indices of the solver's.
  [[nodiscard]] const contact::ContactSystem* contact_system() const {
    return system_ ? &*system_ : nullptr;
  }
  [[nodiscard]] const std::vector<std::size_t>& condensed_bodies() const { return condensed_; }
  /// The part of the gaps of these rows [rows] that neither fits nor loads scale.
  [[nodiscard]] base::Vector gap_without_fits_and_loads(const std::vector<std::size_t>& rows) const;
  /// Which body moves how by a combination of modes [m] that is loaded and not held.
  [[nodiscard]] std::string unsupported_motion(const base::Vector& mode, bool slides = false) const;
  [[nodiscard]] const StepActionFactors& factors() const { return factors_; }
  [[nodiscard]] const base::Vector& mount_offset() const { return offset_; } ///< [row] since MOUNT

private:
  bool act(const model::Step& step, base::OptionalFailure& trouble);
  [[nodiscard]] bool mount(std::size_t contact);
  [[nodiscard]] base::Vector prescribed() const;
  /// The answer at the end of the step, in increments from the factors `from` where contacts rub;
  /// none: refused.
  std::optional<contact::ContactSystem::IncrementSolution> walk(const StepActionFactors& from,
                                                                const model::Step& step,
                                                                StepState& state,
                                                                base::OptionalFailure& trouble);
  struct StepIncrementation {
    StepActionFactors from, to;
    contact::ContactSystem::IncrementProblem problem; ///< of the last increment
    contact::ContactSystem::IncrementSolution solution;
    int increments = 0, iterations = 0, pivots = 0;
    const Seen* seen = nullptr;
    struct ReachedIncrement {
      double at = 0.0; ///< part of the step
      solve::ExpectedForces forces;
    };
    std::vector<ReachedIncrement> reached = {}; ///< the last two increments
  };
  /// Steps in which contacts rub: in as many increments as the card says, and once more in others
  /// to tell their error, or in ever more until it is small (manual, contact.25).
  bool walk_rubbing(StepIncrementation& walk, const model::Step& step, StepState& state,
                    base::OptionalFailure& trouble);
  /// In so many equal increments from where `start` stands.
  bool walk_load_path(StepIncrementation& walk, const StepSolverState& start, int increments,
                      base::OptionalFailure& trouble);
  [[nodiscard]] StepState begin_state() const;
  /// Displacements of all bodies and what follows from them; false: not in equilibrium.
  bool complete(std::vector<base::Vector> external, StepState& state,
                base::OptionalFailure& trouble) const;
  /// One increment between two parts of the step, halved where it does not converge.
  bool advance(StepIncrementation& walk, std::pair<double, double> part, int halvings);
  [[nodiscard]] static solve::ExpectedForces expected_at(const StepIncrementation& walk,
                                                         double part);
  void remember(const StepIncrementation& walk);
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
  StepActionFactors factors_;
  base::Vector offset_;      ///< [row] gap taken on at MOUNT
  base::Vector u_;           ///< [dim * node] end of the last step
  std::vector<bool> closed_; ///< [row] end of the last step
  FrictionHistory history_;
  MountOffsetMemory* memory_ = nullptr;
  std::vector<bool> tested_; ///< contacts in force when uniqueness was tested last
  bool certain_ = false;     ///< that test's answer
};

} // namespace spricka::analysis
