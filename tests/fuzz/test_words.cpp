// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus.hpp"
#include "words.hpp"

#include <algorithm>

#include <gtest/gtest.h>

/// No unknown word is ever passed over: each word of the language in each sound deck, misspelt, is
/// refused where it stands.
namespace spricka::fuzz::test_words {
namespace {

std::vector<std::string> sound_decks() {
  std::vector<std::string> names;
  for (const Deck& deck : corpus()) {
    if (deck.sound && !deck.imports) {
      names.push_back(deck.name);
    }
  }
  return names;
}

class Words : public testing::TestWithParam<std::string> {};

TEST_P(Words, MisspeltAreRefusedWhereTheyStand) {
  const Reader reader;
  const auto deck = std::find_if(corpus().begin(), corpus().end(),
                                 [](const Deck& d) { return d.name == GetParam(); });
  const std::vector<Word> words = words_of(deck->text);
  EXPECT_GE(words.size(), 10U);
  for (const Word& word : words) {
    const std::string wrong =
        misspelt(std::string_view(deck->text).substr(word.begin, word.length));
    std::string text = deck->text;
    text.replace(word.begin, word.length, wrong);
    const Outcome outcome = reader.read(text);
    EXPECT_FALSE(outcome.model) << "accepted: " << wrong;
    const auto& all = outcome.diagnostics.messages();
    const bool pointed = std::any_of(all.begin(), all.end(), [&](const base::Diagnostic& d) {
      // the place of a card is that of its $
      const bool card = word.begin > 0 && text[word.begin - 1] == '$';
      return d.severity == base::Severity::error && d.span.file == 0 &&
             d.span.begin == word.begin - (card ? 1 : 0);
    });
    EXPECT_TRUE(pointed) << wrong << ":\n" << outcome.messages();
    if (wrong != "ENDQJ" && wrong != "ENQJD") { // the frame of the deck is another matter
      EXPECT_LE(outcome.diagnostics.error_count(), 3U) << wrong << ":\n" << outcome.messages();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Words, testing::ValuesIn(sound_decks()),
                         [](const auto& deck) { return deck.param; });

TEST(Words, AreFound) {
  const std::string text = "$MATERIAL NAME=M E=1 ! NU=0.3\n$STEP NAME=S\n LOAD C 1\n"
                           "$OUTPUT FILE='K=1' & FORMAT=CSV\n  & EVERY=END\n K C\n";
  std::vector<std::string> found;
  for (const Word& word : words_of(text)) {
    found.push_back(text.substr(word.begin, word.length));
  }
  EXPECT_EQ(found,
            (std::vector<std::string>{"MATERIAL", "NAME", "E", "STEP", "NAME", "LOAD", "OUTPUT",
                                      "FILE", "FORMAT", "CSV", "EVERY", "END", "K"}));
}

} // namespace
} // namespace spricka::fuzz::test_words
