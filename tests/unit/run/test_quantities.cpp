// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_text.hpp"

namespace spricka {
namespace {

// A bar under tension: every quantity of $CHECK that has a closed form here.
TEST(Quantities, BarUnderTension) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=2 NX=5 NY=2
$MATERIAL NAME=M E=1000 NU=0.25
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=3
$FREEDOM CLASS=SUPPRESSED DOF=X
  XMIN
$NSET NAME=CORNER WHERE=(abs(x) < 1e-9 and abs(y) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  CORNER
$LOAD CASE=PULL TYPE=TRACTION
  XMAX 4 0
$STEP NAME=HALF
  LOAD PULL 0.5
$STEP NAME=FULL
  LOAD PULL 1
$CHECK
  S.XX.MIN(BODY,FULL)     = 4      REL 1e-10 SOURCE 'bar'
  S.XX.MAX(XMAX,HALF)     = 2      REL 1e-10 SOURCE 'bar'
  S.YY.MAX(BODY,FULL)     = 0      ABS 1e-10 SOURCE 'bar'
  S.MISES.MAX(BODY,FULL)  = 4      REL 1e-10 SOURCE 'bar'
  S.XX.AT(3.3,1.1,FULL)   = 4      REL 1e-10 SOURCE 'bar'
  U.X.MAX(BODY,FULL)      = 0.04   REL 1e-10 SOURCE 'bar'
  U.X.AT(10,2,FULL)       = 0.04   REL 1e-10 SOURCE 'bar'
  U.Y.MIN(BODY,FULL)      = -0.002 REL 1e-10 SOURCE 'bar'
  REACTION(XMIN,FULL,X)   = -24    REL 1e-10 SOURCE 'bar'
$END
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
}

TEST(Quantities, PointOutsideTheBodyFailsWithItsReason) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=2 NX=5 NY=2
$MATERIAL NAME=M E=1000 NU=0.25
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  XMIN
$LOAD CASE=PULL TYPE=TRACTION
  XMAX 4 0
$STEP NAME=FULL
  LOAD PULL 1
$CHECK
  S.XX.AT(33,1,FULL) = 4 REL 1e-10 SOURCE 'bar'
$END
)");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.messages.find("outside the body"), std::string::npos) << outcome.messages;
}

} // namespace
} // namespace spricka
