// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/source.hpp"
#include "grammar/ast.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <boost/range/adaptor/filtered.hpp>

/// A deck as the texts of its cards, to be changed card by card and written out as a deck again:
/// for variants of a deck that the program makes itself. Nothing is looked up or evaluated here.
namespace spricka::deck {

/// One card: its keys and data lines as the deck writes them.
struct DeckCard {
  std::string name;                                      ///< upper case, without the $
  std::string net;                                       ///< the open net, upper case; or empty
  std::vector<std::pair<std::string, std::string>> keys; ///< key in upper case, value as written
  std::string data;         ///< data lines with their comments; empty or ended by a newline
  grammar::CardHeader card; ///< as it was read; empty for a new one

  /// The value of a key as the deck writes it; null without the key, which is in upper case.
  [[nodiscard]] const std::string* find(std::string_view key) const;
  /// Whether the card gives a key, which is in upper case.
  [[nodiscard]] bool has_key(std::string_view key) const { return find(key) != nullptr; }
  /// The value of a key in upper case, quotes taken off; empty without it.
  [[nodiscard]] std::string word_value(std::string_view key) const;
  /// Gives a key a value, in its place or behind the others.
  void set_key(std::string_view key, std::string value);
  /// Takes a key and its value off the card, if it has it.
  void erase(std::string_view key);
};

using DeckCardList = std::vector<DeckCard>;

/// The cards of a deck with those of its includes in their places; $INCLUDE itself is left out.
/// Names of files are made absolute. Mistakes of syntax go to `diagnostics`; with them, or where
/// an include is missing, the result is empty. Throws std::system_error as load_deck does.
std::optional<DeckCardList> read_deck_card_list(const std::filesystem::path& deck,
                                                base::SourceTexts& sources,
                                                base::Diagnostics& diagnostics);

/// The deck in canonical layout, to stand in `folder`: names of files that cards read count from
/// there. `head` are comment lines without their !, in front of the first card.
std::string format_deck_card_list(DeckCardList text, const std::filesystem::path& folder,
                                  const std::vector<std::string>& head = {});

/// A new card; `data` is empty or ended by a newline.
DeckCard make_card(std::string name, std::vector<std::pair<std::string, std::string>> keys = {},
                   std::string data = {});

/// Puts a card in front of $END, or at the end.
void append_card(DeckCardList& text, DeckCard card);

/// Gives a parameter of the deck, by its name in upper case, another value as a deck writes it;
/// false: the deck does not define it.
bool replace_parameter(DeckCardList& text, std::string_view name, std::string_view value);

/// The cards of a name, in upper case, of a text that may be changed or not.
template <class Text> auto cards_named(Text& text, std::string_view name) {
  return text |
         boost::adaptors::filtered([name](const DeckCard& card) { return card.name == name; });
}

/// The first card of a name whose key has the value `word` as word_value() gives it, null without
/// one; the card may be changed where the text may.
template <class Text>
auto find_card_with_key_value(Text& text, std::string_view name, std::string_view key,
                              const std::string& word) -> decltype(text.data()) {
  for (auto& card : text) {
    if (card.name == name && card.word_value(key) == word) {
      return &card;
    }
  }
  return nullptr;
}

} // namespace spricka::deck
