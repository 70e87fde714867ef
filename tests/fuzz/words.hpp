// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace spricka::fuzz {

/// A word of the language in a deck: the name of a card, a key, a word that a key takes, or a word
/// that a data line begins with or holds.
struct Word {
  std::size_t begin = 0;
  std::size_t length = 0;
};

/// The words of the language in a text, in order. Comments, texts in quotes, names and numbers are
/// left out. Written without the program's own parser.
std::vector<Word> words_of(std::string_view text);

/// The word with one letter changed so that it is no word of the language.
std::string misspelt(std::string_view word);

} // namespace spricka::fuzz
