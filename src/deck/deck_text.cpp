// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/deck_text.hpp"

#include "deck/load.hpp"
#include "grammar/format.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"

#include <algorithm>
#include <array>
#include <system_error>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_widest_header = 100;

std::string without_quotes(std::string_view text) {
  const bool quoted = text.size() > 1 && text.front() == '\'' && text.back() == '\'';
  return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

// Cards whose FILE is read; that of $OUTPUT is written.
bool reads_file(std::string_view card) {
  constexpr std::array names{"IMPORT", "SPECTRUM", "TEST"};
  return std::ranges::find(names, card) != names.end();
}

constexpr std::array file_keys{"FILE", "REFERENCE"};

// Texts only: a REFERENCE may be a name as well.
bool is_text(std::string_view value) {
  return value.starts_with('\'');
}

// Names of files that the card reads, changed by `change`.
template <class Change> void change_file_names(DeckCard& card, const Change& change) {
  for (const char* key : file_keys) {
    const std::string* value = reads_file(card.name) ? card.find(key) : nullptr;
    if (value != nullptr && is_text(*value)) {
      const fs::path file = change(fs::path(without_quotes(*value)));
      card.set_key(key, "'" + file.string() + "'");
    }
  }
}

void make_absolute(DeckCard& card, const fs::path& folder) {
  change_file_names(
      card, [&](const fs::path& file) { return fs::absolute(folder / file).lexically_normal(); });
}

void make_relative(DeckCard& card, const fs::path& folder) {
  change_file_names(card, [&](const fs::path& file) {
    const fs::path shorter = file.lexically_relative(fs::absolute(folder).lexically_normal());
    return shorter.empty() ? file : shorter;
  });
}

DeckCard text_of(const grammar::CardHeader& card, const base::SourceTexts& sources) {
  DeckCard text;
  text.name = card.name;
  text.card = card;
  for (const grammar::HeaderParameter& parameter : card.parameters) {
    std::string value(sources.text(parameter.span));
    std::ranges::replace(value, '\n', ' '); // of a header that goes on in the next line
    text.keys.emplace_back(parameter.key, std::move(value));
  }
  if (card.data.valid()) {
    text.data = sources.text(card.data);
    if (!text.data.empty() && text.data.back() != '\n') {
      text.data += '\n';
    }
  }
  return text;
}

std::string header_of(const DeckCard& card) {
  std::string text = "$" + card.name;
  std::size_t width = text.size();
  for (const auto& [key, value] : card.keys) {
    const std::string next = fmt::format("{}={}", key, value);
    if (width + 1 + next.size() > k_widest_header) {
      text += "\n  &";
      width = 3;
    }
    text += " " + next;
    width += 1 + next.size();
  }
  return text + "\n";
}

} // namespace

const std::string* DeckCard::find(std::string_view key) const {
  const auto found = std::ranges::find(keys, key, &std::pair<std::string, std::string>::first);
  return found == keys.end() ? nullptr : &found->second;
}

std::string DeckCard::word_value(std::string_view key) const {
  const std::string* value = find(key);
  return value == nullptr ? std::string() : grammar::to_upper(without_quotes(*value));
}

void DeckCard::set_key(std::string_view key, std::string value) {
  const auto found = std::ranges::find(keys, key, &std::pair<std::string, std::string>::first);
  if (found == keys.end()) {
    keys.emplace_back(key, std::move(value));
  } else {
    found->second = std::move(value);
  }
}

void DeckCard::erase(std::string_view key) {
  std::erase_if(keys, [&](const auto& entry) { return entry.first == key; });
}

std::optional<DeckCardList> read_deck_card_list(const fs::path& deck, base::SourceTexts& sources,
                                                base::Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.error_count();
  const DeckFileCards loaded = read_deck_and_includes(deck, sources, diagnostics);
  if (loaded.incomplete || diagnostics.error_count() > before) {
    return std::nullopt;
  }
  DeckCardList text;
  std::string net;
  for (const grammar::CardHeader& card : loaded.cards) {
    if (card.name == "INCLUDE") {
      continue;
    }
    DeckCard next = text_of(card, sources);
    if (card.name == "ENDNET") {
      net.clear();
    }
    next.net = net;
    if (card.name == "NET") {
      net = next.word_value("NAME");
    }
    make_absolute(next, fs::path(sources.file_name(card.header.file)).parent_path());
    text.push_back(std::move(next));
  }
  return text;
}

std::string format_deck_card_list(DeckCardList text, const fs::path& folder,
                                  const std::vector<std::string>& head) {
  std::string out;
  for (const std::string& line : head) {
    out += line.empty() ? "!\n" : "! " + line + "\n";
  }
  for (DeckCard& card : text) {
    make_relative(card, folder);
    out += header_of(card) + card.data;
  }
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const std::int32_t file = sources.add_text("deck", out);
  return grammar::format_deck(sources, file, diagnostics).value_or(out);
}

DeckCard make_card(std::string name, std::vector<std::pair<std::string, std::string>> keys,
                   std::string data) {
  return {.name = std::move(name),
          .net = {},
          .keys = std::move(keys),
          .data = std::move(data),
          .card = {}};
}

void append_card(DeckCardList& text, DeckCard card) {
  const auto end = std::ranges::find(text, "END", &DeckCard::name);
  text.insert(end, std::move(card));
}

bool replace_parameter(DeckCardList& text, std::string_view name, std::string_view value) {
  for (DeckCard& card : cards_named(text, "PARAMETER")) {
    base::SourceTexts sources;
    base::Diagnostics read_before;
    const std::int32_t file = sources.add_text("parameters", card.data);
    for (const grammar::ParameterAssignment& line : grammar::parse_parameter_assignments(
             sources, {file, 0, static_cast<std::uint32_t>(card.data.size())}, read_before)) {
      if (line.name == name) {
        const base::SourceSpan old = line.value.span;
        card.data.replace(old.begin, old.end - old.begin, value);
        return true;
      }
    }
  }
  return false;
}

} // namespace spricka::deck
