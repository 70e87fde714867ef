// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/deck_edit.hpp"

#include "analysis/steps/step_factors.hpp"
#include "base/diagnostics.hpp"
#include "grammar/catalogue.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using deck::DeckCard;
using deck::DeckCardList;

// The key by which cards of one kind are told apart; empty: there is none.
std::string_view telling_key(const grammar::CardSpec& spec) {
  if (spec.once) {
    return {};
  }
  if (spec.find("NAME") != nullptr) {
    return "NAME";
  }
  const auto found = std::ranges::find_if(spec.keys, &grammar::KeySpec::required);
  return found == spec.keys.end() ? std::string_view() : found->name;
}

// The card that a typed header means.
base::OptionalFailure find_card(const DeckCardList& text, const DeckCard& typed,
                                std::string_view key, std::size_t& index) {
  const std::string name = key.empty() ? std::string() : typed.word_value(key);
  std::vector<std::string> names;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i].name == typed.name) {
      names.push_back(text[i].word_value(key));
      if (name.empty() || names.back() == name) {
        found.push_back(i);
      }
    }
  }
  if (found.empty()) {
    return invalid_input(names.empty()
                             ? fmt::format("the deck has no ${}", typed.name)
                             : fmt::format("there is no ${} {}={}", typed.name, key, name),
                         base::make_spelling_hint(name, names));
  }
  if (found.size() > 1) {
    return invalid_input(
        fmt::format("the deck has {} cards ${} that it could be", found.size(), typed.name),
        key.empty() || !name.empty() ? "" : fmt::format("give its {}", key));
  }
  index = found.front();
  return {};
}

// Whether a word stands in a list "A B C" or "A|B|C".
bool is_listed(std::string_view list, std::string_view key) {
  const std::vector<std::string> words = grammar::split_words(list);
  return std::ranges::find(words, key) != words.end();
}

// Keys that those typed exclude: of a list of which at most one may stand there, or by a rule.
void erase_excluded_keys(const grammar::CardSpec& spec, const DeckCard& typed, DeckCard& card) {
  const auto exclude = [&](std::string_view key) {
    if (!typed.has_key(key)) {
      card.erase(key);
    }
  };
  for (const auto& [name, value] : typed.keys) {
    for (const grammar::KeySpec& other : spec.keys) {
      if (is_listed(spec.exclusive, name) && is_listed(spec.exclusive, other.name)) {
        exclude(other.name);
      }
    }
    for (const grammar::KeyPresenceRule& rule : spec.when) {
      if (rule.key == name &&
          (rule.words.empty() || is_listed(rule.words, typed.word_value(name)))) {
        for (const std::string& key : grammar::split_words(rule.forbids)) {
          exclude(key);
        }
      } else if (rule.words.empty() && is_listed(rule.forbids, name)) {
        exclude(rule.key);
      }
    }
  }
}

} // namespace

base::OptionalFailure
read_checked_deck_cards(const std::filesystem::path& deck,
                        const std::vector<std::pair<std::string, std::string>>& defines,
                        DeckCardList& text, std::vector<std::filesystem::path>& files) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  std::optional<DeckCardList> found = deck::read_deck_card_list(deck, sources, diagnostics);
  if (!found) {
    return located_failure(base::ProgramOutcome::deck_error, sources, diagnostics);
  }
  text = std::move(*found);
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(sources.count()); ++f) {
    files.emplace_back(sources.file_name(f));
  }
  for (const auto& [name, expression] : defines) {
    if (base::OptionalFailure trouble =
            set_parameter(fmt::format("{} = {}", name, expression), text)) {
      return trouble;
    }
  }
  return {};
}

std::string cards_without_cracks_text(const DeckCardList& text) {
  std::string all;
  for (const DeckCard& card : text) {
    if (card.name == "CRACK") {
      continue;
    }
    all += "$" + card.name;
    for (const auto& [key, value] : card.keys) {
      all += fmt::format(" {}={}", key, value);
    }
    all += "\n" + card.data;
  }
  return all;
}

base::OptionalFailure set_card_keys(const std::string& header, DeckCardList& text,
                                    std::size_t& changed) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const std::int32_t file = sources.add_text("line", header + "\n");
  const std::vector<grammar::CardHeader> cards = grammar::parse_cards(sources, file, diagnostics);
  if (diagnostics.has_errors()) {
    return located_failure(base::ProgramOutcome::usage, sources, diagnostics);
  }
  const grammar::CardSpec* spec =
      cards.size() == 1 ? grammar::find_card(cards.front().name) : nullptr;
  if (spec == nullptr) {
    return invalid_input("a card with keys to change is expected", "$CRACK NAME=C A0=6");
  }
  DeckCard typed;
  typed.name = spec->name;
  for (const grammar::HeaderParameter& parameter : cards.front().parameters) {
    typed.keys.emplace_back(parameter.key, sources.text(parameter.span));
  }
  const std::string_view key = telling_key(*spec);
  if (base::OptionalFailure trouble = find_card(text, typed, key, changed)) {
    return trouble;
  }
  DeckCard& card = text[changed];
  erase_excluded_keys(*spec, typed, card);
  for (const auto& [name, value] : typed.keys) {
    if (name != key) {
      card.set_key(name, value);
    }
  }
  return {};
}

base::OptionalFailure set_parameter(const std::string& line, DeckCardList& text) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const auto read = [&](const std::string& data) {
    const std::int32_t file = sources.add_text("line", data);
    return grammar::parse_parameter_assignments(
        sources, {file, 0, static_cast<std::uint32_t>(data.size())}, diagnostics);
  };
  const std::vector<grammar::ParameterAssignment> typed = read(line + "\n");
  if (diagnostics.has_errors() || typed.size() != 1) {
    return located_failure(base::ProgramOutcome::usage, sources, diagnostics);
  }
  const grammar::ParameterAssignment& wanted = typed.front();
  if (deck::replace_parameter(text, wanted.name, sources.text(wanted.value.span))) {
    return {};
  }
  std::vector<std::string> names;
  for (const DeckCard& card : cards_named(text, "PARAMETER")) {
    std::ranges::transform(read(card.data), std::back_inserter(names),
                           &grammar::ParameterAssignment::name);
  }
  return invalid_input(fmt::format("the deck has no parameter '{}'", wanted.written),
                       base::make_spelling_hint(wanted.name, names));
}

void comment_out_card(DeckCardList& text, std::size_t card) {
  const std::string lines = deck::format_deck_card_list({text[card]}, ".");
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', at), lines.size() - 1);
    text[card - 1].data += "! " + lines.substr(at, end + 1 - at);
    at = end + 1;
  }
  text.erase(text.begin() + static_cast<std::ptrdiff_t>(card));
}

std::string step_action_text(const model::Model& model, const model::StepAction& action) {
  if (const auto* load = std::get_if<model::ApplyLoad>(&action)) { // digits for the same number
    return fmt::format("LOAD {} {}", model.cases[load->load_case.index()].name, load->factor);
  }
  if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
    return fmt::format("FIT {} {}", model.contacts[fit->contact.index()].name, fit->factor);
  }
  if (const auto* on = std::get_if<model::MountContact>(&action)) {
    return "MOUNT " + model.contacts[on->contact.index()].name;
  }
  return "DISMOUNT " +
         model.contacts[std::get<model::DismountContact>(action).contact.index()].name;
}

namespace {

std::string free_name(const model::Model& model, std::size_t number) {
  const std::vector<std::string> taken = candidate_argument_names('s', model);
  std::string name = number == 0 ? "NOW" : fmt::format("NOW_{}", number);
  while (std::find(taken.begin() + 1, taken.end(), name) != taken.end()) {
    name += "_";
  }
  return name;
}

template <class ActionType>
bool acts_on(const std::vector<model::Step>& steps, base::ContactId contact) {
  return std::ranges::any_of(steps, [&](const model::Step& step) {
    return std::ranges::any_of(step.actions, [&](const model::StepAction& action) {
      const auto* a = std::get_if<ActionType>(&action);
      return a != nullptr && a->contact == contact;
    });
  });
}

} // namespace

void append_steps(const model::Model& model, const std::vector<model::Step>& steps,
                  DeckCardList& text) {
  const std::vector<model::Step> beginning{model.steps.front()};
  DeckCard& first = *std::ranges::find(text, "STEP", &DeckCard::name);
  const auto add_row = [&](DeckCard& card, const model::StepAction& action) {
    card.data += fmt::format("  {}\n", step_action_text(model, action));
  };
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const base::ContactId id(c);
    if (acts_on<model::ApplyFit>(steps, id) && !analysis::is_fit_set_by_steps(model, id)) {
      add_row(first, model::ApplyFit{id, 1.0});
    }
    if (acts_on<model::MountContact>(steps, id) && !analysis::is_mounted_by_steps(model, id) &&
        !acts_on<model::DismountContact>(beginning, id)) {
      add_row(first, model::MountContact{id});
    }
  }
  for (std::size_t s = 0; s < steps.size(); ++s) {
    DeckCard card;
    card.name = "STEP";
    card.set_key("NAME", free_name(model, steps.size() - 1 - s));
    if (steps[s].substeps > 1) {
      card.set_key("SUBSTEPS", std::to_string(steps[s].substeps));
    }
    for (const model::StepAction& action : steps[s].actions) {
      add_row(card, action);
    }
    deck::append_card(text, std::move(card));
  }
}

} // namespace spricka::program
