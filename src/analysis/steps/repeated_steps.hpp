// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/steps/step_solver.hpp"
#include "model/forward.hpp"
#include "results/results.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace spricka::analysis {

/// Steps that end in the state of an earlier one (unloading without friction) are not solved again.
class RepeatedSteps {
public:
  /// pictured [step]: those whose stresses are wanted.
  RepeatedSteps(const model::Model& model, const std::vector<bool>& pictured);

  /// The earlier step, or null: the step must be solved.
  [[nodiscard]] const std::size_t* earlier_step(std::size_t step) const {
    return same_[step] ? &*same_[step] : nullptr;
  }
  /// Steps that are solved.
  [[nodiscard]] std::size_t solved_step_count() const;
  /// Whether stresses of a step are wanted by one that repeats it.
  [[nodiscard]] bool stresses_needed_later(std::size_t step) const;
  /// Takes stresses that were recovered for a later step alone away from the earlier one.
  void drop_extra_stresses(std::vector<results::LoadStepResult>& results) const;
  /// After a step has been solved.
  void store_closed_rows(std::size_t step, const StepSolver& solver);
  /// Adds the earlier step's results as those of this one and lets the solver go on from them.
  void copy_step(std::size_t step, StepSolver& solver,
                 std::vector<results::LoadStepResult>& results) const;

private:
  const model::Model& model_;
  const std::vector<bool>& pictured_;
  std::vector<std::optional<std::size_t>> same_;
  std::map<std::size_t, std::vector<bool>> closed_; ///< by step that another one repeats
};

} // namespace spricka::analysis
