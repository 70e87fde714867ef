// SPDX-License-Identifier: GPL-3.0-or-later
// Decks rewritten card by card: they mean the same, and what is changed is changed.
#include "deck/deck_text.hpp"
#include "deck/read_deck.hpp"
#include "program/study/deck_edits.hpp"
#include "program/study/mesh_parameters.hpp"
#include "tests/places.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace spricka::test_deck_text {
namespace {

namespace fs = std::filesystem;

deck::DeckCardList text_of(const fs::path& file, base::SourceTexts& sources) {
  base::Diagnostics diagnostics;
  auto text = deck::read_deck_card_list(file, sources, diagnostics);
  EXPECT_TRUE(text) << file;
  return text.value_or(deck::DeckCardList{});
}

std::optional<model::Model> model_of(const fs::path& file) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  return deck::read_deck(file, {}, sources, diagnostics);
}

class DeckTexts : public ::testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) / "deck_texts";
    fs::create_directories(folder_);
  }
  fs::path written(const deck::DeckCardList& text) {
    fs::path file = folder_ / "written.deck";
    std::ofstream(file) << deck::format_deck_card_list(text, folder_, {"a comment"});
    return file;
  }
  fs::path folder_;
};

TEST_F(DeckTexts, a_deck_written_elsewhere_makes_the_same_model) {
  for (const char* name : {"lug_single.deck", "edge_crack.deck", "press_fit_hub.deck",
                           "penny_solid.deck", "lug_load_path.deck", "lug_friction.deck"}) {
    base::SourceTexts sources;
    const fs::path file = fs::path(test::decks_folder()) / name;
    const auto before = model_of(file);
    const auto after = model_of(written(text_of(file, sources)));
    ASSERT_TRUE(before && after) << name;
    EXPECT_EQ(after->mesh.x.size(), before->mesh.x.size()) << name;
    EXPECT_EQ(after->parameters, before->parameters) << name;
    EXPECT_EQ(after->contacts.size(), before->contacts.size()) << name;
    EXPECT_EQ(after->checks.size(), before->checks.size()) << name;
    EXPECT_EQ(after->steps.size(), before->steps.size()) << name;
  }
}

TEST_F(DeckTexts, a_net_goes_with_all_that_is_about_it_alone) {
  base::SourceTexts sources;
  deck::DeckCardList text = text_of(fs::path(test::decks_folder()) / "press_fit_hub.deck", sources);
  program::remove_checks_and_requests(text);
  EXPECT_EQ(program::remove_nets_with_dependents(text, {"BUSH", "HUB3"}),
            std::set<std::string>{"HEAT"});
  program::drop_undefined_loads(text);
  const auto model = model_of(written(text));
  ASSERT_TRUE(model);
  EXPECT_EQ(model->nets.size(), 5U); // four, and what stands in none
  EXPECT_EQ(model->contacts.size(), 2U);
  EXPECT_TRUE(model->cases.empty());     // heat of the bush
  EXPECT_EQ(model->freedoms.size(), 1U); // its line named other nets as well
}

TEST(NameUses, parameters_of_counts_are_told_from_those_of_the_model) {
  base::SourceTexts sources;
  const deck::DeckCardList text =
      text_of(fs::path(test::decks_folder()) / "edge_crack.deck", sources);
  const auto uses = program::find_parameter_uses(text, sources);
  EXPECT_FALSE(uses.at("FINE").elsewhere);
  EXPECT_EQ(uses.at("FINE").counts.size(), 1U);
  EXPECT_TRUE(uses.at("W").elsewhere);
  EXPECT_TRUE(uses.at("W").counts.empty());
}

TEST(DeckEdits, fields_keep_brackets_units_and_lose_comments) {
  deck::DeckCard card;
  card.data = "  ! nothing\n  SHAFT.BODY  (F*(1 - x))  97.1[kN], 0 ! along x\n  OTHER 1\n";
  EXPECT_EQ(program::split_data_line_fields(card),
            (std::vector<program::DataFields>{{"SHAFT.BODY", "(F*(1 - x))", "97.1[kN]", "0"},
                                              {"OTHER", "1"}}));
  program::filter_data_lines(card, [](const auto& fields) { return fields.size() < 4; });
  EXPECT_EQ(card.data, "  ! nothing\n  OTHER 1\n");
}

TEST(DeckEdits, names_are_told_from_numbers_and_units) {
  EXPECT_EQ(program::transform_names_in_text(
                "(x*1e5 + X_2)[mm] 'x' ! x",
                [](std::string_view name) { return name == "x" ? "y" : "Z"; }),
            "(y*1e5 + Z)[mm] 'x' ! x");
}

} // namespace
} // namespace spricka::test_deck_text
