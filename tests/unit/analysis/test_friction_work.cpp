// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace spricka::test_friction_work {
namespace {

// A stiff bar of 10 by 1, 2 thick, on a rigid floor under p = 1, drawn along by 0.1: mu p A d =
// 0.6.
std::string drawn_bar(const std::string& steps, bool below = false, double down = 0.0) {
  const std::string way = fmt::format("0.1 {}", down);
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=1 NX=10 NY=2
$MATERIAL NAME=M E=1e7 NU=0
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=2
$FREEDOM CLASS=PRESCRIBED DOF={1}
  YMAX {2}
$RIGID NAME=F SHAPE=LINE X0=-5 Y0=0 X1=20 Y1=0
$CONTACT NAME=C SLAVE=YMIN MASTER=F MU=0.3
$LOAD CASE=P TYPE=PRESSURE
  YMAX 1
$LOAD CASE=D TYPE=DISP
  YMAX {3}
{4}
{0}
$END
)",
                     steps, down != 0.0 ? "XY" : "X", below ? "YMIN" : "", way,
                     below ? "  YMIN " + way : "");
}

// Pressure and way that grow together, or pressure that goes while the way grows: half of mu p A d.
TEST(Friction, WorkIsThatOfTheMeanPressure) {
  for (const char* steps : {"$STEP NAME=A SUBSTEPS=1\n  LOAD P 1\n  LOAD D 1",
                            "$STEP NAME=A\n  LOAD P 1\n  LOAD D 1"}) {
    const auto grown = test::solve_text(drawn_bar(steps));
    ASSERT_TRUE(grown);
    EXPECT_NEAR(grown->step().contacts[0].friction_work, 0.3, 1e-4) << steps;
  }
  const auto let_go =
      test::solve_text(drawn_bar("$STEP NAME=A\n  LOAD P 1\n$STEP NAME=B\n  LOAD D 1\n  LOAD P 0"));
  ASSERT_TRUE(let_go);
  EXPECT_NEAR(let_go->step(1).contacts[0].friction_work, 0.3, 0.05 * 0.3);
  const auto steady =
      test::solve_text(drawn_bar("$STEP NAME=A\n  LOAD P 1\n$STEP NAME=B SUBSTEPS=1\n  LOAD D 1"));
  ASSERT_TRUE(steady);
  EXPECT_NEAR(steady->step(1).contacts[0].friction_work, 0.6, 1e-3);
}

std::string notes_of(const results::LoadStepResult& step) {
  std::string all;
  for (const std::string& note : results::text_with_code(step.notes)) {
    all += note + "\n";
  }
  return all;
}

// Where the surface itself is drawn along there is no freedom that friction could act on.
TEST(Friction, HeldSurfacesAreTold) {
  const std::string steps = "$STEP NAME=A\n  LOAD P 1\n$STEP NAME=B\n  LOAD D 1";
  const auto held = test::solve_text(drawn_bar(steps, true));
  ASSERT_TRUE(held);
  EXPECT_EQ(notes_of(held->step(0)).find("slide by"), std::string::npos);
  EXPECT_NE(notes_of(held->step(1)).find("they slide by up to 0.1:"), std::string::npos)
      << notes_of(held->step(1));
  const auto free = test::solve_text(drawn_bar(steps));
  ASSERT_TRUE(free);
  EXPECT_EQ(notes_of(free->step(1)).find("slide by"), std::string::npos);

  const auto through = test::solve_text(drawn_bar("$STEP NAME=A\n  LOAD D 1", true, -0.01));
  ASSERT_TRUE(through);
  EXPECT_NE(notes_of(through->step()).find("overlap by up to 0.01"), std::string::npos)
      << notes_of(through->step());
}

// A pin with clearance flies to the wall of its hole and slides there, all in the first increment:
// however small that is, it has an answer, and K hardly knows how many follow.
TEST(Friction, LoosePinFindsItsPlace) {
  std::vector<double> K;
  for (const int substeps : {2, 8, 24}) {
    const auto s = test::solve_text(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LUG
$MESH SHAPE=LUG TYPE=QUAMC8 RI=10 W=40 L=50 NR=6 NT=48
$ENDNET
$NET NAME=PIN
$MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=10 NR=5 NT=48
$ENDNET
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=LUG.BODY MATERIAL=M STATE=STRESS THICK=2
$PROPERTY ESET=PIN.BODY MATERIAL=M STATE=STRESS THICK=2
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LUG.END
$CONTACT NAME=C SLAVE=PIN.OUTER MASTER=LUG.BORE DIAMETRAL=-0.02 MU=0.15
$LOAD CASE=F TYPE=RESULTANT
  PIN.BODY 1000 700
$CRACK NAME=C1 NET=LUG A0=2 ANGLE=100[deg]
  -1.736481776669303 9.84807753012208
$STEP NAME=S SUBSTEPS={}
  LOAD F 1
$END
)",
                                                substeps));
    ASSERT_TRUE(s) << substeps;
    const results::ContactResult& c = s->step().contacts[0];
    EXPECT_NEAR(c.force_on_slave.x(), -1000.0, 1e-6) << substeps;
    EXPECT_NEAR(c.force_on_slave.y(), -700.0, 1e-6) << substeps;
    K.push_back(s->step().fronts.at(0).single_point().K1);
  }
  EXPECT_NEAR(K[0], K[2], 0.01 * std::abs(K[2]));
  EXPECT_NEAR(K[1], K[2], 0.01 * std::abs(K[2]));
}

} // namespace
} // namespace spricka::test_friction_work
