// SPDX-License-Identifier: GPL-3.0-or-later
// The size that a front in space is told with.
#include "tests/unit/support/solved_text.hpp"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_front_size {
namespace {

// A crack through a block of 1 x 1 x 2 from its side x = 0, drawn by points.
std::string through(double depth) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE=HEXEC20 X0=0 Y0=0 Z0=-1 LX=1 LY=1 LZ=2 NX=3 NY=3 NZ=6
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  B.ZMIN
$CRACK NAME=C NET=B X0={0} Y0=0.5 Z0=0
  {1} -0.2 0
  {1}  0.5 0
  {1}  1.2 0
$LOAD CASE=PULL TYPE=TRACTION
  B.ZMAX 0 0 1
$STEP NAME=S
  LOAD PULL 1
$END
)",
                     0.5 * depth, depth);
}

// Of a straight front through a plate the size is the depth of the crack, as in the plane.
TEST(FrontSize, OfAStraightFrontIsTheDepth) {
  for (const double depth : {0.3, 0.45}) {
    const auto solved = test::solve_text(through(depth));
    ASSERT_TRUE(solved);
    const results::FrontResult& front = solved->step().fronts.front();
    EXPECT_NEAR(front.a, depth, 1e-9);
    EXPECT_NEAR(front.length, 1.0, 1e-9);
  }
}

} // namespace
} // namespace spricka::test_front_size
