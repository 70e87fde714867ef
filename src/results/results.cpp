// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/results.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::results {

const StepResult* find_step(const Increment& increment, std::string_view step) {
  const auto found = std::find_if(increment.steps.begin(), increment.steps.end(),
                                  [&](const StepResult& s) { return s.step == step; });
  return found == increment.steps.end() ? nullptr : &*found;
}

const TipResult* find_tip(const StepResult& step, std::string_view tip) {
  const auto found = std::find_if(step.tips.begin(), step.tips.end(),
                                  [&](const TipResult& t) { return t.name == tip; });
  return found == step.tips.end() ? nullptr : &*found;
}

const ContactResult* find_contact(const StepResult& step, std::string_view contact) {
  const auto found = std::find_if(step.contacts.begin(), step.contacts.end(),
                                  [&](const ContactResult& c) { return c.name == contact; });
  return found == step.contacts.end() ? nullptr : &*found;
}

const LoadPathResult* find_path(const Increment& increment, std::string_view path) {
  const auto it = std::ranges::find(increment.paths, path, &LoadPathResult::name);
  return it == increment.paths.end() ? nullptr : &*it;
}

const TipResult* find_tip_at(const RunResult& run, std::string_view step, std::string_view tip,
                             double a) {
  const TipResult* nearest = nullptr;
  for (const Increment& increment : run.increments) {
    const StepResult* const at = find_step(increment, step);
    const TipResult* const found = at == nullptr ? nullptr : find_tip(*at, tip);
    if (found != nullptr &&
        (nearest == nullptr || std::abs(found->a - a) < std::abs(nearest->a - a))) {
      nearest = found;
    }
  }
  return nearest;
}

} // namespace spricka::results
