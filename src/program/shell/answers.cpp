// SPDX-License-Identifier: GPL-3.0-or-later
// What a session answers from its bench.
#include "deck/typed_line.hpp"
#include "model/model.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/session.hpp"
#include "program/shell/trouble.hpp"

#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// A further step that sets the factor of a load case to a value as a LOAD of $STEP has it.
base::OptionalFailure add_load_step(const model::Model& model, const std::string& load_case,
                                    const std::string& value, std::vector<model::Step>& way,
                                    double& factor) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  std::optional<model::Step> step = deck::read_step_line(
      model, fmt::format("LOAD {} {}", load_case, value), sources, diagnostics);
  if (!step) {
    return located_failure(base::ProgramOutcome::usage, sources, diagnostics);
  }
  factor = std::get<model::ApplyLoad>(step->actions.front()).factor;
  step->name = fmt::format("{} {:.6g}", load_case, factor);
  way.push_back(std::move(*step));
  return {};
}

} // namespace

base::OptionalFailure ShellSession::estimate_accuracy() {
  base::OptionalFailure trouble = solve();
  return trouble ? trouble : deck_->solver().estimate_accuracy();
}

base::OptionalFailure ShellSession::follow(const model::LoadPathDefinition& card,
                                           const std::vector<model::Step>& from,
                                           const std::vector<model::Step>& to,
                                           const PathParameterRange& range) {
  if (has_friction()) {
    return invalid_input(
        "with friction K depends on the way, not only on where it leads: there is no map of it",
        "LOAD, solve and K1 go that way step by step");
  }
  base::OptionalFailure trouble = deck_->solver().follow_load_path(card, from, to);
  if (!trouble) {
    mapped_ = card.name;
    range_ = range;
  }
  return trouble;
}

base::OptionalFailure ShellSession::follow_deck_load_path(const std::string& name) {
  std::size_t index = 0;
  base::OptionalFailure trouble =
      find_name_index(candidate_argument_names('l', model()), "load path", name, index);
  trouble = trouble ? trouble : solve();
  if (trouble) {
    return trouble;
  }
  const model::LoadPathDefinition card = model().load_paths[index];
  return follow(card, steps_up_to(model(), card.from.index()),
                steps_up_to(model(), card.to.index()), {});
}

base::OptionalFailure ShellSession::follow_load_case_range(const std::string& load_case,
                                                           const std::string& from,
                                                           const std::string& to) {
  if (base::OptionalFailure trouble = solve()) {
    return trouble;
  }
  std::array<std::vector<model::Step>, 2> ends;
  PathParameterRange range{.what = "factor"};
  for (const bool end : {false, true}) {
    double& factor = end ? range.to : range.from;
    std::vector<model::Step>& way = ends[end ? 1 : 0];
    way = steps_up_to(model(), set_);
    if (base::OptionalFailure trouble =
            add_load_step(model(), load_case, end ? to : from, way, factor)) {
      return trouble;
    }
  }
  if (range.from == range.to) {
    return invalid_input("both ends of the map are the same");
  }
  model::LoadPathDefinition card;
  card.name = load_case;
  return follow(card, ends[0], ends[1], range);
}

const results::LoadPathResult* ShellSession::last_followed_path() const {
  return mapped_.empty() || !deck_->solver().is_ready()
             ? nullptr
             : results::find_path(run_results().increments.front(), mapped_);
}

} // namespace spricka::program
