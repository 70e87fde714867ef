// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/pictured_steps.hpp"

#include "model/model.hpp"
#include "model/wanted_steps.hpp"
#include "results/shown_step.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

namespace spricka::analysis {

PicturedSteps steps_with_stress_recovery(const model::Model& model,
                                         std::span<const results::CrackLengthResult> solved,
                                         bool last_increment) {
  PicturedSteps pictured = steps_with_requested_stresses(model, last_increment);
  if (solved.empty() && !results::shown_step_of_deck(model)) {
    pictured.most_loaded = true;
    return pictured;
  }
  const std::string shown = results::shown_step_name(model, solved);
  for (std::size_t s = 0; s < model.steps.size(); ++s) {
    pictured.known[s] = pictured.known[s] || model.steps[s].name == shown;
  }
  return pictured;
}

PicturedSteps steps_with_requested_stresses(const model::Model& model, bool last_increment) {
  std::vector<bool> pictured(model.steps.size(), false);
  for (const model::OutputFileRequest& output : model.outputs) {
    const bool stress = std::any_of(output.requests.begin(), output.requests.end(),
                                    [](const auto& request) { return request.quantity == "S"; });
    if (output.format == model::OutputFormat::vtu || stress) {
      for (const std::size_t s : model::output_step_indices(model, output, last_increment)) {
        pictured[s] = true;
      }
    }
  }
  for (const model::ResultCheck& check : model.checks) {
    for (std::size_t s = 0; check.quantity == "ERROR" && s < model.steps.size(); ++s) {
      const auto* step = std::get_if<std::string>(&check.arguments.at(1));
      pictured[s] = pictured[s] || (step != nullptr && *step == model.steps[s].name);
    }
  }
  return {.known = std::move(pictured)};
}

} // namespace spricka::analysis
