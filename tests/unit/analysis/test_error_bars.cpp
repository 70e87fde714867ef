// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_error_bars {
namespace {

using test::solve_text;
using test::Solved;

const std::string head = "$DECK VERSION=1 LENGTH=mm FORCE=N\n";
const std::string stuff = R"($MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=STRAIN
$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=STRAIN
$NSET NAME=HELD WHERE=(abs(y) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  HELD
$CRACK NAME=C NET=LOW
  0  1
  0.4  1.1
$LOAD CASE=PULL TYPE=TRACTION
  TOP.YMAX  0.2  1
)";
const std::string step = "$STEP NAME=PULL\n  LOAD PULL 1\n$END\n";

std::string strip(const std::string& type, int top, const std::string& more) {
  return head +
         fmt::format("$NET NAME=LOW\n  $MESH SHAPE=BLOCK TYPE={0} LX=1 LY=2 NX=4 NY=8\n$ENDNET\n"
                     "$NET NAME=TOP\n  $MESH SHAPE=BLOCK TYPE={0} Y0=2 LX=1 LY=1 NX={1} "
                     "NY={1}\n$ENDNET\n",
                     type, top) +
         stuff + more + step;
}

std::string whole(const std::string& type) {
  std::string text =
      head +
      fmt::format("$NET NAME=LOW\n  $MESH SHAPE=BLOCK TYPE={} LX=1 LY=3 NX=4 NY=12\n$ENDNET\n",
                  type) +
      stuff + step;
  const std::string property = "$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=STRAIN\n";
  text.erase(text.find(property), property.size());
  text.replace(text.find("TOP.YMAX"), 8, "LOW.YMAX");
  return text;
}

const results::FrontResult& front_of(const Solved& solved) {
  return solved.step().fronts.at(0);
}

class Bars : public testing::TestWithParam<const char*> {};

// A strip of two bonded or tied pieces whose meshes match is the strip in one piece, and so is its
// error: edges of the joint share their modes.
TEST_P(Bars, DoNotSeeAJointOfMatchingMeshes) {
  const auto one = solve_text(whole(GetParam()));
  ASSERT_TRUE(one);
  const results::FrontResult& front = front_of(*one);
  ASSERT_EQ(front.missing_bar_reason, "");
  EXPECT_GT(front.single_point().bar[0].mesh, 1e-5 * front.single_point().K1);
  for (const char* joint : {"$CONTACT NAME=J SLAVE=TOP.YMIN MASTER=LOW.YMAX TYPE=BONDED GAP=0\n",
                            "$CONTACT NAME=J SLAVE=LOW.YMAX MASTER=TOP.YMIN TYPE=BONDED GAP=0 "
                            "PAIRING=NODE\n",
                            "$MPC TYPE=TRANSITION SLAVE=TOP.YMIN MASTER=LOW.YMAX\n"}) {
    const auto two = solve_text(strip(GetParam(), 4, joint));
    ASSERT_TRUE(two);
    const results::FrontResult& other = front_of(*two);
    ASSERT_EQ(other.missing_bar_reason, "") << joint;
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(other.single_point().bar[k].eta, front.single_point().bar[k].eta,
                  0.01 * std::abs(front.single_point().bar[0].eta))
          << joint;
    }
  }
}

// Meshes of the joint that do not match: the bar holds the value of the strip in one piece with a
// finer mesh all the same.
TEST_P(Bars, HoldTheTruthOfAFinerMesh) {
  std::string fine = whole(GetParam());
  fine.replace(fine.find("NX=4 NY=12"), 10, "NX=16 NY=48");
  fine.insert(fine.find("$LOAD"), "$TIPNET CRACK=C SIZE=0.005 RADIUS=0.1 RINGS=12 SECTORS=48\n");
  const auto truth = solve_text(fine);
  ASSERT_TRUE(truth);
  for (const int top : {3, 4, 7}) {
    const auto found = solve_text(strip(
        GetParam(), top, "$CONTACT NAME=J SLAVE=TOP.YMIN MASTER=LOW.YMAX TYPE=BONDED GAP=0\n"));
    ASSERT_TRUE(found);
    const results::FrontResult& front = front_of(*found);
    EXPECT_LT(std::abs(front.single_point().K1 - front_of(*truth).single_point().bar[0].best),
              front.single_point().bar[0].size())
        << top;
    EXPECT_LT(std::abs(front.single_point().K2 - front_of(*truth).single_point().bar[1].best),
              front.single_point().bar[1].size())
        << top;
    EXPECT_LT(
        std::abs(front.single_point().bar[0].best - front_of(*truth).single_point().bar[0].best),
        0.5 * std::abs(front.single_point().raw_K()[0] - front_of(*truth).single_point().K1))
        << top;
  }
}

// The same where the upper piece lies on the lower one without friction and is pressed on it at its
// right, so that the joint gapes at its left.
TEST_P(Bars, HoldTheTruthOfAPressedJoint) {
  const std::string joint = "$CONTACT NAME=J SLAVE=TOP.YMIN MASTER=LOW.YMAX GAP=0\n"
                            "$FREEDOM CLASS=SUPPRESSED DOF=X\n  TOP.YMAX\n";
  const auto bent = [&](int top) {
    std::string text = strip(GetParam(), top, joint);
    return text.replace(text.find("0.2  1"), 6, "0  (1.4-4.8*x)");
  };
  std::string fine = bent(24);
  fine.replace(fine.find("NX=4 NY=8"), 9, "NX=24 NY=48");
  fine.insert(fine.find("$LOAD"), "$TIPNET CRACK=C SIZE=0.005 RADIUS=0.1 RINGS=12 SECTORS=48\n");
  const auto truth = solve_text(fine);
  ASSERT_TRUE(truth);
  for (const int top : {4, 9}) {
    const auto found = solve_text(bent(top));
    ASSERT_TRUE(found);
    const results::FrontResult& front = front_of(*found);
    ASSERT_EQ(front.missing_bar_reason, "");
    EXPECT_GT(front.single_point().bar[0].edge, 0.0);
    EXPECT_LT(std::abs(front.single_point().K1 - front_of(*truth).single_point().bar[0].best),
              front.single_point().bar[0].size())
        << top;
    EXPECT_LT(std::abs(front.single_point().K2 - front_of(*truth).single_point().bar[1].best),
              front.single_point().bar[1].size())
        << top;
  }
}

INSTANTIATE_TEST_SUITE_P(Types, Bars, testing::Values("TRIMC6", "QUAMC8", "QUAMC9"));

TEST(TipErrorBars, AreTheSameOnAnyNumberOfThreads) {
  const std::string deck =
      strip("QUAMC8", 5, "$CONTACT NAME=J SLAVE=TOP.YMIN MASTER=LOW.YMAX TYPE=BONDED GAP=0\n");
  const auto one = solve_text(deck, 1);
  const auto three = solve_text(deck, 3);
  ASSERT_TRUE(one && three);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(front_of(*one).single_point().bar[k].size(),
              front_of(*three).single_point().bar[k].size());
    EXPECT_EQ(front_of(*one).single_point().bar[k].best,
              front_of(*three).single_point().bar[k].best);
    EXPECT_EQ(front_of(*one).single_point().bar[k].of_element,
              front_of(*three).single_point().bar[k].of_element);
  }
}

TEST(TipErrorBars, AreRefusedWithTheirReasonOnce) {
  std::string linear = whole("QUAMC8");
  linear.replace(
      linear.find("$ENDNET"), 7,
      "$ENDNET\n$NET NAME=SIDE\n  $MESH SHAPE=BLOCK TYPE=QUAM4 X0=5 LX=1 LY=1 NX=2 NY=2\n$ENDNET\n"
      "$NSET NAME=REST WHERE=(x > 4)\n$FREEDOM CLASS=SUPPRESSED DOF=XY\n  REST\n");
  linear.replace(linear.find("$PROPERTY"), 9,
                 "$PROPERTY ESET=SIDE.BODY MATERIAL=M STATE=STRAIN\n$PROPERTY");
  const auto found = solve_text(linear);
  ASSERT_TRUE(found);
  EXPECT_EQ(front_of(*found).missing_bar_reason, "some elements are linear");
  const auto told = [](const Solved& solved) {
    int count = 0;
    for (const std::string& note : results::text_with_code(solved.step().notes)) {
      count += note.find("has no error bar") != std::string::npos ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(told(*found), 1);
  std::string rubs =
      strip("QUAMC8", 4, "$CONTACT NAME=J SLAVE=TOP.YMIN MASTER=LOW.YMAX MU=0.5 GAP=0\n");
  rubs.replace(rubs.find("0.2  1"), 6, "0  (1.4-4.8*x)"); // bends the crack open
  const auto rubbing = solve_text(rubs);
  ASSERT_TRUE(rubbing);
  EXPECT_GT(front_of(*rubbing).single_point().K1, 0.0);
  EXPECT_NE(front_of(*rubbing).missing_bar_reason.find("rub"), std::string::npos)
      << front_of(*rubbing).missing_bar_reason;
  EXPECT_EQ(told(*rubbing), 1);
}

// The sum of the bar's parts and raw K by $CHECK.
TEST(TipErrorBars, AreQuantitiesOfChecks) {
  const std::string deck = whole("QUAMC9");
  const auto first = solve_text(deck);
  ASSERT_TRUE(first);
  const results::KErrorBar& bar = front_of(*first).single_point().bar[0];
  EXPECT_NEAR(bar.size(), bar.mesh + bar.edge + bar.floor, 1e-15);
  const double raw = front_of(*first).single_point().raw_K()[0];
  EXPECT_EQ(bar.best, front_of(*first).single_point().K1);
  EXPECT_NE(bar.best, raw);
  const std::string check =
      fmt::format("$CHECK\n  K1.BAR(C,PULL) = {:.12g} REL 1e-9\n  K1.RAW(C,PULL) = {:.12g} REL "
                  "1e-9\n  K2.BAR(C,PULL) = 0 ABS 1\n$END\n",
                  bar.size(), raw);
  std::string checked = deck;
  checked.replace(checked.find("$END\n", checked.find("$STEP")), 5, check);
  const test::Folder folder;
  EXPECT_EQ(test::run_text(folder, checked).exit_code, 0);
}

} // namespace
} // namespace spricka::test_error_bars
