// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/name_uses.hpp"

#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace spricka::program {

namespace {

// Words of a text, upper case, but for those in comments and quotes.
std::set<std::string> words_of(std::string_view text) {
  std::set<std::string> words;
  std::size_t i = 0;
  while (i < text.size()) {
    if (text[i] == '!') {
      i = std::min(text.find('\n', i), text.size());
    } else if (text[i] == '\'') {
      const std::size_t close = text.find('\'', i + 1);
      i = close == std::string_view::npos ? text.size() : close + 1;
    } else if (grammar::is_name_char(text[i])) {
      const std::size_t begin = i;
      while (i < text.size() && grammar::is_name_char(text[i])) {
        ++i;
      }
      words.insert(grammar::to_upper(text.substr(begin, i - begin)));
    } else {
      ++i;
    }
  }
  return words;
}

} // namespace

bool is_count_key(std::string_view key) {
  constexpr std::array keys{"NX", "NY", "NZ", "NR", "NT", "BIAS"};
  return std::ranges::find(keys, key) != keys.end();
}

std::map<std::string, std::set<std::string>>
parameter_dependencies(const deck::DeckText& text, const base::SourceTexts& sources) {
  std::map<std::string, std::set<std::string>> made_of;
  base::Diagnostics ignored;
  for (const deck::DeckCard& card : cards_named(text, "PARAMETER")) {
    for (const grammar::Assignment& line :
         grammar::parse_assignments(sources, card.card.data, ignored)) {
      std::set<std::string>& all = made_of[line.name];
      for (const std::string& word : words_of(sources.text(line.value.span))) {
        const auto known = made_of.find(word); // defined before, with all of its own
        if (known != made_of.end() && word != line.name) {
          all.insert(word);
          all.insert(known->second.begin(), known->second.end());
        }
      }
    }
  }
  return made_of;
}

std::map<std::string, ParameterUse> parameter_uses(const deck::DeckText& text,
                                                   const base::SourceTexts& sources) {
  const std::map<std::string, std::set<std::string>> made_of =
      parameter_dependencies(text, sources);
  std::map<std::string, ParameterUse> uses;
  for (const auto& entry : made_of) {
    uses[entry.first];
  }
  // Counts of a card number `count`, or any other use.
  const auto note = [&](const std::string& value, std::optional<std::size_t> count) {
    const auto note_use = [&](ParameterUse& use) {
      if (count) {
        use.counts.insert(*count);
      } else {
        use.elsewhere = true;
      }
    };
    for (const std::string& word : words_of(value)) {
      if (const auto found = made_of.find(word); found != made_of.end()) {
        note_use(uses[word]);
        for (const std::string& ingredient : found->second) {
          note_use(uses[ingredient]);
        }
      }
    }
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const deck::DeckCard& card = text[i];
    if (card.name == "PARAMETER") {
      continue;
    }
    for (const auto& [key, value] : card.keys) {
      if (value.find('(') != std::string::npos) { // else a name of something
        note(value, card.name == "MESH" && is_count_key(key) ? std::optional(i) : std::nullopt);
      }
    }
    note(card.data, std::nullopt);
  }
  return uses;
}

} // namespace spricka::program
