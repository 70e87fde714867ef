// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/messages.hpp"
#include "grammar/compile.hpp"
#include "grammar/editor.hpp"
#include "grammar/field_words.hpp"
#include "grammar/format.hpp"
#include "grammar/help.hpp"
#include "grammar/parse.hpp"
#include "grammar/phrases.hpp"
#include "grammar/wrap.hpp"
#include "tests/places.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace spricka::grammar::test_help {
namespace {

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(Help, EveryCardHasAnExampleInCanonicalLayout) {
  for (const CardSpec& card : card_catalogue()) {
    ASSERT_FALSE(card.example.empty()) << card.name;
    EXPECT_TRUE(has(std::string(card.example), "$" + std::string(card.name))) << card.name;
    base::SourceTexts sources;
    base::Diagnostics diagnostics;
    const auto file = sources.add_text("example", std::string(card.example));
    EXPECT_EQ(format_deck(sources, file, diagnostics), card.example)
        << base::format_messages(sources, diagnostics);
  }
}

TEST(Help, ShowsEveryKeyAndStaysInItsWidth) {
  for (const std::size_t width : {60U, 80U, 100U}) {
    for (const CardSpec& card : card_catalogue()) {
      const std::string text = card_help(card, width);
      for (const KeySpec& key : card.keys) {
        EXPECT_TRUE(has(text, "\n  " + std::string(key.name) + " ")) << card.name << key.name;
      }
      const std::string before = text.substr(0, text.find("\nExample:"));
      for (std::size_t at = 0; at < before.size();) {
        const std::size_t end = std::min(before.find('\n', at), before.size());
        EXPECT_LE(end - at, std::max<std::size_t>(width, 86)) << before.substr(at, end - at);
        at = end + 1;
      }
    }
  }
}

TEST(Help, EveryCardStandsInAGroupOfTheOverview) {
  const std::string text = card_list_help(80);
  for (const CardSpec& card : card_catalogue()) {
    EXPECT_FALSE(card_group_purpose(card.group).empty()) << card.group;
    EXPECT_TRUE(has(text, "  $" + std::string(card.name) + " ")) << card.name;
  }
}

TEST(Help, PutsClausesIntoSentences) {
  const auto rigid = card_rule_sentences(*find_card("RIGID"));
  ASSERT_EQ(rigid.size(), 6U);
  EXPECT_EQ(rigid[0], "SHAPE=LINE needs X0, Y0, X1 and Y1 and excludes R, R1, Z0 and Z1.");
  const auto contact = card_rule_sentences(*find_card("CONTACT"));
  ASSERT_FALSE(contact.empty());
  EXPECT_EQ(contact[0], "At most one of INTERFERENCE, DIAMETRAL and GAP may be given.");
}

TEST(Help, WritesResultsAsCalls) {
  EXPECT_EQ(result_call_syntax(*find_result_quantity("K1")),
            "K1(crack[.tip], step [, a [, angle]])");
  EXPECT_EQ(result_call_syntax(*find_result_quantity("U.X.AT")), "U.X.AT(x, y [, z], step [, a])");
  EXPECT_EQ(result_call_syntax(*find_result_quantity("CPRESS.AT")),
            "CPRESS.AT(contact, step, theta [, a])");
  EXPECT_EQ(result_call_syntax(*find_result_quantity("LIFE")), "LIFE()");
}

// The documented form of every function compiles, with numbers for its letters.
TEST(Help, FunctionsAreWrittenAsTheyAreRead) {
  for (const ExpressionFunctionText& function : expression_functions()) {
    std::string call = std::regex_replace(std::string(function.form), std::regex(", \\.\\."), "");
    call = std::regex_replace(call, std::regex("\\b[xyab]\\b"), "0.5");
    base::SourceTexts sources;
    base::Diagnostics diagnostics;
    ExpressionScope scope;
    scope.sources = &sources;
    const auto file = sources.add_text("call", call);
    const auto parsed =
        parse_expression(sources, {file, 0, static_cast<std::uint32_t>(call.size())}, diagnostics);
    ASSERT_TRUE(parsed) << call;
    EXPECT_TRUE(evaluate_constant(*parsed, scope, diagnostics)) << call;
    EXPECT_TRUE(is_reserved_name(function.name));
  }
}

// What the group of a pattern matches, wherever it does in a text.
std::vector<std::string> found_in(std::string_view text, const char* pattern) {
  const std::regex regex(pattern);
  const std::string words(text);
  std::vector<std::string> found;
  for (std::sregex_iterator it(words.begin(), words.end(), regex), end; it != end; ++it) {
    found.push_back((*it)[1]);
  }
  return found;
}

TEST(FieldWords, LeadToCardsKeysResultsAndPages) {
  const std::filesystem::path manual = test::source_folder() + "/manual";
  for (const DamageToleranceTerm& word : damage_tolerance_terms()) {
    const auto topics = split_words(word.topics);
    const auto pages = split_words(word.pages);
    EXPECT_FALSE(topics.empty()) << word.word;
    EXPECT_FALSE(pages.empty()) << word.word;
    for (const std::string& topic : topics) {
      EXPECT_TRUE(find_card(topic) != nullptr || find_result_quantity(topic) != nullptr ||
                  !language_word_help(topic, 80).empty())
          << word.word << ": " << topic;
    }
    for (const std::string& page : pages) {
      EXPECT_TRUE(std::filesystem::exists(manual / (page + ".md"))) << word.word << ": " << page;
    }
    for (const std::string& card : found_in(word.text, "\\$([A-Z]+)")) {
      EXPECT_NE(find_card(card), nullptr) << word.word << ": " << card;
    }
    for (const std::string& key : found_in(word.text, "\\b([A-Z][A-Z0-9]*)=")) {
      EXPECT_FALSE(language_word_help(key, 80).empty()) << word.word << ": " << key;
    }
  }
}

TEST(FieldWords, HaveOneEntryEachAndARowInTheGlossary) {
  std::ifstream in(test::source_folder() + "/manual/glossary.md");
  const std::string glossary{std::istreambuf_iterator<char>(in), {}};
  for (const DamageToleranceTerm& word : damage_tolerance_terms()) {
    for (const std::string_view name : term_synonyms(word)) {
      EXPECT_EQ(find_damage_tolerance_term(name), &word) << name;
    }
    EXPECT_TRUE(has(glossary, "\n| " + std::string(word.word))) << word.word;
  }
}

TEST(FieldWords, AreFoundHoweverTheyAreWritten) {
  const DamageToleranceTerm* bushing = find_damage_tolerance_term("bushing");
  ASSERT_NE(bushing, nullptr);
  for (const char* name : {"Bushing", "BUSHINGS", "bush", "sleeves"}) {
    EXPECT_EQ(find_damage_tolerance_term(name), bushing) << name;
  }
  EXPECT_EQ(find_damage_tolerance_term("bearing bypass"),
            find_damage_tolerance_term("bearing-bypass"));
  EXPECT_EQ(find_damage_tolerance_term("link_up"), find_damage_tolerance_term("link-up"));
  EXPECT_EQ(find_damage_tolerance_term(""), nullptr);
  EXPECT_EQ(find_damage_tolerance_term("s"), nullptr);
  EXPECT_TRUE(damage_tolerance_help("contact", 80).empty());
}

TEST(FieldWords, AreExplainedWithinTheWidth) {
  for (const DamageToleranceTerm& word : damage_tolerance_terms()) {
    const std::string text = damage_tolerance_help(word.word, 80);
    EXPECT_TRUE(text.starts_with(word.word)) << text;
    EXPECT_TRUE(has(text, "More: spricka help ")) << text;
    EXPECT_TRUE(has(text, "Manual: ")) << text;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      EXPECT_LE(end - at, 80U) << text.substr(at, end - at);
      at = end + 1;
    }
    EXPECT_TRUE(has(list_damage_tolerance_terms(80), "\n  " + std::string(word.word) + " "))
        << word.word;
  }
}

TEST(Wrap, BreaksAtBlanksAndBars) {
  EXPECT_EQ(wrap_text("one two three", 7), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrap_text("A|BB|CCC", 5), (std::vector<std::string>{"A|BB|", "CCC"}));
  EXPECT_EQ(wrap_text("unbreakable", 4), (std::vector<std::string>{"unbreakable"}));
  EXPECT_TRUE(wrap_text("", 4).empty());
}

TEST(Schema, HoldsTheWholeCatalogue) {
  const auto schema = nlohmann::json::parse(card_catalogue_json());
  ASSERT_EQ(schema["cards"].size(), card_catalogue().size());
  for (std::size_t i = 0; i < card_catalogue().size(); ++i) {
    const CardSpec& card = card_catalogue()[i];
    const auto& json = schema["cards"][i];
    EXPECT_EQ(json["name"], card.name);
    EXPECT_EQ(json["example"], card.example);
    ASSERT_EQ(json["keys"].size(), card.keys.size());
    std::size_t conditions = 0;
    for (const KeyPresenceRule& clause : card.when) {
      conditions += std::max<std::size_t>(split_words(clause.words).size(), 1);
    }
    EXPECT_EQ(json["when"].size(), conditions);
  }
  const auto& material = *std::find_if(schema["cards"].begin(), schema["cards"].end(),
                                       [](const auto& c) { return c["name"] == "MATERIAL"; });
  EXPECT_EQ(material["keys"][1]["dimension"], "stress");
  EXPECT_EQ(material["keys"][2]["range"]["below"], 0.5);
  EXPECT_EQ(material["keys"][3]["default"], "0");
  EXPECT_EQ(schema["quantities"].size(), result_quantities().size());
  EXPECT_EQ(schema["functions"].size(), expression_functions().size());
}

TEST(Editors, NameEveryCardAndKey) {
  const std::string vim = vim_syntax();
  const auto textmate = nlohmann::json::parse(textmate_grammar());
  std::regex card_pattern;
  std::regex key_pattern;
  for (const auto& pattern : textmate["patterns"]) {
    const std::string match = pattern["match"];
    const std::string plain = match.starts_with("(?i)") ? match.substr(4) : match;
    if (pattern["name"] == "keyword.control.card.spricka") {
      card_pattern = std::regex(plain, std::regex::icase);
    } else if (pattern["name"] == "entity.name.tag.key.spricka") {
      key_pattern = std::regex(plain, std::regex::icase);
    }
  }
  for (const CardSpec& card : card_catalogue()) {
    const std::string name = "$" + std::string(card.name);
    EXPECT_TRUE(std::regex_search(name + " X=1", card_pattern)) << name;
    EXPECT_TRUE(std::regex_search(vim, std::regex("[(|]" + std::string(card.name) + "\\\\[|)]")))
        << name;
    for (const KeySpec& key : card.keys) {
      EXPECT_TRUE(std::regex_search(std::string(key.name) + " =", key_pattern)) << key.name;
    }
  }
  EXPECT_FALSE(std::regex_search(std::string("$NETS"), card_pattern));
}

} // namespace
} // namespace spricka::grammar::test_help
