// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/shown_step.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::results {

namespace {

// What tells how much a step loads the model, the most telling first: K, energy release rate of
// tips without K, contact pressure, strain energy.
using LoadingMeasures = std::array<double, 4>;

LoadingMeasures measure_loading(const LoadStepResult& step) {
  LoadingMeasures most{};
  for (const FrontResult& front : step.fronts) {
    for (const FrontPointResult& point : front.points) {
      most[0] = std::max(
          most[0], std::sqrt(point.K1 * point.K1 + point.K2 * point.K2 + point.K3 * point.K3));
      most[1] = std::max(most[1], front.two_materials ? std::abs(point.G) : 0.0);
    }
  }
  for (const ContactResult& contact : step.contacts) {
    most[2] = std::max(most[2], contact.mounted ? contact.max_pressure : 0.0);
  }
  most[3] = step.energy;
  return most;
}

} // namespace

std::optional<std::size_t> shown_step_of_deck(const model::Model& model) {
  const base::StepId named = model.control.shown_step.valid() ? model.control.shown_step
                             : model.growth                   ? model.growth->kmax
                                                              : base::StepId();
  // a shell may have other steps than the deck
  return named.valid() && named.index() < model.steps.size() ? std::optional(named.index())
                                                             : std::nullopt;
}

std::size_t most_loaded_step(const CrackLengthResult& increment) {
  constexpr double as_large = 1e-9; // round-off makes no step the first
  std::vector<LoadingMeasures> measures;
  for (const LoadStepResult& step : increment.steps) {
    measures.push_back(measure_loading(step));
  }
  for (std::size_t kind = 0; kind < LoadingMeasures().size(); ++kind) {
    std::size_t best = 0;
    for (std::size_t s = 1; s < measures.size(); ++s) {
      best = measures[s][kind] > measures[best][kind] * (1.0 + as_large) ? s : best;
    }
    if (measures[best][kind] > 0.0) {
      return best;
    }
  }
  return increment.steps.size() - 1;
}

std::string shown_step_name(const model::Model& model,
                            std::span<const CrackLengthResult> increments) {
  if (const std::optional<std::size_t> named = shown_step_of_deck(model)) {
    return model.steps[*named].name;
  }
  if (!increments.empty() && !increments.front().steps.empty()) {
    return increments.front().steps[most_loaded_step(increments.front())].step;
  }
  return model.steps.empty() ? std::string() : model.steps.back().name;
}

const LoadStepResult* shown_step_result(const model::Model& model,
                                        std::span<const CrackLengthResult> increments,
                                        const CrackLengthResult& increment) {
  const LoadStepResult* const step = find_step(increment, shown_step_name(model, increments));
  return step != nullptr || increment.steps.empty() ? step : &increment.steps.back();
}

} // namespace spricka::results
