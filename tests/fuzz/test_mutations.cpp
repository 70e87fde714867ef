// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus.hpp"
#include "grammar/format.hpp"
#include "mutator.hpp"
#include "tests/places.hpp"

#include <cstdlib>
#include <cstring>

#include <gtest/gtest.h>

/// Whatever the text, reading it ends soon, in a model or in messages that can be shown.
namespace spricka::fuzz::test_mutations {
namespace {

constexpr std::size_t k_shards = 4;

// SPRICKA_SEED looks elsewhere than the daily run does.
std::uint64_t seed() {
  const char* given = std::getenv("SPRICKA_SEED");
  return given == nullptr ? 20'261 : std::strtoull(given, nullptr, 10);
}

std::size_t readings() {
  return (!test::full_size() ? 1'500 : 100'000) / k_shards;
}

// Well-formed UTF-8 without control characters but for tabs and ends of lines.
bool can_be_shown(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c < 0x20U && c != '\n' && c != '\t') {
      return false;
    }
    const std::size_t length = c < 0x80U ? 1 : c < 0xC2U ? 0 : c < 0xE0U ? 2 : c < 0xF0U ? 3 : 4;
    if (length == 0 || i + length > text.size()) {
      return false;
    }
    for (std::size_t k = 1; k < length; ++k) {
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0U) != 0x80U) {
        return false;
      }
    }
    i += length;
  }
  return true;
}

void check(const Outcome& outcome) {
  EXPECT_EQ(outcome.model.has_value(), !outcome.diagnostics.has_errors());
  for (const base::Diagnostic& d : outcome.diagnostics.messages()) {
    ASSERT_TRUE(d.span.valid()) << d.text;
    ASSERT_LT(static_cast<std::size_t>(d.span.file), outcome.sources.count()) << d.text;
    ASSERT_LE(d.span.begin, d.span.end) << d.text;
    ASSERT_LE(d.span.end, outcome.sources.text(d.span.file).size()) << d.text;
  }
  const std::string messages = outcome.messages();
  EXPECT_TRUE(can_be_shown(messages)) << messages;
  for (const char* inner : {"N7spricka", "N5boost", "spirit", "std::"}) {
    EXPECT_EQ(messages.find(inner), std::string::npos) << messages;
  }
}

std::optional<std::string> formatted(const std::string& text) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  return grammar::format_deck(sources, sources.add_text("deck", text), diagnostics);
}

// The formatter takes any text, and a second time changes nothing.
void check_format(const std::string& text) {
  const auto once = formatted(text);
  if (once) {
    const auto twice = formatted(*once);
    EXPECT_TRUE(twice && *twice == *once);
  }
}

class Mutations : public testing::TestWithParam<std::size_t> {};

TEST_P(Mutations, AreReadOrRefused) {
  Mutator mutator(seed() * k_shards + GetParam());
  const Reader reader;
  const std::vector<Deck>& decks = corpus();
  std::size_t accepted = 0;
  for (std::size_t i = 0; i < readings(); ++i) {
    const Deck* deck = &decks[mutator.below(decks.size())];
    while (deck->imports && mutator.below(5) != 0) {
      deck = &decks[mutator.below(decks.size())];
    }
    const std::string text = mutator.mutate(deck->text, decks[mutator.below(decks.size())].text);
    SCOPED_TRACE(deck->name + ", reading " + std::to_string(i));
    try {
      const Outcome outcome = reader.read(text);
      check(outcome);
      check_format(text);
      accepted += outcome.model ? 1 : 0;
    } catch (const std::exception& trouble) {
      ADD_FAILURE() << trouble.what();
    }
    if (HasFailure()) {
      FAIL() << "the deck that did it:\n" << text.substr(0, 4000);
    }
  }
  RecordProperty("accepted", static_cast<int>(accepted));
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Mutations, testing::Range<std::size_t>(0, k_shards));

} // namespace
} // namespace spricka::fuzz::test_mutations
