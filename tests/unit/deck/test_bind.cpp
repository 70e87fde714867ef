// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/messages.hpp"
#include "deck/bind.hpp"
#include "grammar/parse.hpp"

#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace spricka::deck::test_bind {
namespace {

struct Binder {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  grammar::ExpressionScope scope;

  Binder() {
    scope.sources = &sources;
    scope.units = *base::make_unit_system("mm", "N");
    scope.values = {{"DELTA", 0.084}};
  }
  CheckedCard bind(const std::string& header) {
    diagnostics = {};
    const auto cards = grammar::parse_cards(sources, sources.add_text("card", header), diagnostics);
    return check_card_header(cards.front(), *grammar::find_card(cards.front().name), scope,
                             diagnostics);
  }
  std::string code(const std::string& header) {
    EXPECT_TRUE(bind(header).bad) << header;
    return diagnostics.messages().empty() ? "" : diagnostics.messages().front().code;
  }
};

TEST(Bind, ValuesAndDefaults) {
  Binder b;
  const CheckedCard card =
      b.bind("$CONTACT NAME=fit SLAVE=PIN.OUTER MASTER=HUB.INNER DIAMETRAL=(2*delta) PAIRING=node");
  EXPECT_FALSE(card.bad) << base::format_messages(b.sources, b.diagnostics);
  EXPECT_EQ(card.word_value("NAME"), "FIT");
  EXPECT_EQ(card.name_reference("SLAVE").name, "PIN.OUTER");
  EXPECT_EQ(card.number_value("DIAMETRAL"), 0.168);
  EXPECT_TRUE(card.key_has_word("PAIRING", "NODE"));
  EXPECT_TRUE(card.key_has_word("RECOVERY", "LUMPED"));
  EXPECT_FALSE(card.has_key("RECOVERY"));
  EXPECT_FALSE(card.optional_number("GAP"));
  EXPECT_EQ(b.bind("$MESH SHAPE=RING TYPE=QUAM4 RI=1 RO=2").number_value("T1"),
            2 * std::numbers::pi);
}

TEST(Bind, UnitsOfTheKeyAreDemanded) {
  Binder b;
  EXPECT_EQ(b.bind("$MATERIAL NAME=M E=70[GPa] NU=0.3").number_value("E"), 70000.0);
  EXPECT_EQ(b.bind("$MESH SHAPE=RING TYPE=QUAM4 RI=1 RO=1[in] T1=90[deg]").number_value("RO"),
            25.4);
  EXPECT_EQ(b.code("$MATERIAL NAME=M E=70[mm] NU=0.3"), "E205");
  EXPECT_EQ(b.code("$MATERIAL NAME=M E=(70)[N] NU=0.3"), "E205");
  EXPECT_EQ(b.code("$MATERIAL NAME=M E=70 NU=0.3[mm]"), "E205");
  EXPECT_EQ(b.code("$MATERIAL NAME=M E=70[Gpa] NU=0.3"), "E204");
}

TEST(Bind, MistakesHaveTheirCodes) {
  Binder b;
  EXPECT_EQ(b.code("$MATERIAL NAME=M E=1"), "E106");
  EXPECT_EQ(b.code("$MATERIAL NAME=M E=1 NU=0.3 G=2"), "E105");
  EXPECT_EQ(b.code("$MATERIAL NAME=M E=1 NU=0.3 E=2"), "E107");
  EXPECT_EQ(b.code("$MATERIAL NAME='M' E=1 NU=0.3"), "E108");
  EXPECT_EQ(b.code("$MATERIAL NAME=A.M E=1 NU=0.3"), "E108");
  EXPECT_EQ(b.code("$MATERIAL NAME=M E=delta NU=0.3"), "E108");
  EXPECT_EQ(b.code("$MATERIAL NAME=M E=1 NU=0.5"), "E109");
  EXPECT_EQ(b.code("$MATERIAL NAME=M E=0 NU=0.3"), "E109");
  EXPECT_EQ(b.code("$MESH SHAPE=RING TYPE=QUAM4 RI=1 RO=2 NT=8.5"), "E108");
  EXPECT_EQ(b.code("$MESH SHAPE=RING TYPE=QUAM4 RI=1 RO=2 NT=2"), "E109");
  EXPECT_EQ(b.code("$MESH SHAPE=RING TYPE=QUAM4 RI=1 RO=2 LX=1"), "E110");
  EXPECT_EQ(b.code("$MESH SHAPE=RING TYPE=QUAM4 RI=1"), "E106");
  EXPECT_EQ(b.code("$CONTACT NAME=C SLAVE=A MASTER=B GAP=0 INTERFERENCE=1"), "E110");
  EXPECT_EQ(b.code("$OUTPUT FILE=a.csv FORMAT=CSV"), "E108");
  EXPECT_EQ(b.code("$NSET NAME=A WHERE=(q > 0)"), "E201");
  EXPECT_EQ(b.code("$GROW LAW=PARIS KMAX=A KMIN=B C=1"), "E106");
}

} // namespace
} // namespace spricka::deck::test_bind
