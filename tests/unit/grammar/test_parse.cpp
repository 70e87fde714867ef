// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/messages.hpp"
#include "grammar/parse.hpp"

#include <string>

#include <gtest/gtest.h>

namespace spricka::grammar::test_parse {
namespace {

struct Reader {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;

  std::vector<CardHeader> cards(const std::string& text) {
    return parse_cards(sources, sources.add_text("deck", text), diagnostics);
  }
  std::vector<DataRow> rows(const std::string& text) {
    const auto file = sources.add_text("rows", text);
    return parse_data_rows(sources, {file, 0, static_cast<std::uint32_t>(text.size())},
                           diagnostics);
  }
};

TEST(Parse, HeadersHoldKeysOfEveryKind) {
  Reader r;
  const auto cards = r.cards("$vce crack=C1  Domains = 1, 2,3 TITLE='a ! b' A0=(0.05*R)[mm] ! end\n"
                             "  1 2\n$END");
  EXPECT_FALSE(r.diagnostics.has_errors()) << base::format_messages(r.sources, r.diagnostics);
  ASSERT_EQ(cards.size(), 2U);
  EXPECT_EQ(cards[0].name, "VCE");
  ASSERT_EQ(cards[0].parameters.size(), 4U);
  EXPECT_EQ(cards[0].parameters[0].values[0].text, "C1");
  EXPECT_EQ(cards[0].parameters[1].key, "DOMAINS");
  EXPECT_EQ(cards[0].parameters[1].values.size(), 3U);
  EXPECT_EQ(cards[0].parameters[2].values[0].text, "a ! b");
  EXPECT_EQ(cards[0].parameters[3].values[0].kind, CardField::CardFieldKind::expression);
  EXPECT_EQ(r.sources.text(cards[0].data), "  1 2\n");
  EXPECT_EQ(r.sources.text(cards[1].name_span), "$END");
}

TEST(Parse, RowsHoldFieldsOfEveryKind) {
  Reader r;
  const auto rows = r.rows("1  3 : 9:2  -LEFT  LUG.BORE, (x+1)  -2.5[mm]  'a text'\n"
                           "K(C1.1, LOAD, 0.1*R) = 474  REL 0.05\n");
  EXPECT_FALSE(r.diagnostics.has_errors()) << base::format_messages(r.sources, r.diagnostics);
  ASSERT_EQ(rows.size(), 2U);
  const auto& f = rows[0].fields;
  ASSERT_EQ(f.size(), 7U);
  EXPECT_EQ(f[0].kind, CardField::CardFieldKind::number);
  EXPECT_EQ(f[1].kind, CardField::CardFieldKind::range);
  EXPECT_EQ(f[1].range, (std::array<base::Label, 3>{3, 9, 2}));
  EXPECT_EQ(f[2].kind, CardField::CardFieldKind::minus_name);
  EXPECT_EQ(f[2].text, "LEFT");
  EXPECT_EQ(f[3].text, "LUG.BORE");
  EXPECT_EQ(f[3].separator, ',');
  EXPECT_EQ(f[4].kind, CardField::CardFieldKind::expression);
  EXPECT_EQ(f[5].expression.terms[0].value, -2.5);
  EXPECT_EQ(f[6].text, "a text");
  const auto& check = rows[1].fields;
  ASSERT_EQ(check.size(), 4U);
  EXPECT_EQ(check[0].kind, CardField::CardFieldKind::quantity);
  EXPECT_EQ(check[0].separator, '=');
  ASSERT_EQ(check[0].arguments.size(), 3U);
  EXPECT_EQ(r.sources.text(check[0].arguments[0].span), "C1.1");
}

TEST(Parse, ContinuedLinesBelongTogether) {
  Reader r;
  const auto cards = r.cards("$PROPERTY ESET=A !x\r\n ! comment\r\n  & STATE=STRESS\r\n$END\r\n");
  EXPECT_FALSE(r.diagnostics.has_errors());
  ASSERT_EQ(cards.size(), 2U);
  EXPECT_EQ(cards[0].parameters.size(), 2U);
  EXPECT_EQ(r.rows("1 2\n & 3 4\n5\n").size(), 2U);
}

TEST(Parse, ABadHeaderDoesNotHideTheNext) {
  Reader r;
  const auto cards = r.cards("$A X=\n$B Y=1.0d0\n$C Z=(1\n$D =\n$ E\n$F G=1 H\n$END\n");
  EXPECT_EQ(r.diagnostics.error_count(), 6U);
  EXPECT_EQ(cards.size(), 7U);
  const std::string message = base::format_messages(r.sources, r.diagnostics);
  EXPECT_EQ(message.find("boost"), std::string::npos) << message;
}

TEST(Parse, ADollarInsideALineIsNoCard) {
  Reader r;
  EXPECT_EQ(r.cards("$A ! costs $5\n 'x$y' ! $B\n  $C\n").size(), 2U);
}

TEST(Parse, AssignmentsKeepTheNameAsWritten) {
  Reader r;
  const std::string text = "K_ref = 2*pi ! mean\nbad = 2 *\n";
  const auto file = r.sources.add_text("parameters", text);
  const auto all = parse_parameter_assignments(
      r.sources, {file, 0, static_cast<std::uint32_t>(text.size())}, r.diagnostics);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].name, "K_REF");
  EXPECT_EQ(all[0].written, "K_ref");
  EXPECT_EQ(r.sources.text(all[0].value.span), "2*pi");
  EXPECT_TRUE(all[1].value.terms.empty());
  EXPECT_EQ(r.diagnostics.error_count(), 1U);
}

} // namespace
} // namespace spricka::grammar::test_parse
