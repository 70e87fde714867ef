// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/catalogue.hpp"
#include "grammar/compile.hpp"
#include "grammar/parse.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace spricka::grammar::test_catalogue {
namespace {

bool has_word(std::string_view words, std::string_view word) {
  const auto all = split_words(words);
  return std::find(all.begin(), all.end(), word) != all.end();
}

TEST(Catalogue, HoldsTheWholeLanguage) {
  for (const char* name :
       {"DECK",     "PARAMETER", "INCLUDE", "NET",   "ENDNET",   "IMPORT",   "MESH",    "COOR",
        "ELEMENT",  "NSET",      "ESET",    "FSET",  "MATERIAL", "PROPERTY", "FREEDOM", "MPC",
        "SYMMETRY", "LOAD",      "CONTACT", "RIGID", "CRACK",    "TIPNET",   "VCE",     "STEP",
        "LOADPATH", "SPECTRUM",  "GROW",    "LAW",   "TEST",     "SWEEP",    "CONTROL", "RESTART",
        "TASK",     "OUTPUT",    "CHECK",   "END",   "REQUIRE"}) {
    EXPECT_NE(find_card(name), nullptr) << name;
  }
  EXPECT_EQ(card_catalogue().size(), 38U);
  EXPECT_EQ(find_card("ENDE"), nullptr);
}

TEST(Catalogue, NamesAreUniqueAndDocumented) {
  std::set<std::string_view> cards;
  for (const CardSpec& card : card_catalogue()) {
    EXPECT_TRUE(cards.insert(card.name).second) << card.name;
    EXPECT_FALSE(card.doc.empty()) << card.name;
    EXPECT_FALSE(card.group.empty()) << card.name;
    EXPECT_EQ(card.data == DataLineForm::none, card.data_form.empty()) << card.name;
    std::set<std::string_view> keys;
    for (const KeySpec& key : card.keys) {
      EXPECT_TRUE(keys.insert(key.name).second) << card.name << ' ' << key.name;
      EXPECT_FALSE(key.doc.empty()) << card.name << ' ' << key.name;
      EXPECT_EQ(key.type == KeyType::word || key.type == KeyType::words, !key.words.empty())
          << card.name << ' ' << key.name;
      EXPECT_FALSE(key.required && !key.default_value.empty()) << card.name << ' ' << key.name;
    }
  }
}

TEST(Catalogue, DefaultsAreValuesOfTheirKeys) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  ExpressionScope scope;
  scope.sources = &sources;
  for (const CardSpec& card : card_catalogue()) {
    for (const KeySpec& key : card.keys) {
      if (key.default_value.empty()) {
        continue;
      }
      if (key.type == KeyType::word) {
        EXPECT_TRUE(has_word(key.words, key.default_value)) << card.name << ' ' << key.name;
        continue;
      }
      const auto file = sources.add_text("default", std::string(key.default_value));
      const auto parsed = parse_expression(
          sources, {file, 0, static_cast<std::uint32_t>(key.default_value.size())}, diagnostics);
      ASSERT_TRUE(parsed) << card.name << ' ' << key.name;
      const auto value = evaluate_constant(*parsed, scope, diagnostics);
      ASSERT_TRUE(value) << card.name << ' ' << key.name;
      EXPECT_TRUE(key.range.contains(*value)) << card.name << ' ' << key.name;
    }
  }
}

TEST(Catalogue, ClausesSpeakOfKeysThatExist) {
  for (const CardSpec& card : card_catalogue()) {
    for (const KeyPresenceRule& clause : card.when) {
      const KeySpec* key = card.find(clause.key);
      ASSERT_NE(key, nullptr) << card.name << ' ' << clause.key;
      for (const auto& word : split_words(clause.words)) {
        EXPECT_TRUE(has_word(key->words, word)) << card.name << ' ' << word;
      }
      for (const auto& name : split_words(clause.needs)) {
        EXPECT_NE(card.find(name), nullptr) << card.name << ' ' << name;
      }
      for (const auto& name : split_words(clause.forbids)) {
        EXPECT_NE(card.find(name), nullptr) << card.name << ' ' << name;
      }
    }
    for (const auto& name : split_words(card.exclusive)) {
      EXPECT_NE(card.find(name), nullptr) << card.name << ' ' << name;
    }
    for (const KeySpec& key : card.keys) {
      for (const auto& word : split_words(key.later)) {
        EXPECT_TRUE(word == "*" || word == ">0" || has_word(key.words, word))
            << card.name << ' ' << key.name << ' ' << word;
      }
    }
  }
}

TEST(Catalogue, RangesSpeak) {
  EXPECT_EQ((ValueLimits{0.0, k_unbounded, true, false}.text()), ">0");
  EXPECT_EQ((ValueLimits{-1.0, 0.5, true, true}.text()), "-1<..<0.5");
  EXPECT_TRUE((ValueLimits{-1.0, 0.5, true, true}.contains(0.3)));
  EXPECT_FALSE((ValueLimits{-1.0, 0.5, true, true}.contains(0.5)));
  EXPECT_TRUE((ValueLimits{2.0, 3.0, false, false}.contains(2.0)));
}

} // namespace
} // namespace spricka::grammar::test_catalogue
