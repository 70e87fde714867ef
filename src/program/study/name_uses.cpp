// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/name_uses.hpp"

#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"
#include "program/study/deck_edits.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace spricka::program {

namespace {

// Names of a text, upper case.
std::set<std::string> names_in(std::string_view text) {
  std::set<std::string> names;
  rename_in_text(
      text, [&](std::string_view name) { return *names.insert(grammar::to_upper(name)).first; });
  return names;
}

} // namespace

bool is_element_count_key(std::string_view key) {
  constexpr std::array keys{"NX", "NY", "NZ", "NR", "NT", "BIAS"};
  return std::ranges::find(keys, key) != keys.end();
}

std::map<std::string, std::set<std::string>>
parameter_dependencies(const deck::DeckCardList& text, const base::SourceTexts& sources) {
  std::map<std::string, std::set<std::string>> made_of;
  base::Diagnostics ignored;
  for (const deck::DeckCard& card : cards_named(text, "PARAMETER")) {
    for (const grammar::Assignment& line :
         grammar::parse_assignments(sources, card.card.data, ignored)) {
      std::set<std::string>& all = made_of[line.name];
      for (const std::string& word : names_in(sources.text(line.value.span))) {
        const auto known = made_of.find(word); // defined before, with all of its own
        if (known != made_of.end() && word != line.name) {
          all.insert(known->second.begin(), known->second.end());
        }
      }
      all.insert(line.name);
    }
  }
  return made_of;
}

std::map<std::string, ParameterUse> find_parameter_uses(const deck::DeckCardList& text,
                                                        const base::SourceTexts& sources) {
  const std::map<std::string, std::set<std::string>> made_of =
      parameter_dependencies(text, sources);
  const std::set<std::string> none;
  std::map<std::string, ParameterUse> uses;
  for (const auto& entry : made_of) {
    uses[entry.first];
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    const deck::DeckCard& card = text[i];
    const auto note = [&](const std::string& value, bool counts) {
      for (const std::string& word : names_in(value)) {
        const auto found = made_of.find(word);
        for (const std::string& name : found == made_of.end() ? none : found->second) {
          uses[name].elsewhere = uses[name].elsewhere || !counts;
          if (counts) {
            uses[name].counts.insert(i);
          }
        }
      }
    };
    if (card.name == "PARAMETER") {
      continue;
    }
    for (const auto& [key, value] : card.keys) {
      if (value.find('(') != std::string::npos) { // else a name of something
        note(value, card.name == "MESH" && is_element_count_key(key));
      }
    }
    note(card.data, false);
  }
  return uses;
}

} // namespace spricka::program
