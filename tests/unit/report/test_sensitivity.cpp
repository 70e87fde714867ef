// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/tornado.hpp"
#include "report/topics/result_tables.hpp"
#include "report/topics/sensitivity_tables.hpp"
#include "sample.hpp"

#include <fstream>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

namespace spricka::report::test_sensitivity {
namespace {

using results::Sensitivity;
using results::SensitivityParameter;

// A load, a net fit and a modulus at the end of the leading step; the fit at a corner.
test::Sample with_sensitivities() {
  test::Sample sample = test::make_sample();
  for (results::CrackLengthResult& increment : sample.run.increments) {
    const auto step = std::ranges::find(increment.steps, leading_step_name(sample.model),
                                        &results::LoadStepResult::step);
    results::FrontResult& front = step->fronts.front();
    front.single_point().K1 = 500.0;
    Sensitivity weak{
        SensitivityParameter::modulus, "AL", 70000.0, {{1e-3, 0.0, 0.0}}, {{1e-3, 0.0, 0.0}}, {}};
    constexpr double never = std::numeric_limits<double>::infinity();
    Sensitivity load{SensitivityParameter::load, "F",           2.0, {{250.0, 5.0, 0.0}},
                     {{250.0, 5.0, 0.0}},        {{1.5, never}}};
    Sensitivity corner{SensitivityParameter::fit, "BUSH",  0.0, {{-1000.0, 7.0, 0.0}},
                       {{-2000.0, 8.0, 0.0}},     {{0, 0}}};
    front.sensitivities.by_parameter = {weak, load, corner};
    front.sensitivities.notes = {"no length"};
  }
  return sample;
}

TEST(SensitivityTable, IsSortedAndShowsBothSidesOfACorner) {
  const test::Sample sample = with_sensitivities();
  const ReportTable table = sensitivity_table(sample.model, sample.run.increments.front());
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0][1], "LOAD F");
  EXPECT_EQ(table.rows[0][3], "500");
  EXPECT_EQ(table.rows[0][4], "1 %");
  EXPECT_EQ(table.rows[0][5], "+1.0000"); // 0.02 * 250 of 500
  EXPECT_EQ(table.rows[0][7], "1.5");
  EXPECT_EQ(table.rows[0][8], "any");
  EXPECT_EQ(table.rows[1][1], "FIT BUSH");
  EXPECT_EQ(table.rows[1][3], ""); // no part of nothing
  EXPECT_EQ(table.rows[1][4], "1 um");
  EXPECT_EQ(table.rows[1][5], "-0.2000 | -0.4000"); // 1 or 2 of 500 for a micrometre
  EXPECT_EQ(table.rows[2][1], "E AL");
  EXPECT_EQ(missing_sensitivity_reasons(sample.model, sample.run.increments.front()),
            std::vector<std::string>{"no length"});
}

TEST(SensitivityTable, AMicrometreIsOneInAllUnits) {
  test::Sample sample = with_sensitivities();
  sample.model.units.metre_per_length = 0.0254;
  const ReportTable table = sensitivity_table(sample.model, sample.run.increments.front());
  const auto fit =
      std::ranges::find_if(table.rows, [](const auto& r) { return r[1] == "FIT BUSH"; });
  ASSERT_NE(fit, table.rows.end());
  EXPECT_EQ((*fit)[5], "-0.0079 | -0.0157"); // 39.37 microinches
}

TEST(SensitivityTable, FileHoldsEveryDerivative) {
  const test::Sample sample = with_sensitivities();
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "sensitivity_rows.csv";
  write_sensitivity_csv(file, sample.model, sample.run);
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  ASSERT_EQ(lines.size(), 2U + 3U * sample.run.increments.size());
  EXPECT_TRUE(lines[3].ends_with(",LOAD,F,2,250,250,5,5,1.5,inf")) << lines[3];
  EXPECT_TRUE(lines[4].ends_with(",FIT,BUSH,0,-1000,-2000,7,8,0,0")) << lines[4];
  EXPECT_TRUE(lines[2].ends_with(",E,AL,70000,0.001,0.001,0,0,,")) << lines[2];
  std::filesystem::remove(file);
}

// Widths of the bars are in proportion to what they stand for, on the side of its sign.
TEST(TornadoChart, BarsAreToScale) {
  const std::string svg = draw_svg(TornadoChart{"T", {{"A", 2.0, -2.0, 0}, {"B", -1.0, 0.5, 1}}});
  std::vector<std::pair<double, double>> bars; // left, width
  for (std::size_t at = svg.find("<rect"); at != std::string::npos;
       at = svg.find("<rect", at + 1)) {
    const auto value = [&](const std::string& key) {
      return std::stod(svg.substr(svg.find(key + "=\"", at) + key.size() + 2));
    };
    bars.emplace_back(value(" x"), value(" width"));
  }
  ASSERT_EQ(bars.size(), 4U); // less and more of each
  const double middle = bars[1].first;
  EXPECT_NEAR(bars[0].first + bars[0].second, middle, 0.02);
  EXPECT_NEAR(bars[0].second, bars[1].second, 0.02);
  EXPECT_NEAR(bars[2].first, middle, 0.02);
  EXPECT_NEAR(bars[2].second, 0.25 * bars[1].second, 0.02);
  EXPECT_NEAR(bars[3].first + bars[3].second, middle, 0.02);
  EXPECT_NEAR(bars[3].second, 0.5 * bars[1].second, 0.02);
}

} // namespace
} // namespace spricka::report::test_sensitivity
