// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/friction_history.hpp"
#include "analysis/steps/mount_memory.hpp"
#include "analysis/steps/step_factors.hpp"
#include "base/outcome.hpp"
#include "contact/system.hpp"

#include <utility>
#include <vector>

namespace spricka::analysis {

/// All that the next increment depends on.
struct StepSolverState {
  StepActionFactors factors;
  base::Vector offset;      ///< [row]
  std::vector<bool> closed; ///< [row] a start for the solution; may be empty
  FrictionState friction;
};

/// The same as increments move it on: factors of loads and fits, gaps taken on at MOUNT, closed
/// rows, what friction remembers; and the problem that follows from it.
class IncrementState {
public:
  /// Before the first step. `memory`: of what was mounted at the first length, or null.
  IncrementState(const model::Model& model, const Discretisation& scene,
                 const std::vector<SubstructuredBody>& bodies, MountOffsetMemory* memory);

  /// Carries out the actions of a step that begins at displacements u [dim * node]; false: a
  /// contact cannot be mounted.
  bool carry_out_actions(const model::Step& step, const base::Vector& u,
                         base::OptionalFailure& trouble);
  /// Takes a solved increment: where rows stand tangentially now.
  void accept_solved_increment(const contact::ContactSystem& system,
                               const contact::ContactSystem::IncrementProblem& problem,
                               const contact::ContactSystem::IncrementSolution& solution);

  [[nodiscard]] contact::ContactSystem::IncrementProblem contact_problem() const;
  [[nodiscard]] base::Vector prescribed_displacements() const; ///< [dim * node]
  [[nodiscard]] const StepActionFactors& factors() const { return factors_; }
  [[nodiscard]] const base::Vector& gap_offset() const { return offset_; } ///< [row] since MOUNT
  [[nodiscard]] const std::vector<bool>& closed_rows() const { return closed_; } ///< [row] or empty
  [[nodiscard]] const FrictionHistory& friction_history() const { return history_; }
  void set_factors(StepActionFactors factors) { factors_ = std::move(factors); }
  void set_closed_rows(std::vector<bool> closed) { closed_ = std::move(closed); }

  [[nodiscard]] StepSolverState solver_state() const;
  /// Puts back what solver_state() has given, so that the next increment starts from there.
  void restore_state(const StepSolverState& place);

private:
  [[nodiscard]] bool mount(std::size_t contact, const base::Vector& u);

  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  StepActionFactors factors_;
  base::Vector offset_;      ///< [row] gap taken on at MOUNT
  std::vector<bool> closed_; ///< [row] end of the last step
  FrictionHistory history_;
  MountOffsetMemory* memory_;
};

} // namespace spricka::analysis
