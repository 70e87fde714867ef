// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/result_value.hpp"

#include "deck/typed_line.hpp"
#include "model/model.hpp"
#include "program/checks/check_quantities.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include <fmt/format.h>

namespace spricka::program {

base::OptionalFailure read_result_request(const model::Model& model, const std::string& line,
                                          model::ResultCheck& check) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  std::optional<model::ResultCheck> found =
      deck::read_result_request_line(model, line, sources, diagnostics);
  if (!found) {
    return located_failure(base::ProgramOutcome::usage, sources, diagnostics);
  }
  check = std::move(*found);
  if (check.quantity.starts_with("TEST.")) {
    return invalid_input(
        fmt::format("{} needs a run; the shell looks at states and lives", check.quantity));
  }
  return {};
}

base::OptionalFailure evaluate_result(ShellSession& session, const model::ResultCheck& check,
                                      double& value) {
  const model::Model& model = session.model();
  const bool is_life = check.quantity == "N" || check.quantity == "LIFE";
  if (base::OptionalFailure trouble = is_life ? session.grow(false) : session.solve()) {
    return trouble;
  }
  for (const auto& argument : check.arguments) {
    const auto* name = std::get_if<std::string>(&argument);
    if (name == nullptr || *name == "NOW") {
      continue;
    }
    base::OptionalFailure
        trouble; // a contact with the name of a step costs a solution, and no more
    const auto step = std::ranges::find(model.steps, *name, &model::Step::name);
    if (step != model.steps.end()) {
      trouble =
          session.include_deck_step_result(static_cast<std::size_t>(step - model.steps.begin()));
    } else if (std::ranges::find(model.load_paths, *name, &model::LoadPathDefinition::name) !=
               model.load_paths.end()) {
      trouble = session.follow_deck_load_path(*name);
    }
    if (trouble) {
      return trouble;
    }
  }
  const std::string& q = check.quantity;
  if (q.starts_with("K") || q.starts_with("DK")) { // K without its estimated error, its bar
    if (base::OptionalFailure trouble = session.estimate_accuracy()) {
      return trouble;
    }
  } else if (q == "ERROR") {
    session.estimate_net_errors();
  }
  const results::CheckResult found =
      evaluate_check(model, check, is_life ? session.growth().result() : session.run_results());
  if (!found.trouble.empty()) {
    return base::OperationFailure{.kind = base::ProgramOutcome::check_failed, .why = found.trouble};
  }
  value = found.found;
  return {};
}

} // namespace spricka::program
