// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/messages.hpp"
#include "grammar/bulk_table.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::grammar::test_table {
namespace {

struct Reader {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  ExpressionScope scope;
  BulkRowFormat form;
  base::SourceSpan data;

  explicit Reader(const std::string& text, std::size_t columns) {
    scope.sources = &sources;
    scope.units = *base::make_unit_system("mm", "N");
    scope.values = {{"R", 36.0}};
    form.columns = columns;
    data = {sources.add_text("table", text), 0, static_cast<std::uint32_t>(text.size())};
  }
  BulkTableBlock<double> coordinates() {
    BulkTableBlock<double> all;
    parse_node_lines(form, data, scope, diagnostics, gather(all));
    return all;
  }
  BulkTableBlock<base::Label> nodes() {
    BulkTableBlock<base::Label> all;
    parse_element_lines(form, data, scope, diagnostics, gather(all));
    return all;
  }
  template <class Value> static RowBlockCallback<Value> gather(BulkTableBlock<Value>& all) {
    return [&all](const BulkTableBlock<Value>& block) {
      all.columns = block.columns;
      all.label.insert(all.label.end(), block.label.begin(), block.label.end());
      all.value.insert(all.value.end(), block.value.begin(), block.value.end());
      all.offset.insert(all.offset.end(), block.offset.begin(), block.offset.end());
    };
  }
  /// Code and column of the only message.
  std::string message() {
    coordinates();
    if (diagnostics.messages().size() != 1) {
      return fmt::format("{} messages", diagnostics.messages().size());
    }
    const base::Diagnostic& d = diagnostics.messages().front();
    const base::SourceLocation at = sources.locate(d.span.file, d.span.begin);
    return fmt::format("{} {}:{}", d.code, at.line, at.column);
  }
};

// Written with the shortest digits that identify a double, every one comes back bit for bit.
TEST(Table, DoublesSurviveTheRoundTripBitwise) {
  std::mt19937_64 random(20260101);
  std::string text;
  std::vector<double> written;
  while (written.size() < 30000) {
    const double any = std::bit_cast<double>(random());
    const double value = written.size() % 2 == 0 ? any : 500.0 * (any / 1e308) - 250.0;
    if (!std::isnormal(value)) {
      continue;
    }
    written.push_back(value);
    text += written.size() % 3 == 1 ? fmt::format("{} {}", written.size() / 3 + 1, value)
                                    : fmt::format(" {}", value);
    text += written.size() % 3 == 0 ? "\n" : "";
  }
  Reader r(text, 3);
  const BulkTableBlock<double> table = r.coordinates();
  EXPECT_FALSE(r.diagnostics.has_errors()) << base::format_messages(r.sources, r.diagnostics, 3);
  ASSERT_EQ(table.value.size(), written.size());
  for (std::size_t i = 0; i < written.size(); ++i) {
    ASSERT_EQ(std::bit_cast<std::uint64_t>(table.value[i]),
              std::bit_cast<std::uint64_t>(written[i]));
  }
}

TEST(Table, SeparatorsCommentsAndContinuations) {
  Reader r(
      "1, 0.5,+1.5 ! a comment\r\n\r\n! one more\n\t2\t-0.\t.5e1\n 3  7 !\n  ! between\n & 8\n", 2);
  const BulkTableBlock<double> table = r.coordinates();
  EXPECT_FALSE(r.diagnostics.has_errors()) << base::format_messages(r.sources, r.diagnostics);
  EXPECT_EQ(table.label, (std::vector<base::Label>{1, 2, 3}));
  EXPECT_EQ(table.value, (std::vector<double>{0.5, 1.5, 0.0, 5.0, 7.0, 8.0}));
  EXPECT_TRUE(std::signbit(table.value[2]));
  EXPECT_EQ(r.sources.text(table_field_span(r.sources, r.data, table.offset[2], 2)), "8");
}

TEST(Table, ParenthesesAndUnitsTakeTheSlowWay) {
  Reader r("1 (R/2) 1[in]\n2 (2 * (R - 1))[mm] 1e-3[m]", 2);
  const BulkTableBlock<double> table = r.coordinates();
  EXPECT_FALSE(r.diagnostics.has_errors()) << base::format_messages(r.sources, r.diagnostics);
  EXPECT_EQ(table.value, (std::vector<double>{18.0, 25.4, 70.0, 1.0}));
  EXPECT_EQ(r.sources.text(table_field_span(r.sources, r.data, table.offset[1], 1)),
            "(2 * (R - 1))[mm]");
}

TEST(Table, ConnectivityIsWholeNumbers) {
  Reader r("1 1 2 (1+2)\n 2, 4,5, 1000000000000", 3);
  EXPECT_EQ(r.nodes().value, (std::vector<base::Label>{1, 2, 3, 4, 5, 1000000000000}));
  Reader wrong("1 1 2.5 3\n2 1 2 (1/2)", 3);
  EXPECT_TRUE(wrong.nodes().label.empty());
  EXPECT_EQ(wrong.diagnostics.error_count(), 2U);
}

TEST(Table, MistakesPointAtTheirField) {
  EXPECT_EQ(Reader("1 0 0\n2 1\n3 1 1", 2).message(), "E120 2:4");
  EXPECT_EQ(Reader("1 0 0 5", 2).message(), "E121 1:7");
  EXPECT_EQ(Reader("1 0,5 0,5", 2).message(), "E121 1:7");
  EXPECT_EQ(Reader("1 0 1.0d0", 2).message(), "E103 1:5");
  EXPECT_EQ(Reader("1 0 1.5-3", 2).message(), "E103 1:5");
  EXPECT_EQ(Reader("1 0 nan", 2).message(), "E120 1:5");
  EXPECT_EQ(Reader("1 0 -inf", 2).message(), "E120 1:5");
  EXPECT_EQ(Reader("1 0 1e999", 2).message(), "E103 1:5");
  EXPECT_EQ(Reader("1 0 1.2.3", 2).message(), "E103 1:5");
  EXPECT_EQ(Reader("1.5 0 0", 2).message(), "E103 1:1");
  EXPECT_EQ(Reader("0 0 0", 2).message(), "E103 1:1");
  EXPECT_EQ(Reader("1 0 (R", 2).message(), "E101 1:7");
  EXPECT_EQ(Reader("1 0 (Q)", 2).message(), "E201 1:6");
  EXPECT_EQ(Reader("1 0 1[N]", 2).message(), "E205 1:5");
  EXPECT_EQ(Reader("1 \xC3\xA4 0", 2).message(), "E120 1:3");
}

TEST(Table, ABadLineCostsOnlyItself) {
  Reader r("1 0 0\n2 x 0\n3 1 1\n", 2);
  EXPECT_EQ(r.coordinates().label, (std::vector<base::Label>{1, 3}));
  EXPECT_EQ(r.diagnostics.error_count(), 1U);
}

} // namespace
} // namespace spricka::grammar::test_table
