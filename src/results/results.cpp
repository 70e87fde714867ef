// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/results.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::results {

const LoadStepResult* find_step(const CrackLengthResult& increment, std::string_view step) {
  const auto found = std::find_if(increment.steps.begin(), increment.steps.end(),
                                  [&](const LoadStepResult& s) { return s.step == step; });
  return found == increment.steps.end() ? nullptr : &*found;
}

const FrontResult* find_front(const LoadStepResult& step, std::string_view front) {
  const auto found = std::ranges::find(step.fronts, front, &FrontResult::name);
  return found == step.fronts.end() ? nullptr : &*found;
}

const ContactResult* find_contact(const LoadStepResult& step, std::string_view contact) {
  const auto found = std::find_if(step.contacts.begin(), step.contacts.end(),
                                  [&](const ContactResult& c) { return c.name == contact; });
  return found == step.contacts.end() ? nullptr : &*found;
}

const LoadPathResult* find_path(const CrackLengthResult& increment, std::string_view path) {
  const auto it = std::ranges::find(increment.paths, path, &LoadPathResult::name);
  return it == increment.paths.end() ? nullptr : &*it;
}

const FrontResult* find_front_at_length(const RunResult& run, std::string_view step,
                                        std::string_view front, double a) {
  const FrontResult* nearest = nullptr;
  for (const CrackLengthResult& increment : run.increments) {
    const LoadStepResult* const at = find_step(increment, step);
    const FrontResult* const found = at == nullptr ? nullptr : find_front(*at, front);
    if (found != nullptr &&
        (nearest == nullptr || std::abs(found->a - a) < std::abs(nearest->a - a))) {
      nearest = found;
    }
  }
  return nearest;
}

} // namespace spricka::results
