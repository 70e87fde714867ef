// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/card_marks.hpp"

#include "archive/deck_digest.hpp"
#include "archive/safe_file.hpp"
#include "deck/load.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string_view>

#include <fmt/format.h>

namespace spricka::archive {

namespace {

constexpr std::array<std::string_view, 10> no_matter{"TEST",    "OUTPUT", "CHECK", "RESTART",
                                                     "CONTROL", "TASK",   "SWEEP", "PARAMETER",
                                                     "INCLUDE", "END"};

bool blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

char upper(char c) {
  return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

// One blank between words, none at an equals sign, a new line for a data line; upper case but for
// texts; no comments. A continued header is one line.
std::string canonical(std::string_view text) {
  std::string out;
  bool quoted = false;
  char gap = '\0';
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    // Texts keep their case and blanks.
    if (quoted) {
      out += c;
      quoted = c != '\'';
    } else if (c == '!') {
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (blank(c)) {
      gap = c == '\n' || gap == '\n' ? '\n' : ' ';
    } else if (c == '&' && gap == '\n') {
      gap = ' ';
    } else {
      const bool bare = gap == ' ' && (c == '=' || (!out.empty() && out.back() == '='));
      if (gap != '\0' && !out.empty() && !bare) {
        out += gap;
      }
      gap = '\0';
      quoted = c == '\'';
      out += upper(c);
    }
  }
  return out;
}

// The header without what results are only written in, which none depends on.
std::string header_of_results(const grammar::CardHeader& card, const base::SourceTexts& sources) {
  std::string text(sources.text(card.header));
  for (const grammar::HeaderParameter& p : card.parameters) {
    if (card.name == "DECK" && p.key.starts_with("OUT")) {
      const std::size_t from = p.key_span.begin - card.header.begin;
      const std::size_t to = std::min<std::size_t>(p.span.end - card.header.begin, text.size());
      std::fill(text.begin() + static_cast<std::ptrdiff_t>(from),
                text.begin() + static_cast<std::ptrdiff_t>(to), ' ');
    }
  }
  return text;
}

using Parameters =
    std::map<std::string, std::pair<std::string, double>>; // upper case -> as written

// Parameters whose names stand in a text.
std::string uses(std::string_view text, const Parameters& parameters) {
  std::map<std::string, std::string> found;
  std::string word;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ' ';
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += upper(c);
      continue;
    }
    if (const auto p = parameters.find(word); p != parameters.end()) {
      found[p->second.first] = fmt::format("{} = {}", p->second.first, p->second.second);
    }
    word.clear();
  }
  std::string out;
  for (const auto& [name, value] : found) {
    out += (out.empty() ? "" : ", ") + value;
  }
  return out;
}

// What a card's FILE holds, for those that bring something in.
std::string named_file(const grammar::CardHeader& card, const base::SourceTexts& sources) {
  for (const grammar::HeaderParameter& p : card.parameters) {
    if (p.key == "FILE" && !p.values.empty()) {
      const std::filesystem::path from = sources.file_name(card.name_span.file);
      return (from.parent_path() / p.values.front().text).string();
    }
  }
  return {};
}

// "$LOAD uses F = 80000; it was F = 75000": the first that differs.
std::string of_uses(const CardFingerprint& before, const CardFingerprint& now) {
  return fmt::format("${} uses {}; the earlier run had {}", now.name,
                     now.uses.empty() ? "no parameter" : now.uses,
                     before.uses.empty() ? "none" : before.uses);
}

bool same(const CardFingerprint& a, const CardFingerprint& b) {
  return a.name == b.name && a.hash == b.hash && a.uses == b.uses;
}

} // namespace

std::vector<CardFingerprint> fingerprints_of_result_cards(const std::filesystem::path& deck,
                                                          const model::Model& model) {
  base::SourceTexts sources;
  base::Diagnostics known; // the deck has been read: it has no mistakes
  const deck::DeckFileCards loaded = deck::read_deck_and_includes(deck, sources, known);
  Parameters parameters;
  for (const auto& [name, value] : model.parameters) {
    std::string key = name;
    std::ranges::transform(key, key.begin(), upper);
    parameters[key] = {name, value};
  }
  std::vector<CardFingerprint> marks;
  for (const grammar::CardHeader& card : loaded.cards) {
    if (std::ranges::find(no_matter, card.name) != no_matter.end()) {
      continue;
    }
    CardFingerprint mark;
    mark.name = card.name;
    std::string text = canonical(header_of_results(card, sources)) + '\n';
    if (card.data.valid()) {
      text += canonical(sources.text(card.data));
    }
    if (const std::string file = named_file(card, sources); !file.empty()) {
      // A card that brings a file in changes with what the file holds.
      text += read_imported_file_texts(file);
    }
    mark.hash = hash_bytes(text);
    mark.uses = uses(text, parameters);
    mark.file = std::filesystem::path(sources.file_name(card.name_span.file)).filename().string();
    mark.line = static_cast<int>(sources.locate(card.name_span.file, card.name_span.begin).line);
    mark.span = card.name_span;
    marks.push_back(std::move(mark));
  }
  return marks;
}

std::optional<CardDifference> first_card_difference(const std::vector<CardFingerprint>& before,
                                                    const std::vector<CardFingerprint>& now) {
  std::size_t i = 0;
  while (i < before.size() && i < now.size() && same(before[i], now[i])) {
    ++i;
  }
  if (i == before.size() && i == now.size()) {
    return std::nullopt;
  }
  const auto in = [&](const std::vector<CardFingerprint>& cards, const CardFingerprint& wanted) {
    return std::any_of(cards.begin() + static_cast<std::ptrdiff_t>(std::min(i, cards.size())),
                       cards.end(), [&](const CardFingerprint& c) { return same(c, wanted); });
  };
  const base::SourceSpan end = now.empty() ? base::SourceSpan{} : now.back().span;
  const bool missing =
      i == now.size() || (i < before.size() && in(now, before[i]) == false && in(before, now[i]));
  if (missing) {
    return CardDifference{i < now.size() ? now[i].span : end,
                          fmt::format("a ${} is missing here, line {} of the earlier {}",
                                      before[i].name, before[i].line, before[i].file)};
  }
  if (i == before.size() || in(now, before[i])) {
    return CardDifference{now[i].span, fmt::format("${} was not in the earlier deck", now[i].name)};
  }
  if (before[i].name == now[i].name && before[i].hash == now[i].hash) {
    return CardDifference{now[i].span, of_uses(before[i], now[i])};
  }
  return CardDifference{now[i].span,
                        fmt::format("${} is not what the earlier deck has, ${} in "
                                    "line {} of {}",
                                    now[i].name, before[i].name, before[i].line, before[i].file)};
}

std::vector<CardFingerprint> select_cards(const std::vector<CardFingerprint>& cards,
                                          const std::vector<std::string>& names) {
  std::vector<CardFingerprint> kept;
  std::ranges::copy_if(cards, std::back_inserter(kept), [&](const CardFingerprint& c) {
    return std::ranges::find(names, c.name) != names.end();
  });
  return kept;
}

std::vector<CardFingerprint> exclude_cards(const std::vector<CardFingerprint>& cards,
                                           const std::vector<std::string>& names) {
  std::vector<CardFingerprint> kept;
  std::ranges::copy_if(cards, std::back_inserter(kept), [&](const CardFingerprint& c) {
    return std::ranges::find(names, c.name) == names.end();
  });
  return kept;
}

} // namespace spricka::archive
