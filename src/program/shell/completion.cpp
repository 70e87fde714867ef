// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/completion.hpp"

#include "grammar/catalogue.hpp"
#include "grammar/lexeme.hpp"
#include "model/model.hpp"
#include "program/shell/actions.hpp"
#include "program/shell/command_table.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/plots.hpp"
#include "program/shell/typed_words.hpp"

#include <algorithm>

namespace spricka::program {

namespace {

using Words = std::vector<std::string>;

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return out;
}

Words beginning_with(const Words& names, std::string_view typed, bool keep_case) {
  const std::size_t letter = typed.starts_with('$') ? 1 : 0;
  const bool small = typed.size() > letter && typed[letter] >= 'a' && typed[letter] <= 'z';
  Words out;
  for (const std::string& name : names) {
    if (name.size() >= typed.size() && same_word(name.substr(0, typed.size()), typed)) {
      out.push_back(small && !keep_case ? lower(name) : name);
    }
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void append(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
}

// The first word of a line.
Words complete_first(const ShellSession& session, std::string_view typed) {
  if (typed.starts_with('$')) {
    Words cards;
    for (const deck::DeckCard& card : *session.changes().text) {
      cards.push_back("$" + card.name);
    }
    return beginning_with(cards, typed, false);
  }
  Words words = beginning_with(command_words(), typed, true);
  if (!typed.empty()) {
    append(words, beginning_with(candidate_argument_names('v', session.model()), typed, true));
    Words results;
    for (const grammar::ResultQuantity& quantity : grammar::result_quantities()) {
      results.emplace_back(quantity.name);
    }
    append(words, beginning_with(results, typed, false));
  }
  return words;
}

// A key of a card's header, or a name behind NAME=.
Words complete_key(const ShellSession& session, std::string_view before, std::string_view typed) {
  const std::string name = grammar::to_upper(split_shell_words(before).front().substr(1));
  const grammar::CardSpec* spec = grammar::find_card(name);
  Words words;
  if (before.ends_with('=')) {
    const bool names = grammar::to_upper(before).ends_with("NAME=");
    for (const deck::DeckCard& card : *session.changes().text) {
      if (names && card.name == name) {
        words.push_back(card.word_value("NAME"));
      }
    }
  } else if (spec != nullptr) {
    for (const grammar::KeySpec& key : spec->keys) {
      words.push_back(std::string(key.name) + "=");
    }
  }
  return beginning_with(words, typed, false);
}

// An argument of a result.
Words complete_argument(const ShellSession& session, std::string_view before,
                        std::string_view typed) {
  const std::string name = grammar::to_upper(strip_comment(before.substr(0, before.find('('))));
  const grammar::ResultQuantity* is = grammar::find_result_quantity(name);
  std::string letters(is == nullptr ? std::string_view() : is->arguments);
  const std::string_view without = // and the coordinates that places do not have
      std::string_view("xyz").substr(static_cast<std::size_t>(session.model().mesh.dim));
  std::erase_if(letters, [&](char c) { return c == '?' || without.find(c) != without.npos; });
  const auto at = static_cast<std::size_t>(std::ranges::count(before, ','));
  return at < letters.size()
             ? beginning_with(candidate_argument_names(letters[at], session.model()), typed, false)
             : Words();
}

Words candidates(const ShellSession& session, const Words& words, char letter) {
  const model::Model& model = session.model();
  switch (letter) {
  case 'w':
    return command_words();
  case 'k':
    return picture_kinds();
  case 'q': {
    Words names = topics_of_list_command();
    for (const deck::DeckCard& card : *session.changes().text) {
      names.push_back(card.name);
    }
    return names;
  }
  case 't': // behind what is listed
    return same_word(words.back(), "K")          ? candidate_argument_names('c', model)
           : same_word(words.back(), "pressure") ? candidate_argument_names('p', model)
                                                 : Words();
  case 's': {
    Words names = candidate_argument_names('s', model);
    names.erase(names.begin()); // NOW
    return names;
  }
  case 'M': {
    Words names = candidate_argument_names('l', model);
    append(names, candidate_argument_names('o', model));
    return names;
  }
  default:
    return candidate_argument_names(letter, model);
  }
}

} // namespace

std::vector<std::string> complete_shell_line(const ShellSession& session, std::string_view line,
                                             std::size_t begin) {
  const std::string_view typed = line.substr(std::min(begin, line.size()));
  const std::string_view before = line.substr(0, std::min(begin, line.size()));
  const Words words = split_shell_words(before);
  if (words.empty()) {
    return complete_first(session, typed);
  }
  const ShellLineForm form = classify_shell_line(before);
  if (form == ShellLineForm::card) {
    return complete_key(session, before, typed);
  }
  if (form == ShellLineForm::result) {
    return complete_argument(session, before, typed);
  }
  const auto command = std::ranges::find_if(
      shell_commands(), [&](const ShellCommand& c) { return same_word(c.word, words.front()); });
  const std::size_t at = words.size() - 1;
  if (command == shell_commands().end() || at >= command->letters.size()) {
    return {};
  }
  const char letter = command->letters[at];
  return beginning_with(candidates(session, words, letter), typed,
                        letter == 'w' || letter == 'k' || letter == 'q');
}

} // namespace spricka::program
