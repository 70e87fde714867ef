// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/columns.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace spricka::report::test_columns {
namespace {

struct Sample {
  std::string name;
  double length = 0.0;
  int count = 0;
  std::optional<double> gap;
};

const std::vector<Sample> samples{{"A", 1.0 / 3.0, 7, std::nullopt}, {"B", -2.5e-8, 0, 0.1}};

TEST(Columns, MakeATableOfWordsAndNumbersInTheirDigits) {
  const ReportTable table = Columns<Sample>()
                                .words("name", &Sample::name)
                                .number("length", "mm", &Sample::length)
                                .number("short", "mm", &Sample::length, "{:.2e}")
                                .number("count", "", &Sample::count)
                                .number("gap", "mm", &Sample::gap, "{:.3f}")
                                .table("Samples", samples);
  EXPECT_EQ(table.title, "Samples");
  ASSERT_EQ(table.columns.size(), 5U);
  EXPECT_TRUE(table.columns[0].words);
  EXPECT_FALSE(table.columns[1].words);
  EXPECT_EQ(table.columns[1].unit, "mm");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"A", "0.333333", "3.33e-01", "7", ""}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"B", "-2.5e-08", "-2.50e-08", "0", "0.100"}));
}

TEST(Columns, AreEmptyInRowsThatDoNotMeetTheCondition) {
  Columns<Sample> columns;
  columns.words("name", &Sample::name)
      .fill_only_if([](const Sample& sample) { return sample.gap.has_value(); })
      .number("gap", "", [](const Sample& sample) { return *sample.gap; })
      .fill_only_if({})
      .number("count", "", &Sample::count);
  EXPECT_EQ(columns.cells(samples[0]), (std::vector<std::string>{"A", "", "7"}));
  EXPECT_EQ(columns.cells(samples[1]), (std::vector<std::string>{"B", "0.1", "0"}));
}

TEST(Columns, WriteFilesWithNumbersThatReadBackToTheSameBits) {
  const std::string text = Columns<Sample>()
                               .exact("name", &Sample::name)
                               .exact("length", &Sample::length)
                               .exact("gap", &Sample::gap)
                               .csv("length gap [mm]", samples);
  EXPECT_EQ(text, "# units: length gap [mm]\n"
                  "name,length,gap\n"
                  "A,0.3333333333333333,\n"
                  "B,-2.5e-08,0.1\n");
}

} // namespace
} // namespace spricka::report::test_columns
