// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/repeated_steps.hpp"

#include "model/model.hpp"

#include <algorithm>

namespace spricka::analysis {

namespace {

void take_pictures_away(results::LoadStepResult& result) {
  result.stress.clear();
  result.element_stress.clear();
  result.errors.clear();
}

} // namespace

RepeatedSteps::RepeatedSteps(const model::Model& model, const std::vector<bool>& pictured)
    : model_(model), pictured_(pictured), same_(repeated_steps(model)) {}

std::size_t RepeatedSteps::solved_step_count() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(same_, [](const auto& earlier) { return !earlier; }));
}

bool RepeatedSteps::stresses_needed_later(std::size_t step) const {
  bool wanted = false;
  for (std::size_t s = 0; s < same_.size(); ++s) {
    wanted = wanted || (pictured_[s] && same_[s] == std::optional(step));
  }
  return wanted;
}

void RepeatedSteps::drop_extra_stresses(std::vector<results::LoadStepResult>& results) const {
  for (std::size_t s = 0; s < results.size(); ++s) {
    if (!pictured_[s]) {
      take_pictures_away(results[s]);
    }
  }
}

void RepeatedSteps::store_closed_rows(std::size_t step, const StepSolver& solver) {
  if (std::ranges::find(same_, std::optional(step)) != same_.end()) {
    closed_[step] = solver.closed_contact_rows();
  }
}

void RepeatedSteps::copy_step(std::size_t step, StepSolver& solver,
                              std::vector<results::LoadStepResult>& results) const {
  results::LoadStepResult result = results[*same_[step]];
  result.step = model_.steps[step].name;
  if (!pictured_[step]) {
    take_pictures_away(result);
  }
  solver.adopt_earlier_step(model_.steps[step], result.u, closed_.at(*same_[step]));
  results.push_back(std::move(result));
}

} // namespace spricka::analysis
