// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/growth_cards.hpp"

#include "deck/context.hpp"
#include "deck/load.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace spricka::deck {

namespace {

/// Keys of $GROW that say nothing of where cracks go, beside the constants of a law.
constexpr std::array<std::string_view, 9> law_keys{
    "LAW", "MATERIAL", "KMAX", "KMIN", "SPECTRUM", "TOL", "AMAX", "CYCLES", "INTERACTION"};
/// Cards of laws and of the cycles that they count.
constexpr std::array<std::string_view, 3> cards_of_cycles{"SPECTRUM", "INTERACTION", "LAW"};
/// Cards that no solution hangs on.
constexpr std::array<std::string_view, 3> cards_for_readers{"CHECK", "OUTPUT", "SWEEP"};

template <class List> bool has_entry(const List& list, std::string_view name) {
  return std::ranges::find(list, name) != list.end();
}

using Expressions = std::map<std::string, std::string>; // by parameter, upper case

Expressions parameter_expressions(const DeckCardList& deck) {
  Expressions found;
  for (const DeckCard& card : cards_named(deck, "PARAMETER")) {
    base::SourceTexts sources;
    base::Diagnostics read_before;
    const std::int32_t file = sources.add_text("parameters", card.data);
    for (const grammar::ParameterAssignment& line : grammar::parse_parameter_assignments(
             sources, {file, 0, static_cast<std::uint32_t>(card.data.size())}, read_before)) {
      found[line.name] = sources.text(line.value.span);
    }
  }
  return found;
}

bool mentions(std::string_view text, const std::set<std::string>& names) {
  std::string word;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ' ';
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
      continue;
    }
    if (!word.empty() && names.contains(grammar::to_upper(word))) {
      return true;
    }
    word.clear();
  }
  return false;
}

// Parameters with another value: those with another expression, and what is made of them.
std::set<std::string> changed_parameters(const DeckCardList& before, const DeckCardList& after) {
  const Expressions old = parameter_expressions(before);
  const Expressions now = parameter_expressions(after);
  std::set<std::string> changed;
  for (const auto& [name, expression] : now) {
    const auto was = old.find(name);
    if (was == old.end() || was->second != expression) {
      changed.insert(name);
    }
  }
  for (std::size_t known = changed.size() + 1; known != changed.size();) {
    known = changed.size();
    for (const auto& [name, expression] : now) {
      if (mentions(expression, changed)) {
        changed.insert(name);
      }
    }
  }
  return changed;
}

// Whether a card that is no law, nor for readers alone, is as it was, with the values it had.
bool is_same_card(const DeckCard& before, const DeckCard& after,
                  const std::set<std::string>& changed) {
  if (before.keys != after.keys || before.data != after.data) {
    return false;
  }
  return !mentions(after.data, changed) && std::ranges::none_of(after.keys, [&](const auto& key) {
    return mentions(key.second, changed);
  });
}

// Whether a $GROW moves cracks as another one does.
bool is_same_course(const DeckCard& before, const DeckCard& after,
                    const std::set<std::string>& changed) {
  const auto is_given_length = [](const DeckCard& card) {
    return card.word_value("LAW") == "INCREMENT";
  };
  const auto has = [&](const DeckCard& card, const DeckCard& in) {
    return std::ranges::all_of(card.keys, [&](const auto& key) {
      const std::string* other = in.find(key.first);
      return has_entry(law_keys, key.first) || grammar::is_law_constant(key.first) ||
             (other != nullptr && *other == key.second && !mentions(key.second, changed));
    });
  };
  return !is_given_length(before) && !is_given_length(after) && has(before, after) &&
         has(after, before);
}

} // namespace

bool differ_in_growth_law_alone(const DeckCardList& before, const DeckCardList& after,
                                const std::set<std::string>& script_constants) {
  const std::set<std::string> changed = changed_parameters(before, after);
  if (before.size() != after.size() || std::ranges::any_of(changed, [&](const std::string& name) {
        return script_constants.contains(name);
      })) {
    return false;
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::string& name = after[i].name;
    if (before[i].name != name) {
      return false;
    }
    const bool same = name == "GROW"        ? is_same_course(before[i], after[i], changed)
                      : name == "PARAMETER" ? true
                      : has_entry(cards_of_cycles, name) || has_entry(cards_for_readers, name)
                          ? true
                          : is_same_card(before[i], after[i], changed);
    if (!same) {
      return false;
    }
  }
  return true;
}

std::optional<GrowthCards> read_growth_cards(const model::Model& model, const DeckCardList& deck,
                                             const std::filesystem::path& file,
                                             base::SourceTexts& sources,
                                             base::Diagnostics& diagnostics) {
  constexpr std::array<std::string_view, 4> wanted{"DECK", "PARAMETER", "GROW", "END"};
  DeckCardList cards;
  std::ranges::copy_if(deck, std::back_inserter(cards), [&](const DeckCard& card) {
    return has_entry(wanted, card.name) || has_entry(cards_of_cycles, card.name);
  });
  for (DeckCard& card : cards_named(cards, "GROW")) {
    card.erase("CRACKS"); // of a half model not all are left
  }
  const DeckFileCards loaded = read_deck_and_includes(
      file, sources, diagnostics, format_deck_card_list(cards, file.parent_path() / "."));
  DeckContext context{sources, diagnostics};
  check_cards_and_define_names(context, loaded.cards, {});
  define_names_of_model(context, model);
  model::Model& read = context.model;
  read.mesh.dim = model.mesh.dim;
  read.units = model.units;
  read.materials = model.materials;
  read.mpcs = model.mpcs;
  read.cases = model.cases;
  read.contacts = model.contacts;
  read.cracks = model.cracks;
  read.steps = model.steps;
  read.load_paths = model.load_paths;
  build_steps(context);
  check_implausible_values(context);
  check_steps_and_growth(context);
  if (diagnostics.has_errors()) {
    return std::nullopt;
  }
  if (read.growth && model.growth) {
    read.growth->cracks = model.growth->cracks;
  }
  return GrowthCards{std::move(read.growth), std::move(read.spectra), std::move(read.interactions),
                     std::move(read.parameters)};
}

} // namespace spricka::deck
