// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_coarse_surface_effect {
namespace {

using test::solve_text;
using test::Solved;

const std::string head = "$DECK VERSION=1 LENGTH=mm FORCE=N\n";

// Two blocks on each other; a crack in the upper one, `gap` above the joint, whose lower half has
// n elements on its side.
std::string two_blocks(const std::string& joint, int n, double gap, const std::string& more = "") {
  return head + fmt::format(R"($NET NAME=P
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-1 LX=2 LY=1 NX=16 NY=8
$ENDNET
$NET NAME=Q
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-1 Y0=-1 LX=2 LY=1 NX={} NY={}
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=P.BODY MATERIAL=M STATE=STRAIN THICK=1
$PROPERTY ESET=Q.BODY MATERIAL=M STATE=STRAIN THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  Q.YMIN
{}
$CRACK NAME=C NET=P A0=0.2 ANGLE=0
  -1 {}
{}$STEP NAME=S
  LOAD T 1
$END
)",
                            n, n / 2, joint, gap, more);
}

const std::string pull = "$LOAD CASE=T TYPE=TRACTION\n  P.XMAX 1 0\n  P.YMAX 0 1\n";
const std::string bonded = "$CONTACT NAME=CC SLAVE=P.YMIN MASTER=Q.YMAX TYPE=BONDED\n" + pull;
const std::string pressed = "$FREEDOM CLASS=SUPPRESSED DOF=X\n  P.XMAX\n"
                            "$CONTACT NAME=CC SLAVE=P.YMIN MASTER=Q.YMAX MU=0\n"
                            "$LOAD CASE=T TYPE=PRESSURE\n  P.YMAX 1\n"
                            "$LOAD CASE=T TYPE=FACES\n  C 2\n";
const std::string transition = "$MPC TYPE=TRANSITION SLAVE=P.YMIN MASTER=Q.YMAX\n" + pull;

const results::FrontResult& front(const std::optional<Solved>& solved) {
  return solved->step().fronts.at(0);
}

// A body whose edges are long against the distance of the tip beside it follows the crack too
// stiffly, which no estimate of the meshes sees: K is several bars off. No bar is better.
TEST(PartnerSurfaces, TakeTheBarWhereTheyAreTooCoarse) {
  for (const std::string& joint : {bonded, pressed, transition}) {
    const auto found = solve_text(two_blocks(joint, 16, 0.03));
    ASSERT_TRUE(found) << joint;
    EXPECT_NE(front(found).missing_bar_reason.find("long"), std::string::npos)
        << joint << front(found).missing_bar_reason;
    EXPECT_TRUE(std::ranges::any_of(found->step().notes, [](const results::Note& note) {
      return note.kind == base::ResultConcern::less_exact &&
             note.text.starts_with("K of C: edges of");
    })) << joint;
  }
  const auto tolerated = solve_text(two_blocks(bonded, 16, 0.03, "$TIPNET CRACK=C TOL=1e-3\n"));
  ASSERT_TRUE(tolerated);
  EXPECT_NE(front(tolerated).missing_bar_reason, "");
}

// Where they are finer the bar is there and holds what much finer ones give; a TRANSITION between
// equal meshes that becomes endlessly fine is a bond.
TEST(PartnerSurfaces, LeaveTheBarWhereTheyAreFine) {
  struct Case {
    std::string joint, limit;
    int n;
    double gap;
  };
  for (const Case& c : {Case{bonded, bonded, 20, 0.1}, Case{pressed, pressed, 20, 0.1},
                        Case{transition, bonded, 16, 0.08}}) {
    const auto fine = solve_text(two_blocks(c.limit, 128, c.gap));
    const auto found = solve_text(two_blocks(c.joint, c.n, c.gap));
    ASSERT_TRUE(fine && found) << c.joint;
    ASSERT_EQ(front(found).missing_bar_reason, "") << c.joint;
    const std::array<double, 2> K{front(found).single_point().K1, front(found).single_point().K2};
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LE(std::abs(K[k] - front(fine).single_point().bar[k].best),
                front(found).single_point().bar[k].size())
          << c.joint << k;
    }
  }
}

// A crack that starts in the joint and leaves it has its bar: its mouth is where they meet.
TEST(PartnerSurfaces, LeaveCracksThatStartInThem) {
  const std::string deck = two_blocks(bonded, 16, 0.0);
  std::string away = deck;
  away.replace(away.find("A0=0.2 ANGLE=0\n  -1 0"), 21, "A0=0.04 ANGLE=90[deg]\n  0 0");
  const auto found = solve_text(away);
  ASSERT_TRUE(found);
  EXPECT_EQ(front(found).missing_bar_reason.find("edges of"), std::string::npos)
      << front(found).missing_bar_reason;
}

// A block on a longer one, or a rigid part of its side, ends beside the crack: stresses have no
// bound there, and the bar knows.
TEST(PartnerSurfaces, EndsOfTiesAreInTheBar) {
  const auto deck = [](int fine, bool rigid) {
    const std::string lower =
        fmt::format("$NET NAME=P\n$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-2 Y0=-2 LX=4 LY=2 NX={} "
                    "NY={}\n$ENDNET\n$MATERIAL NAME=M E=1000 NU=0.3\n$PROPERTY ESET=P.BODY "
                    "MATERIAL=M STATE=STRAIN THICK=1\n",
                    16 * fine, 8 * fine);
    const std::string upper =
        fmt::format("$NET NAME=Q\n$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-1 LX=2 LY=1 NX={} NY={}\n"
                    "$ENDNET\n$PROPERTY ESET=Q.BODY MATERIAL=M STATE=STRAIN THICK=1\n$CONTACT "
                    "NAME=CC SLAVE=Q.YMIN MASTER=P.YMAX TYPE=BONDED\n",
                    8 * fine, 4 * fine);
    const std::string stiff = "$NSET NAME=RG FROM=P.YMAX WHERE=(abs(x) < 1+1e-9)\n"
                              "$MPC TYPE=RIGID SLAVE=RG\n";
    return head + lower + (rigid ? stiff : upper) +
           "$FREEDOM CLASS=SUPPRESSED DOF=X\n  P.XMIN\n$FREEDOM CLASS=SUPPRESSED DOF=Y\n  "
           "P.YMIN\n$LOAD CASE=T TYPE=TRACTION\n  P.XMAX 1 0\n" +
           fmt::format("$CRACK NAME=C NET=P A0={} ANGLE=-90[deg]\n  {} 0\n", rigid ? 0.2 : 0.1,
                       rigid ? 1.3 : 1.1) +
           "$STEP NAME=S\n  LOAD T 1\n$END\n";
  };
  for (const bool rigid : {false, true}) {
    const auto fine = solve_text(deck(6, rigid));
    const auto coarse = solve_text(deck(1, rigid));
    ASSERT_TRUE(fine && coarse);
    ASSERT_EQ(front(coarse).missing_bar_reason, "");
    EXPECT_LE(std::abs(front(coarse).single_point().K1 - front(fine).single_point().bar[0].best),
              front(coarse).single_point().bar[0].size())
        << rigid;
    EXPECT_LE(std::abs(front(coarse).single_point().K2 - front(fine).single_point().bar[1].best),
              front(coarse).single_point().bar[1].size())
        << rigid;
  }
}

} // namespace
} // namespace spricka::test_coarse_surface_effect
