// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/repeated_steps.hpp"

#include "model/model.hpp"

#include <algorithm>

namespace spricka::analysis {

RepeatedSteps::RepeatedSteps(const model::Model& model, const std::vector<bool>& pictured)
    : model_(model), pictured_(pictured), same_(repeated_steps(model)) {
  for (std::size_t s = 0; s < same_.size(); ++s) {
    if (same_[s] && pictured_[s] && !pictured_[*same_[s]]) {
      // Its pictures are wanted, and there are none to take over.
      same_[s].reset();
    }
  }
}

void RepeatedSteps::keep(std::size_t step, const StepSolver& solver) {
  if (std::ranges::find(same_, std::optional(step)) != same_.end()) {
    closed_[step] = solver.closed();
  }
}

void RepeatedSteps::take_over(std::size_t step, StepSolver& solver,
                              std::vector<results::StepResult>& results) const {
  results::StepResult result = results[*same_[step]];
  result.step = model_.steps[step].name;
  if (!pictured_[step]) {
    result.stress.clear();
    result.element_stress.clear();
    result.errors.clear();
  }
  solver.repeat(model_.steps[step], result.u, closed_.at(*same_[step]));
  results.push_back(std::move(result));
}

} // namespace spricka::analysis
