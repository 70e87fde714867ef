// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck_text.hpp"
#include "grammar/catalogue.hpp"

#include <gtest/gtest.h>

namespace spricka::deck::test_examples {
namespace {

// An example as the middle of a deck: the names it uses may be missing, but every card, key, value,
// unit and data line is as the language has it.
TEST(Examples, BindWithoutAMistake) {
  for (const grammar::CardSpec& card : grammar::card_catalogue()) {
    const Folder folder;
    std::string text(card.example);
    if (card.name != "DECK") {
      text.insert(0, "$DECK VERSION=1 LENGTH=MM FORCE=N\n");
    }
    text += card.name == "END" ? "" : "$END\n";
    folder.write("lug_model.inc", "");
    folder.write("lug.geo", "");
    const Reading reading(folder, text);
    for (const base::Diagnostic& d : reading.diagnostics.messages()) {
      EXPECT_FALSE(d.code.starts_with("E1") || d.code.starts_with("E2")) << card.name << ":\n"
                                                                         << reading.messages();
    }
  }
}

} // namespace
} // namespace spricka::deck::test_examples
