// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/k_consistency.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_load_jumps {
namespace {

using test::solve_text;
using test::Solved;

// An edge crack of a = 0.3 in a strip of width 1, turned by an angle about its mouth; X runs along
// the crack from its mouth on.
std::string strip(const std::string& load, double turn = 0.0, const std::string& more = "") {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  t = {:.17g}
$MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=-2 LX=1 LY=4 NX=8 NY=32
$MATERIAL NAME=M E=1000 NU=0.3 ALPHA=1e-5
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN THICK=1
$NSET NAME=P1 WHERE=(abs(x-1) < 1e-9 and abs(y+2) < 1e-9)
$NSET NAME=P2 WHERE=(abs(x-1) < 1e-9 and abs(y-2) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  P1
$FREEDOM CLASS=SUPPRESSED DOF=X
  P2
{}
$CRACK NAME=C A0=0.3 ANGLE=(t)
  0 0
{}$STEP NAME=S
  LOAD L 1
$END
)",
                     turn, load, more);
}

std::string faces(const std::string& p) {
  return "$LOAD CASE=L TYPE=FACES\n  C (" + p + ")\n";
}

std::string heat(const std::string& T) {
  return "$LOAD CASE=L TYPE=TEMPERATURE\n  BODY (" + T + ")\n";
}

const results::FrontPointResult& tip(const std::optional<Solved>& solved) {
  return solved->step().fronts.at(0).single_point();
}

// What acts on the faces up to their end is what acts on all of them, wherever round-off sees the
// end: at the tip, beside it or beyond.
TEST(RoughLoads, PressureUpToTheTipIsPressureOnAllOfTheFaces) {
  for (const double turn : {0.0, 0.37}) {
    const auto all = solve_text(strip(faces("2"), turn));
    ASSERT_TRUE(all);
    for (const char* up_to :
         {"2*(x*cos(t)+y*sin(t) < 0.3)", "2*(x*cos(t)+y*sin(t) <= 0.3)",
          "2*(x*cos(t)+y*sin(t) < 0.3-1e-15)", "2*(x*cos(t)+y*sin(t) < 0.3+1e-14)"}) {
      const auto part = solve_text(strip(faces(up_to), turn));
      ASSERT_TRUE(part) << up_to;
      EXPECT_NEAR(tip(part).K1, tip(all).K1, 1e-6 * tip(all).K1) << up_to;
      EXPECT_NEAR(tip(part).K2, tip(all).K2, 1e-6 * tip(all).K1) << up_to;
      EXPECT_NEAR(tip(part).T, tip(all).T, 1e-5) << up_to;
      EXPECT_NEAR(tip(part).G, tip(all).G, 2e-3 * tip(all).G) << up_to;
    }
  }
}

// The sum of pressures on two parts of the faces is that on all, and no part is called doubtful:
// what a step does to G is no error of K.
TEST(RoughLoads, StepsOfPressureNearATipBlameNoK) {
  const auto all = solve_text(strip(faces("1")));
  ASSERT_TRUE(all);
  for (const double at : {0.2, 0.25, 0.28, 0.29, 0.299}) {
    const auto inner = solve_text(strip(faces(fmt::format("x > {}", at))));
    const auto outer = solve_text(strip(faces(fmt::format("x <= {}", at))));
    ASSERT_TRUE(inner && outer);
    EXPECT_NEAR(tip(inner).K1 + tip(outer).K1, tip(all).K1, 1e-4 * tip(all).K1) << at;
    EXPECT_EQ(sense::describe_k_mismatch(inner->step(), inner->step().fronts.at(0)), "") << at;
    EXPECT_EQ(sense::describe_k_mismatch(outer->step(), outer->step().fronts.at(0)), "") << at;
  }
}

// A temperature that jumps along a line acts on a crack as a pressure there (Bueckner): a strip
// that is free to bend has it less what bends and stretches it.
TEST(RoughLoads, StepsOfTemperatureNearATipBlameNoK) {
  const double stress = 1000.0 * 1e-5 * 100.0 / (1.0 - 0.3); // E alpha T / (1 - nu)
  for (const double at : {0.2, 0.25, 0.3, 0.30000001}) {
    const double n = 1.0 - at;
    const double bend = 12.0 * (0.5 * (1.0 - at * at) - 0.5 * n);
    const auto hot = solve_text(strip(heat(fmt::format("100*(x > {})", at))));
    const auto pressed = solve_text(strip(faces(
        fmt::format("{:.17g}*({:.17g}+{:.17g}*x-(x > {}))", stress, n - 0.5 * bend, bend, at))));
    ASSERT_TRUE(hot && pressed);
    EXPECT_EQ(sense::describe_k_mismatch(hot->step(), hot->step().fronts.at(0)), "") << at;
    EXPECT_NEAR(tip(hot).K1, tip(pressed).K1, 3e-3 * tip(pressed).K1) << at;
  }
}

// Closed faces have no K1, and no K2 but round-off or what slides: G has nothing to add.
TEST(RoughLoads, ClosedCracksBlameNoK) {
  for (const std::string& load :
       {faces("-1"), heat("100*(x < 0.35)"), heat("100*(x < 0.35)+20*y"),
        std::string("$LOAD CASE=L TYPE=TRACTION\n  YMAX 0 -1\n  YMIN 0 1\n")}) {
    const auto closed = solve_text(strip(load));
    ASSERT_TRUE(closed) << load;
    EXPECT_TRUE(tip(closed).closed) << load;
    EXPECT_EQ(tip(closed).K1, 0.0) << load;
    EXPECT_EQ(sense::describe_k_mismatch(closed->step(), closed->step().fronts.at(0)), "") << load;
  }
}

} // namespace
} // namespace spricka::test_load_jumps
