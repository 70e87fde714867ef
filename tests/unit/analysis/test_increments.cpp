// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <cmath>

#include <fmt/format.h>

namespace spricka::test_increments {
namespace {

// A crowned block pressed on a flat one and pushed aside at the same time: contact widens while it
// slips, so that the shear depends on the way. `steps`: keys of $STEP.
std::string crown(const std::string& steps, double push = 0.15, const std::string& pairing = "") {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$RIGID NAME=ROLL SHAPE=ARC X0=0 Y0=41 R=40
$MESH SHAPE=BLOCK TYPE=QUAM4 X0=-4 LX=8 LY=1 NX=64 NY=6
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN THICK=1
$FREEDOM CLASS=PRESCRIBED DOF=XY
  YMIN
$LOAD CASE=UP TYPE=DISP
  YMIN {} 0.08
$CONTACT NAME=C SLAVE=YMAX MASTER=ROLL MU=0.3 {}
$STEP NAME=S {}
  LOAD UP 1
$END
)",
                     0.08 * push, pairing, steps);
}

double apart(const results::ContactResult& a, const results::ContactResult& b) {
  double change = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    change += std::pow(a.points[i].q_consistent - b.points[i].q_consistent, 2);
    all += std::pow(b.points[i].q_consistent, 2);
  }
  return std::sqrt(change / all);
}

std::string notes_of(const test::Solved& s) {
  std::string all;
  for (const std::string& note : results::text_with_code(s.step().notes)) {
    all += note + "\n";
  }
  return all;
}

// One increment is far off; the program cuts the step until 1 % is left, and says how far it went.
TEST(Increments, AStepIsCutUntilItsShearIsRight) {
  for (const char* pairing : {"PAIRING=SEGMENT", "PAIRING=NODE"}) {
    for (const double push : {0.3, 0.6, 1.2}) {
      SCOPED_TRACE(fmt::format("{} {}", pairing, push));
      const auto exact = test::solve_text(crown("SUBSTEPS=256", push, pairing));
      const auto one = test::solve_text(crown("SUBSTEPS=1", push, pairing));
      const auto own = test::solve_text(crown("", push, pairing));
      ASSERT_TRUE(exact && one && own);
      const results::ContactResult& truth = exact->step().contacts[0];
      const double off = apart(one->step().contacts[0], truth);
      EXPECT_LT(apart(own->step().contacts[0], truth), 0.02);
      EXPECT_GT(own->step().increments, off > 0.02 ? 2 : 1);
      if (off > 0.08) { // told, and within a factor of two and a half
        EXPECT_NE(notes_of(*one).find("warning W507: SUBSTEPS=1"), std::string::npos)
            << notes_of(*one);
        const std::string text = notes_of(*one);
        const std::size_t at = text.find("about ");
        ASSERT_NE(at, std::string::npos);
        const double told = std::stod(text.substr(at + 6));
        EXPECT_GT(told, 40.0 * off);
        EXPECT_LT(told, 250.0 * off);
      }
    }
  }
}

// Given SUBSTEPS are kept, and the error that they leave falls with their number.
TEST(Increments, GivenSubstepsAreKept) {
  const auto s = test::solve_text(crown("SUBSTEPS=7", 0.6));
  ASSERT_TRUE(s);
  EXPECT_EQ(s->step().increments, 7);
}

// A step in which nothing slips needs no more than the two walks that show it.
TEST(Increments, StickingNeedsNoCuts) {
  const auto s = test::solve_text(crown("", 0.0));
  ASSERT_TRUE(s);
  EXPECT_LE(s->step().increments, 64);
  EXPECT_EQ(notes_of(*s).find("other solutions"), std::string::npos);
}

TEST(Increments, AStepWithoutFrictionIsSolvedAtOnce) {
  std::string deck = crown("", 0.3);
  deck.replace(deck.find("MU=0.3"), 6, "");
  const auto s = test::solve_text(deck);
  ASSERT_TRUE(s);
  EXPECT_EQ(s->step().increments, 1);
}

// The same bits whatever stands before: an earlier step cut in another way.
TEST(Increments, TheSameDeckTwiceGivesTheSameBits) {
  const auto a = test::solve_text(crown("", 0.6));
  const auto b = test::solve_text(crown("", 0.6));
  ASSERT_TRUE(a && b);
  EXPECT_TRUE((a->step().u.array() == b->step().u.array()).all());
}

} // namespace
} // namespace spricka::test_increments
