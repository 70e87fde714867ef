// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/run_text.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_corner_bars {
namespace {

using test::solve_text;

const std::string head = "$DECK VERSION=1 LENGTH=mm FORCE=N\n";

std::string block(int fine, const std::string& type) {
  return head + fmt::format("$MESH SHAPE=BLOCK TYPE={} LX=2 LY=1 NX={} NY={}\n", type, 12 * fine,
                            6 * fine);
}

std::string rest(double nu, const std::string& supports, const std::string& crack) {
  return fmt::format("$MATERIAL NAME=M E=1000 NU={}\n$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN\n",
                     nu) +
         supports + crack + "$LOAD CASE=T TYPE=TRACTION\n  XMAX 0.2 1\n$STEP NAME=S\n  LOAD T 1\n";
}

const std::string clamp = "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  XMIN\n";
const std::string beside = "$CRACK NAME=C\n  0.2 0\n  0.2 0.2\n";

struct Case {
  double nu;
  std::string supports;
};

// The bar of K beside a clamped corner, and beside the end of a support on a straight side, holds
// the value of much finer meshes and is not much larger than the error. Cubics alone see a third of
// it there, and less where the material hardly changes its volume.
TEST(CornerBars, HoldBesideClampedCornersAndEndsOfSupports) {
  const std::string foot = "$NSET NAME=FOOT WHERE=(abs(y-1) < 1e-9 and x < 0.5+1e-9)\n"
                           "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  FOOT\n";
  for (const Case& c : {Case{0.3, clamp}, Case{0.47, clamp}, Case{0.3, foot}}) {
    const auto fine =
        solve_text(block(8, "QUAMC9") + rest(c.nu, c.supports, beside) +
                   "$TIPNET CRACK=C SIZE=0.004 RADIUS=0.04 RINGS=8 SECTORS=32\n$END\n");
    ASSERT_TRUE(fine);
    const results::FrontPointResult& truth = fine->step().fronts.at(0).single_point();
    for (const char* type : {"QUAMC8", "TRIMC6"}) {
      const auto coarse = solve_text(block(2, type) + rest(c.nu, c.supports, beside) + "$END\n");
      ASSERT_TRUE(coarse);
      const results::FrontResult& front = coarse->step().fronts.at(0);
      ASSERT_EQ(front.missing_bar_reason, "");
      const double error = std::abs(truth.bar[0].best - front.single_point().K1);
      EXPECT_LE(error, front.single_point().bar[0].size()) << c.nu << ' ' << type;
      const double raw = std::abs(truth.K1 - front.single_point().raw_K()[0]);
      EXPECT_GE(1.5 * raw, front.single_point().bar[0].size()) << c.nu << ' ' << type;
    }
  }
}

// A third support of a single node is no support of a body: how far it gives way depends on the
// mesh without end, and so does K. Two, which only keep the body from turning, do no harm.
TEST(CornerBars, AreRefusedWhereKHangsOnSingleNodes) {
  const std::string three = "$NSET NAME=A WHERE=(abs(y) < 1e-9 and abs(x-0.5) < 1e-9)\n"
                            "$NSET NAME=B WHERE=(abs(y) < 1e-9 and abs(x-1) < 1e-9)\n"
                            "$NSET NAME=D WHERE=(abs(y) < 1e-9 and abs(x-1.5) < 1e-9)\n"
                            "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  A B D\n";
  const std::string crack = "$CRACK NAME=C\n  0.75 0\n  0.75 0.3\n";
  const auto held = solve_text(block(2, "QUAMC8") + rest(0.3, three, crack) + "$END\n");
  ASSERT_TRUE(held);
  EXPECT_NE(held->step().fronts.at(0).missing_bar_reason.find("single node"), std::string::npos);
  const std::string two =
      "$NSET NAME=A WHERE=(abs(y) < 1e-9 and abs(x-0.5) < 1e-9)\n"
      "$NSET NAME=B WHERE=(abs(y) < 1e-9 and abs(x-1.5) < 1e-9)\n"
      "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  A\n$FREEDOM CLASS=SUPPRESSED DOF=Y\n  B\n";
  const auto stands = solve_text(block(2, "QUAMC8") + rest(0.3, two, crack) + "$END\n");
  ASSERT_TRUE(stands);
  EXPECT_EQ(stands->step().fronts.at(0).missing_bar_reason, "");
}

std::string two_bodies(const std::string& loads) {
  return head +
         "$NET NAME=P\n  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=1 LY=1 NX=8 NY=8\n$ENDNET\n"
         "$NET NAME=Q\n  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=3 LX=1 LY=1 NX=8 NY=8\n$ENDNET\n"
         "$MATERIAL NAME=M E=1000 NU=0.3\n"
         "$PROPERTY ESET=P.BODY MATERIAL=M STATE=STRAIN\n"
         "$PROPERTY ESET=Q.BODY MATERIAL=M STATE=STRAIN\n"
         "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  P.YMIN\n  Q.YMIN\n"
         "$CRACK NAME=C NET=P\n  0 0.5\n  0.3 0.5\n$CRACK NAME=D NET=Q\n  3 0.5\n  3.3 0.6\n"
         "$LOAD CASE=T TYPE=TRACTION\n  Q.YMAX 0 1\n  P.YMAX 0 1\n"
         "$LOAD CASE=U TYPE=TRACTION\n  P.YMAX 0 1\n" +
         loads + "$END\n";
}

// Round-off of a body that nothing loads is no K: 0, without bars of 1e-30 and without warnings.
TEST(CornerBars, ABodyThatNothingLoadsHasKOfZero) {
  const auto solved = solve_text(
      two_bodies("$STEP NAME=BOTH\n  LOAD T 1\n$STEP NAME=ONE\n  LOAD T 0\n  LOAD U 1\n"));
  ASSERT_TRUE(solved);
  const results::LoadStepResult& one = solved->run.increments.front().steps.at(1);
  const results::FrontResult& idle = one.fronts.at(1);
  EXPECT_EQ(idle.single_point().K1, 0.0);
  EXPECT_EQ(idle.single_point().K2, 0.0);
  EXPECT_EQ(idle.missing_bar_reason, "");
  EXPECT_EQ(idle.single_point().bar[1].size(), 0.0);
  for (const std::string& note : results::text_with_code(one.notes)) {
    EXPECT_EQ(note.find("warning"), std::string::npos) << note;
  }
}

// K1 that is nothing beside K2 may have either sign: it keeps its bar. One that counts is no
// answer.
TEST(CornerBars, ASmallNegativeK1BesideK2HasOne) {
  const auto plate = [](double pressed) {
    return head +
           "$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-3 Y0=-3 LX=6 LY=6 NX=10 NY=10\n"
           "$MATERIAL NAME=M E=1000 NU=0.3\n$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS\n"
           "$NSET NAME=A WHERE=(abs(x+3) < 1e-9 and abs(y) < 1e-9)\n"
           "$NSET NAME=B WHERE=(abs(x-3) < 1e-9 and abs(y) < 1e-9)\n"
           "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  A\n$FREEDOM CLASS=SUPPRESSED DOF=Y\n  B\n"
           "$CRACK NAME=C FACES=FREE\n  -0.5 0\n  0.5 0\n$LOAD CASE=T TYPE=TRACTION\n" +
           fmt::format("  XMAX 0 1\n  XMIN 0 -1\n  YMAX 1 {}\n  YMIN -1 {}\n", -pressed, pressed) +
           "$STEP NAME=S\n  LOAD T 1\n$END\n";
  };
  const auto hardly = solve_text(plate(5e-5));
  ASSERT_TRUE(hardly);
  const results::FrontResult& front = hardly->step().fronts.at(0);
  EXPECT_LT(front.single_point().K1, 0.0);
  EXPECT_GT(front.single_point().K1, -2e-4 * std::abs(front.single_point().K2));
  EXPECT_EQ(front.missing_bar_reason, "");
  EXPECT_GE(front.single_point().bar[0].size(), 5e-5 * std::abs(front.single_point().K2));
  const auto much = solve_text(plate(0.1));
  ASSERT_TRUE(much);
  EXPECT_NE(much->step().fronts.at(0).invalid_reason, "");
}

} // namespace
} // namespace spricka::test_corner_bars
