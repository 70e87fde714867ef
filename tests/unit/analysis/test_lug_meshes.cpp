// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

// The paper's lug with short cracks on coarse meshes that match nowhere: the bore refined by the
// patches is round but for the chords of its quadratic edges, so is not about the sleeve's centre.
namespace spricka::test_lug_meshes {
namespace {

struct LugMesh {
  const char* type;
  int nr, nt; ///< lug
  int sleeve, round_sleeve, shaft, round_shaft;
};

std::string lug(const LugMesh& m) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LUG
  $MESH SHAPE=LUG TYPE={0} RI=36 W=173 L=232.5 NR={1} NT={2}
$ENDNET
$NET NAME=SLEEVE
  $MESH SHAPE=RING TYPE={0} RI=30 RO=36 NR={3} NT={4}
$ENDNET
$NET NAME=SHAFT
  $MESH SHAPE=RING TYPE={0} RI=0 RO=30 NR={5} NT={6} BIAS=0.3
$ENDNET
$MATERIAL NAME=CRMO   E=206000 NU=0.32
$MATERIAL NAME=CRNIMO E=196000 NU=0.32
$MATERIAL NAME=AZ74   E=69800  NU=0.33
$PROPERTY ESET=SLEEVE.BODY MATERIAL=CRMO   STATE=STRESS THICK=14
$PROPERTY ESET=SHAFT.BODY  MATERIAL=CRNIMO STATE=STRESS THICK=14
$PROPERTY ESET=LUG.BODY    MATERIAL=AZ74   STATE=STRESS THICK=14
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LUG.END
$CRACK NAME=TOP NET=LUG A0=3.6 ANGLE=90[deg]
  0  36
$CRACK NAME=BOT NET=LUG A0=3.6 ANGLE=-90[deg]
  0  -36
$CONTACT NAME=BUSH SLAVE=SLEEVE.OUTER MASTER=LUG.BORE     DIAMETRAL=0.084
$CONTACT NAME=PIN  SLAVE=SHAFT.OUTER  MASTER=SLEEVE.INNER GAP=0
$LOAD CASE=PULL TYPE=RESULTANT
  SHAFT.BODY  97100  0
$STEP NAME=PRESS
  FIT BUSH 1
$STEP NAME=LOAD
  LOAD PULL 1
$END
)",
                     m.type, m.nr, m.nt, m.sleeve, m.round_sleeve, m.shaft, m.round_shaft);
}

class ShortCracks : public ::testing::TestWithParam<LugMesh> {};

// K of the converged answer (a/R 0.1, two cracks, without friction), which is known to 0.05 %.
TEST_P(ShortCracks, AreAnsweredWithinTheirBars) {
  const std::optional<test::Solved> solved = test::solve_text(lug(GetParam()));
  ASSERT_TRUE(solved);
  const results::LoadStepResult& press = solved->step(0);
  const results::LoadStepResult& load = solved->step(1);
  ASSERT_EQ(load.fronts.size(), 2U);
  for (std::size_t tip : {0U, 1U}) {
    const double side = tip == 0 ? 1.0 : -1.0;
    ASSERT_TRUE(load.fronts[tip].missing_bar_reason.empty()) << load.fronts[tip].missing_bar_reason;
    EXPECT_NEAR(load.fronts[tip].single_point().K1, 434.769,
                load.fronts[tip].single_point().bar[0].size() + 5e-4 * 434.769);
    EXPECT_NEAR(load.fronts[tip].single_point().K2, side * -7.684,
                load.fronts[tip].single_point().bar[1].size() + 0.05);
    EXPECT_GT(press.fronts[tip].single_point().K1, 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Lug, ShortCracks,
                         ::testing::Values(LugMesh{"QUAMC8", 12, 72, 3, 146, 4, 57},
                                           LugMesh{"TRIMC6", 7, 64, 1, 64, 7, 64},
                                           LugMesh{"QUAMC8", 7, 80, 1, 80, 8, 80}));

} // namespace
} // namespace spricka::test_lug_meshes
