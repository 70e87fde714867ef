// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Loads that do not fit the mesh: sets whose rim a crack's patch cuts, steps and peaks between
// nodes. Totals are exact, K that of a mesh that fits.
namespace spricka::test_loads_kept {
namespace {

using test::Folder;
using test::Outcome;
using test::run_text;
using test::solve_text;
using test::Solved;

// A plate 2 x 4 with a crack from its left side, held at the bottom; a part of it is loaded.
std::string hung_plate(const std::string& type, const std::string& set, const std::string& load) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE={} Y0=-2 LX=2 LY=4 NX=10 NY=20
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN THICK=3
$FREEDOM CLASS=SUPPRESSED DOF=XY
  YMIN
$ESET NAME=PART WHERE=({})
$CRACK NAME=C A0=0.47 ANGLE=10[deg] FACES=FREE
  0 0.07
{}
$STEP NAME=S
  LOAD L 1
$END
)",
                     type, set, load);
}

class PartOfAPlate : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Types, PartOfAPlate, testing::Values("QUAMC8", "QUAMC9", "TRIMC6"));

// Force and moment about the origin of a uniform weight on x > 0.4, y > -0.6, a region of host
// elements that the patch's elements do not follow.
TEST_P(PartOfAPlate, KeepsForceAndMoment) {
  for (const bool total : {false, true}) {
    const double area = 1.6 * 2.6;
    const double b = 5.0;
    const double weight = -b * area * 3.0;
    const auto solved = solve_text(
        hung_plate(GetParam(), "x > 0.4 and y > -0.6",
                   total ? fmt::format("$LOAD CASE=L TYPE=RESULTANT\n  PART 0 ({:.17g})", weight)
                         : fmt::format("$LOAD CASE=L TYPE=BODY\n  PART 0 (-{:.17g})", b)));
    ASSERT_TRUE(solved);
    const auto [force, moment] = solved->support();
    EXPECT_NEAR(force.x(), 0.0, 1e-9 * std::abs(weight));
    EXPECT_NEAR(force.y(), -weight, 1e-9 * std::abs(weight));
    EXPECT_NEAR(moment.z(), -weight * 1.2, 1e-9 * std::abs(weight));
  }
}

// The same of a part with a round rim: its area is that of the host's elements, whose sides bend.
TEST(PartOfARing, KeepsForce) {
  const auto solved = solve_text(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=RING TYPE=QUAMC8 RI=1 RO=3 NR=8 NT=32
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN THICK=2
$FREEDOM CLASS=SUPPRESSED DOF=XY
  OUTER
$ESET NAME=CORE WHERE=(rho < 1.5)
$CRACK NAME=C A0=0.6 ANGLE=0
  1 0
$LOAD CASE=L TYPE=BODY
  CORE 0 -5
$STEP NAME=S
  LOAD L 1
$END
)");
  ASSERT_TRUE(solved);
  // 32 sectors of quadratic arcs: their area by Simpson's rule, which is exact for it.
  const double half = std::numbers::pi / 32.0;
  const double bow = 4.0 / 3.0 * std::sin(half) - std::sin(half) * std::cos(half) / 3.0;
  const double area = 32.0 * bow * (1.5 * 1.5 - 1.0);
  EXPECT_NEAR(solved->support().first.y(), 5.0 * 2.0 * area, 1e-6 * 10.0 * area);
}

// Where the part is everything, its load is that on everything.
TEST(PartOfAPlate, ThatIsTheWholeIsTheWhole) {
  const auto part =
      solve_text(hung_plate("QUAMC8", "x > -1", "$LOAD CASE=L TYPE=BODY\n  PART 0 -5"));
  const auto whole =
      solve_text(hung_plate("QUAMC8", "x > 1", "$LOAD CASE=L TYPE=BODY\n  BODY 0 -5"));
  ASSERT_TRUE(part && whole);
  EXPECT_EQ(part->step().fronts[0].single_point().K1, whole->step().fronts[0].single_point().K1);
}

// Two parts that make the whole: K adds up, as do the two shares of every element.
TEST(PartOfAPlate, AndItsRestMakeTheWhole) {
  const std::string rest = "$ESET NAME=REST WHERE=(x > 0.4 or abs(y) > 0.6)\n";
  const auto of = [&](const std::string& lines) {
    const auto solved = solve_text(hung_plate("QUAMC8", "x < 0.4 and abs(y) < 0.6",
                                              rest + "$LOAD CASE=L TYPE=BODY\n" + lines));
    return solved ? solved->step().fronts[0].single_point() : results::FrontPointResult();
  };
  const results::FrontPointResult one = of("  PART 3 -5\n");
  const results::FrontPointResult other = of("  REST 3 -5\n");
  const results::FrontPointResult all = of("  BODY 3 -5\n");
  ASSERT_NE(all.K1, 0.0);
  for (const std::size_t mode : {0U, 1U}) {
    EXPECT_NEAR(one.raw_K()[mode] + other.raw_K()[mode], all.raw_K()[mode],
                1e-7 * std::abs(all.K1));
  }
  EXPECT_NEAR(one.G, one.G_from_K, 5e-3 * one.G);
}

// Pressure on the part x < s of a crack's faces. The mesh of the deck with edges along the crack,
// a node at the front and no patch is the reference.
std::string pressed_crack(const std::string& how, const std::string& pressure,
                          const std::string& state = "STRAIN", const std::string& tip = "") {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=-2 LX=1 LY=4 {}
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE={}
$NSET NAME=P1 WHERE=(abs(x-1) < 1e-9 and abs(y+2) < 1e-9)
$NSET NAME=P2 WHERE=(abs(x-1) < 1e-9 and abs(y-2) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  P1
$FREEDOM CLASS=SUPPRESSED DOF=X
  P2
$CRACK NAME=C A0=0.3 ANGLE=0 FACES=FREE
  0 0
{}
$LOAD CASE=L TYPE=FACES
  C ({})
$STEP NAME=S
  LOAD L 1
$END
)",
                     how, state, tip, pressure);
}

const std::string step_at = "max(0,{0}-x)/(abs(x-{0})+1e-12)";

TEST(PressureFront, IsWhereItIs) {
  const auto K = [](const std::string& pressure) {
    const auto solved = solve_text(pressed_crack("NX=10 NY=40", pressure));
    return solved ? solved->step().fronts[0].single_point() : results::FrontPointResult();
  };
  // K of a front is the integral of a smooth weight function: that up to s by pieces of it.
  double sum = 0.0;
  double before = 0.0;
  for (const double s : {0.03, 0.0517, 0.1, 0.1711, 0.24, 0.2999, 0.3}) {
    const results::FrontPointResult upto = K(fmt::format(fmt::runtime(step_at), s));
    const results::FrontPointResult piece =
        K(fmt::format("min({0}, {1})", fmt::format(fmt::runtime(step_at), s),
                      fmt::format("max(0,x-{0})/(abs(x-{0})+1e-12)", before)));
    sum += piece.K1;
    EXPECT_NEAR(sum, upto.K1, 1e-6 * upto.K1) << s;
    EXPECT_NEAR(upto.G, upto.G_from_K, 5e-3 * upto.G) << s;
    EXPECT_LT(upto.spread, 2e-3) << s;
    before = s;
  }
  EXPECT_NEAR(sum, K("1").K1, 5e-6 * sum);
}

// A thin skin of pressure at the mouth is a pair of forces there, whatever its profile.
TEST(PressureFront, AThinSkinIsAForce) {
  const auto K = [](const std::string& pressure) {
    const auto solved = solve_text(pressed_crack("NX=10 NY=40", pressure));
    return solved ? solved->step().fronts[0].single_point().K1 : 0.0;
  };
  const double one = K("exp(-x/0.0003)/0.0003");
  const double other = K("2/sqrt(pi)*exp(-(x/0.0002)^2)/0.0002");
  EXPECT_NEAR(one, other, 2e-3 * one);
}

TEST(Loads, BeyondTheRangeOfNumbersAreRefused) {
  const auto deck = [](const std::string& E, const std::string& traction,
                       const std::string& factor) {
    return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=2 LY=1 NX=4 NY=2
$MATERIAL NAME=M E={} NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  XMIN
$LOAD CASE=T TYPE=TRACTION
  XMAX ({}) 0
$STEP NAME=S
  LOAD T {}
$END
)",
                       E, traction, factor);
  };
  const auto exits = [&](const std::string& text) {
    const Folder folder;
    const Outcome outcome = run_text(folder, text);
    EXPECT_NE(outcome.messages.find("number"), std::string::npos) << outcome.messages;
    return outcome.exit_code;
  };
  EXPECT_EQ(exits(deck("1000", "1/(y-0.25)*0+1e308*y*1e10", "1")), 3);
  EXPECT_EQ(exits(deck("1000", "log(y-2)", "1")), 3);
  EXPECT_EQ(exits(deck("1000", "1e308", "10")), 4);
  EXPECT_EQ(exits(deck("1000", "1e155", "1")), 4);
  EXPECT_EQ(exits(deck("1e-99", "1e60", "1")), 4);
  const Folder folder;
  EXPECT_EQ(run_text(folder, deck("1000", "1e60", "1")).exit_code, 0);
}

TEST(Displacements, OfOneCaseAddUp) {
  const auto solved = solve_text(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=2 LY=1 NX=4 NY=2
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=X
  XMIN
$FREEDOM CLASS=SUPPRESSED DOF=Y
  YMIN
$FREEDOM CLASS=PRESCRIBED DOF=X
  XMAX
$FREEDOM CLASS=PRESCRIBED DOF=Y
  YMAX
$LOAD CASE=T TYPE=DISP
  XMAX 0.01 0
  YMAX 0 0.004
$LOAD CASE=T TYPE=DISP
  XMAX 0.02 0
$STEP NAME=S
  LOAD T 1
$END
)");
  ASSERT_TRUE(solved);
  const base::Vec3 corner = solved->u(solved->node_at({2.0, 1.0, 0.0}));
  EXPECT_NEAR(solved->u(solved->node_at({2.0, 0.5, 0.0})).x(), 0.03, 1e-12);
  EXPECT_NEAR(corner.y(), 0.004, 1e-12);
}

} // namespace
} // namespace spricka::test_loads_kept
