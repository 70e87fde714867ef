// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/library/spricka.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

// What another program gets of a deck by the public header alone.
namespace spricka::test_library {
namespace {

// A strip with an edge crack in its middle, benchmark F01, pulled by the parameter s.
std::string strip(const std::string& more = "") {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  s = 100
$MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=-2 LX=1 LY=4 NX=3 NY=12
$MATERIAL NAME=M E=210000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$NSET NAME=MIDDLE WHERE=(abs(x - 1) < 1e-6 and abs(y) < 1e-6)
$NSET NAME=TOP WHERE=(abs(x - 1) < 1e-6 and abs(y - 2) < 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  MIDDLE
$FREEDOM CLASS=SUPPRESSED DOF=X
  TOP
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 0 (s)
  YMIN 0 (-s)
$CRACK NAME=C
  0   0
  0.5 0
$STEP NAME=PULL
  LOAD PULL 1
)" + more +
         "$END\n";
}

DeckSolution solve_text(const std::string& text,
                        const std::vector<std::pair<std::string, std::string>>& parameters = {}) {
  DeckToSolve deck;
  deck.text = text;
  deck.parameters = parameters;
  deck.threads = 1;
  return solve_deck(deck);
}

TEST(Library, FindsKOfADeckThatIsInNoFile) {
  const DeckSolution found = solve_text(strip());
  ASSERT_EQ(found.status, SolutionStatus::solved);
  EXPECT_EQ(found.K_unit, "MPa*mm^0.5");
  ASSERT_EQ(found.K.size(), 1U);
  const StressIntensityFactors& tip = found.K.front();
  EXPECT_EQ(tip.step, "PULL");
  EXPECT_EQ(tip.crack, "C");
  EXPECT_NEAR(tip.x[0], 0.5, 1e-12);
  const double exact = 2.824579 * 100.0 * std::sqrt(std::numbers::pi * 0.5);
  EXPECT_NEAR(tip.K[0], exact, tip.bar[0] + 1e-4 * exact);
  EXPECT_LT(tip.bar[0], 0.01 * exact);
  EXPECT_FALSE(std::filesystem::exists("deck.run"));
}

TEST(Library, TakesParametersAsTheCommandLineDoes) {
  const DeckSolution one = solve_text(strip());
  const DeckSolution two = solve_text(strip(), {{"s", "0.2[GPa]"}});
  ASSERT_EQ(one.K.size(), 1U);
  ASSERT_EQ(two.K.size(), 1U);
  EXPECT_NEAR(two.K[0].K[0], 2.0 * one.K[0].K[0], 1e-9 * one.K[0].K[0]);
}

TEST(Library, SaysWhatIsWrongAndWhere) {
  std::string text = strip();
  text.replace(text.find("STATE=STRAIN"), 12, "STATE=STRAN ");
  const DeckSolution found = solve_text(text);
  EXPECT_EQ(found.status, SolutionStatus::deck_error);
  ASSERT_FALSE(found.messages.empty());
  const SolutionMessage& message = found.messages.front();
  EXPECT_EQ(message.severity, MessageSeverity::error);
  EXPECT_EQ(message.code, "E108");
  EXPECT_EQ(message.line, 6U);
  EXPECT_NE(message.hint.find("STRAIN"), std::string::npos) << message.hint;
}

TEST(Library, TellsOfChecksFilesAndSweeps) {
  const DeckSolution missed = solve_text(strip("$CHECK\n  K1(C,PULL) = 1  REL 0.01  SOURCE 'x'\n"));
  EXPECT_EQ(missed.status, SolutionStatus::check_failed);
  EXPECT_EQ(missed.K.size(), 1U);
  ASSERT_FALSE(missed.messages.empty());
  EXPECT_NE(missed.messages.back().text.find("check failed: K1(C,PULL)"), std::string::npos);

  DeckToSolve nowhere;
  nowhere.file = "no_such.deck";
  EXPECT_EQ(solve_deck(nowhere).status, SolutionStatus::file_trouble);

  const DeckSolution sweep = solve_text(strip("$SWEEP PARAMETER=s\n  50 100\n"));
  EXPECT_EQ(sweep.status, SolutionStatus::invalid_request);
  EXPECT_TRUE(sweep.K.empty());
}

} // namespace
} // namespace spricka::test_library
