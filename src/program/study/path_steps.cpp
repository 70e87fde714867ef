// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/path_steps.hpp"

#include "grammar/lexeme.hpp"
#include "model/model.hpp"
#include "program/study/deck_edits.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

/// Factors of fits and load cases, by {"LOAD", name}.
using ActionFactors = std::map<std::pair<std::string, std::string>, double>;

// Those at the end of a step.
ActionFactors factors_after(const model::Model& model, std::size_t step) {
  ActionFactors factors;
  for (std::size_t s = 0; s <= step; ++s) {
    for (const model::StepAction& action : model.steps[s].actions) {
      if (const auto* load = std::get_if<model::ApplyLoad>(&action)) {
        factors[{"LOAD", model.cases[load->load_case.index()].name}] = load->factor;
      } else if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
        factors[{"FIT", model.contacts[fit->contact.index()].name}] = fit->factor;
      }
    }
  }
  return factors;
}

// LOAD SHAFTLOAD 0.3, for each of what either end has.
std::string lines_at(const ActionFactors& from, const ActionFactors& to, double t) {
  ActionFactors between;
  for (const auto& [action, factor] : from) {
    between[action] = (1.0 - t) * factor;
  }
  for (const auto& [action, factor] : to) {
    between[action] += t * factor;
  }
  std::string lines;
  for (const auto& [action, factor] : between) {
    lines += fmt::format("  {} {} {:.12g}\n", action.first, action.second, factor);
  }
  return lines;
}

// Without lines of $CHECK that name a path.
void drop_path_checks(deck::DeckCardList& text) {
  for (deck::DeckCard& card : cards_named(text, "CHECK")) {
    filter_data_lines(card, [](const std::vector<std::string>& fields) {
      return std::ranges::none_of(fields, [](const std::string& field) {
        return grammar::to_upper(field).find("PATH.") != std::string::npos;
      });
    });
  }
  std::erase_if(text, [](const deck::DeckCard& card) {
    return card.name == "CHECK" && split_data_lines(card).empty();
  });
}

} // namespace

bool replace_load_paths_by_steps(deck::DeckCardList& text, const model::Model& model) {
  if (model.load_paths.empty() || !model.spectra.empty()) {
    return false;
  }
  std::erase_if(text, [](const deck::DeckCard& card) { return card.name == "LOADPATH"; });
  drop_path_checks(text);
  constexpr int steps = 10;
  for (const model::LoadPathDefinition& path : model.load_paths) {
    const ActionFactors from = factors_after(model, path.from.index());
    const ActionFactors to = factors_after(model, path.to.index());
    for (int i = 1; i <= steps; ++i) {
      const double t = path.beyond * i / steps;
      append_card(text, deck::make_card("STEP", {{"NAME", fmt::format("{}_{}", path.name, i)}},
                                        lines_at(from, to, t)));
    }
  }
  return true;
}

} // namespace spricka::program
