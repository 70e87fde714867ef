// SPDX-License-Identifier: GPL-3.0-or-later
// Fronts that leave the body off its normal: parts of their domains lie beyond their ends.
#include "tests/unit/support/solved_text.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_leaning_fronts {
namespace {

// A plate 4 thick with an edge crack, whose front is an arc of radius 3: it leaves both faces 42
// degrees off their normal.
std::string bulging_front() {
  std::string points;
  for (int i = 0; i < 15; ++i) {
    const double z = -0.4 + 4.8 * i / 14;
    points += fmt::format("  0 {} {}\n", 3.0 + std::sqrt(9.0 - (z - 2.0) * (z - 2.0)), z);
  }
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=TET10 X0=-8 Y0=0 Z0=0 LX=16 LY=14 LZ=4 NX=4 NY=4 NZ=1
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID
$NSET NAME=P1 WHERE=(x < -8 + 1e-6 and y > 14 - 1e-6 and z < 1e-6)
$NSET NAME=P2 WHERE=(x < -8 + 1e-6 and y < 1e-6 and z < 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=X
  XMIN
$FREEDOM CLASS=SUPPRESSED DOF=YZ
  P1
$FREEDOM CLASS=SUPPRESSED DOF=Z
  P2
$LOAD CASE=PULL TYPE=TRACTION
  XMAX  1 0 0
$CRACK NAME=C X0=0 Y0=1 Z0=2
)" + points +
         "$STEP NAME=S\n  LOAD PULL 1\n$END\n";
}

// G does not know the partners, K is nothing else: were the axes to go on straight beyond the ends,
// the two would be 4 % of K apart beside them and 15 % at them.
TEST(LeaningFronts, HaveOneKByBothWays) {
  const auto solved = test::solve_text(bulging_front());
  ASSERT_TRUE(solved);
  const results::FrontResult& front = solved->step().fronts.at(0);
  ASSERT_GE(front.points.size(), 9U);
  for (const results::FrontPointResult& at : front.points) {
    const double ratio = std::sqrt(at.G / at.G_from_K);
    EXPECT_NEAR(ratio, 1.0, at.at_surface ? 0.05 : 0.012) << at.number;
    EXPECT_LT(at.spread, 0.012) << at.number;
  }
}

} // namespace
} // namespace spricka::test_leaning_fronts
