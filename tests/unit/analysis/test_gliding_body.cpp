// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <string>

namespace spricka::test_gliding_body {
namespace {

// Two bars end to end that are 0.02 too long for their place; the second is held along its axis
// only, and its flat end glides on the first. x of the joint is 20 but for round-off.
constexpr const char* bars = R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=A
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=20 LY=10 NX=3 NY=7
$ENDNET
$NET NAME=B
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=20 LX=20 LY=10 NX=10 NY=4
$ENDNET
$MATERIAL NAME=M E=210000 NU=0.3
$PROPERTY ESET=A.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=B.BODY MATERIAL=M STATE=STRESS THICK=1
$NSET NAME=HEEL FROM=A.XMIN WHERE=(y < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=X
  A.XMIN
  B.XMAX
$FREEDOM CLASS=SUPPRESSED DOF=Y
  HEEL
$CONTACT NAME=FIT SLAVE=A.XMAX MASTER=B.XMIN INTERFERENCE=0.02
$STEP NAME=PRESS
  FIT FIT 1
$END
)";

// p = E delta / (l1 + l2); along the joint nothing acts, and the body rests where it is.
TEST(GlidingBody, RestsAlongTheJoint) {
  const auto s = test::solve_text(bars);
  ASSERT_TRUE(s);
  for (const results::ContactPoint& p : s->step().contacts.at(0).points) {
    EXPECT_NEAR(p.p_lumped, 105.0, 1e-6);
  }
  bool rests = false;
  for (const std::string& note : results::text_with_code(s->step().notes)) {
    rests = rests || note.find("stay at rest") != std::string::npos;
  }
  EXPECT_TRUE(rests);
}

} // namespace
} // namespace spricka::test_gliding_body
