// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/check_listing.hpp"
#include "report/report.hpp"
#include "results/stress_invariants.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <system_error>

#include <Eigen/Geometry>

namespace spricka::report::test_writers {
namespace {

std::vector<std::vector<std::string>> read_csv(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> fields;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      fields.push_back(cell);
    }
    rows.push_back(fields);
  }
  return rows;
}

double number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_TRUE(error == std::errc() && end == text.data() + text.size()) << text;
  return value;
}

class Writers : public testing::Test {
protected:
  Writers() { std::filesystem::create_directories(folder); }
  ~Writers() override { std::filesystem::remove_all(folder); }

  test::Sample sample = test::make_sample();
  std::filesystem::path folder = std::filesystem::path(testing::TempDir()) /
                                 testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(Writers, KTableHasOneRowForEachStepEndAndReadsBackToTheBit) {
  write_k_csv(folder / "k.csv", sample.model, sample.run);
  const auto rows = read_csv(folder / "k.csv");
  ASSERT_EQ(rows.size(), 2U + 2U * 3U);
  EXPECT_EQ(rows[0][0].substr(0, 8), "# units:");
  const std::vector<std::string> names{"increment", "step",   "crack",  "a",       "K1",
                                       "K2",        "G",      "spread", "T",       "K1_bar",
                                       "K1_raw",    "K1_eta", "K1_sum", "K1_flip", "K2_bar",
                                       "K2_raw",    "K2_eta", "K2_sum", "K2_flip"};
  ASSERT_GE(rows[1].size(), names.size());
  EXPECT_TRUE(std::equal(names.begin(), names.end(), rows[1].begin())) << "new ones stand behind";
  std::size_t row = 2;
  for (const results::CrackLengthResult& increment : sample.run.increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      const results::FrontResult& front = step.fronts.front();
      ASSERT_TRUE(front.is_tip());
      const results::FrontPointResult& tip = front.single_point();
      const auto& cells = rows[row++];
      ASSERT_GE(cells.size(),
                front.missing_bar_reason.empty() ? names.size() : names.size() - 1); // ends empty
      EXPECT_EQ(cells[0], std::to_string(increment.number));
      EXPECT_EQ(cells[1], step.step);
      EXPECT_EQ(cells[2], front.name);
      EXPECT_EQ(number(cells[3]), front.a);
      EXPECT_EQ(number(cells[4]), tip.K1);
      EXPECT_EQ(number(cells[5]), tip.K2);
      EXPECT_EQ(number(cells[6]), tip.G);
      EXPECT_EQ(number(cells[7]), tip.spread);
      EXPECT_EQ(number(cells[8]), tip.T);
      for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t at = 9 + 5 * k;
        if (!front.missing_bar_reason.empty()) {
          EXPECT_EQ(cells[at] + cells[at + 3], "");
          continue;
        }
        EXPECT_EQ(number(cells[at]), tip.bar[k].size());
        EXPECT_EQ(number(cells[at + 1]), tip.raw_K()[k]);
        EXPECT_EQ(number(cells[at + 2]), tip.bar[k].eta);
        EXPECT_EQ(number(cells[at + 3]), tip.bar[k].sum);
        EXPECT_EQ(number(cells[at + 4]), tip.bar[k].set_change);
      }
    }
  }
}

TEST_F(Writers, PressureTableHasBothCrackFacesAndSkipsAbsentContacts) {
  write_pressure_csv(folder / "pressure.csv", sample.model, sample.run);
  const auto rows = read_csv(folder / "pressure.csv");
  const std::size_t points = sample.run.increments[0].steps[0].contacts[0].points.size();
  ASSERT_EQ(rows.size(), std::size_t{2} + 4 * points) << "the step with factor 0 has no contact";
  std::size_t crack_faces = 0;
  for (std::size_t r = 2; r < rows.size(); ++r) {
    ASSERT_EQ(rows[r].size(), 8U);
    const double x = number(rows[r][3]);
    const double y = number(rows[r][4]);
    const double theta = number(rows[r][5]) * std::numbers::pi / 180.0;
    EXPECT_NEAR(std::remainder(theta - std::atan2(y, x), 2.0 * std::numbers::pi), 0.0, 1e-12);
    crack_faces += std::abs(x) < 1e-9 && y > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(crack_faces, 2U * 2U * 2U);
}

TEST_F(Writers, LeaveNoTemporaryFileAndReplaceAnOldOne) {
  std::ofstream(folder / "k.csv") << "old";
  write_k_csv(folder / "k.csv", sample.model, sample.run);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    EXPECT_EQ(entry.path().filename(), "k.csv");
    ++files;
  }
  EXPECT_EQ(files, 1U);
  EXPECT_GT(std::filesystem::file_size(folder / "k.csv"), 100U);
}

TEST_F(Writers, ThrowSystemErrorWhereNothingCanBeWritten) {
  const auto& increment = sample.run.increments.front();
  EXPECT_THROW(write_k_csv(folder / "no" / "k.csv", sample.model, sample.run), std::system_error);
  EXPECT_THROW(write_step_vtu(folder / "no" / "a.vtu", sample.model, increment, increment.steps[0]),
               std::system_error);
  // A folder in the way: the temporary file must be gone again.
  std::filesystem::create_directories(folder / "k.csv" / "in_use");
  EXPECT_THROW(write_k_csv(folder / "k.csv", sample.model, sample.run), std::system_error);
  EXPECT_FALSE(std::filesystem::exists(folder / "k.csv.part"));
}

TEST_F(Writers, ListingEchoesTheDeckAndShowsEveryTable) {
  const std::string text = listing_text(sample.sources, sample.model, sample.run);
  for (const char* part :
       {"     1 | ! a sample\n", "     2 | $DECK VERSION=1\n", "     3 |\n", "     4 | $END\n",
        "TOPOLOGY", "Force balance", "G of raw K", "penetration", "iterations", "absent",
        "Increment 2: a = 18 mm", "2 of 2 passed", "MPa*mm^0.5"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(text.find(" \n"), std::string::npos) << "blanks at a line's end";
}

TEST(CheckListing, PlacesHaveAsManyCoordinatesAsTheMesh) {
  results::DeckPreview preview;
  preview.quality = {{"host", "aspect", 3.0, "A", 7, {1.0, 2.0, 3.0}}};
  EXPECT_NE(deck_preview_listing(preview).find("(1, 2)"), std::string::npos);
  preview.dim = 3;
  EXPECT_NE(deck_preview_listing(preview).find("(1, 2, 3)"), std::string::npos);
}

TEST(StressInvariants, VonMisesInClosedForm) {
  EXPECT_NEAR(results::von_mises({-5.0, 0, 0, 0, 0, 0}), 5.0, 1e-14);
  EXPECT_EQ(results::von_mises({2.0, 2.0, 2.0, 0, 0, 0}), 0.0);
  for (std::size_t c = 3; c < 6; ++c) {
    results::Stress s{};
    s[c] = 4.0;
    EXPECT_NEAR(results::von_mises(s), 4.0 * std::sqrt(3.0), 1e-14);
  }
}

// A diagonal stress turned about two axes has the diagonal's values, the largest first.
TEST(StressInvariants, PrincipalStressesOfATurnedTensor) {
  const Eigen::Matrix3d Q = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                             Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitX()))
                                .toRotationMatrix();
  const Eigen::Matrix3d s = Q * Eigen::Vector3d(-20.0, 70.0, 5.0).asDiagonal() * Q.transpose();
  const auto p =
      results::principal_stresses({s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(2, 0)});
  EXPECT_NEAR(p[0], 70.0, 1e-12);
  EXPECT_NEAR(p[1], 5.0, 1e-12);
  EXPECT_NEAR(p[2], -20.0, 1e-12);
}

} // namespace
} // namespace spricka::report::test_writers
