// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <cmath>

// Ties together with what else a deck may have: cracks that grow, bodies about an axis, heat,
// contacts of tied surfaces, several steps.
namespace spricka::test_tied_analyses {
namespace {

using base::NodeId;
using base::Vec3;
using test::Folder;
using test::solve_text;

std::string cracked(bool in_pieces) {
  std::string deck = "$DECK VERSION=1 LENGTH=mm FORCE=N\n";
  if (in_pieces) {
    deck += R"($NET NAME=P
  $MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=20 LX=40 LY=40 NX=20 NY=20
$ENDNET
$NET NAME=LO
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=40 LY=20 NX=20 NY=10
$ENDNET
$NET NAME=UP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=60 LX=40 LY=20 NX=20 NY=10
$ENDNET
$MPC TYPE=TRANSITION SLAVE=LO.YMAX MASTER=P.YMIN
$MPC TYPE=TRANSITION SLAVE=UP.YMIN MASTER=P.YMAX
$PROPERTY ESET=LO.BODY MATERIAL=AL STATE=STRAIN
$PROPERTY ESET=UP.BODY MATERIAL=AL STATE=STRAIN
)";
  } else {
    deck += R"($NET NAME=P
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=40 LY=80 NX=20 NY=40
$ENDNET
)";
  }
  return deck + R"($MATERIAL NAME=AL E=70000 NU=0.33
$PROPERTY ESET=P.BODY MATERIAL=AL STATE=STRAIN
$CRACK NAME=C NET=P ANGLE=0 A0=8
  0 40
$NSET NAME=FLOOR WHERE=(y < 1e-6)
$NSET NAME=TOPN  WHERE=(y > 80 - 1e-6)
$FSET NAME=TOP
  TOPN
$NSET NAME=PIN   WHERE=(abs(x) + abs(y) < 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  FLOOR
$FREEDOM CLASS=SUPPRESSED DOF=X
  PIN
$LOAD CASE=T TYPE=TRACTION
  TOP 0 (100 + x)
$STEP NAME=S
  LOAD T 1
$GROW LAW=INCREMENT KMAX=S
  8 10 12
$END
)";
}

// The nets round the cracked one are condensed for themselves and kept while the crack grows.
TEST(TiedAnalyses, CrackInOneOfThreeNets) {
  const auto whole = solve_text(cracked(false));
  const auto pieces = solve_text(cracked(true));
  ASSERT_TRUE(whole && pieces);
  ASSERT_EQ(whole->run.increments.size(), 3U);
  ASSERT_EQ(pieces->run.increments.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const results::LoadStepResult& a = whole->run.increments[i].steps.at(0);
    const results::LoadStepResult& b = pieces->run.increments[i].steps.at(0);
    ASSERT_EQ(a.fronts.size(), 1U);
    ASSERT_EQ(b.fronts.size(), 1U);
    EXPECT_GT(a.fronts[0].single_point().K1, 0.0);
    EXPECT_NEAR(b.fronts[0].single_point().K1, a.fronts[0].single_point().K1,
                1e-10 * a.fronts[0].single_point().K1);
    EXPECT_NEAR(b.fronts[0].single_point().K2, a.fronts[0].single_point().K2,
                1e-10 * a.fronts[0].single_point().K1);
    EXPECT_NEAR(b.energy, a.energy, 1e-10 * a.energy);
  }
}

// A cylinder in two halves under pressure, tension and heat: constant stress, also on the axis.
TEST(TiedAnalyses, HalvesOfACylinder) {
  const Folder folder;
  const test::Outcome outcome = run_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=A
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=2 LY=2 NX=1 NY=1
$ENDNET
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE=TRIMC6 Y0=2 LX=2 LY=2 NX=3 NY=2
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.25 ALPHA=1e-4
$PROPERTY ESET=A.BODY MATERIAL=M STATE=AXI
$PROPERTY ESET=B.BODY MATERIAL=M STATE=AXI
$FREEDOM CLASS=SUPPRESSED DOF=Y
  A.YMIN
$MPC TYPE=TRANSITION SLAVE=B.YMIN MASTER=A.YMAX
$LOAD CASE=F TYPE=TRACTION
  B.YMAX 0 3
$LOAD CASE=F TYPE=PRESSURE
  A.XMAX 5
  B.XMAX 5
$LOAD CASE=F TYPE=TEMPERATURE
  A.BODY 10
  B.BODY 10
$STEP NAME=S
  LOAD F 1
$CHECK
  S.YY.MIN(B.BODY,S) = 3  REL 1e-9 SOURCE 'exact'
  S.YY.MAX(A.BODY,S) = 3  REL 1e-9 SOURCE 'exact'
  S.XX.MAX(A.BODY,S) = -5 REL 1e-9 SOURCE 'exact'
  S.XX.MIN(B.BODY,S) = -5 REL 1e-9 SOURCE 'exact'
  S.ZZ.MIN(B.BODY,S) = -5 REL 1e-9 SOURCE 'exact'
  S.ZZ.MAX(A.BODY,S) = -5 REL 1e-9 SOURCE 'exact'
  U.Y.MAX(B.BODY,S) = (4*((3 + 2*0.25*5)/1000 + 1e-3))         REL 1e-9 SOURCE 'exact'
  U.X.MIN(B.BODY,S) = (2*((-5 - 0.25*(3 - 5))/1000 + 1e-3))    REL 1e-9 SOURCE 'exact'
  REACTION(A.YMIN,S,Y) = (-3*pi*4)  REL 1e-11 SOURCE 'statics'
$END
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
}

// A punch whose sole is rigid and whose other nodes are elastic stands on a block by contact: all
// slave nodes of the contact follow the sole. Under a central load the block has constant stress.
TEST(TiedAnalyses, RigidSoleOfAPunch) {
  const auto punch = solve_text(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=BASE
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX=7 NY=3
$ENDNET
$NET NAME=PUNCH
  $MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=5 LX=10 LY=2 NX=4 NY=1
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.25
$PROPERTY ESET=BASE.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=PUNCH.BODY MATERIAL=M STATE=STRESS
$NSET NAME=PIN WHERE=(abs(x) + abs(y) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  BASE.YMIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  PIN
$NSET NAME=TOE FROM=PUNCH.YMIN WHERE=(x < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=X
  TOE
$MPC TYPE=RIGID SLAVE=PUNCH.YMIN
$CONTACT NAME=C SLAVE=PUNCH.YMIN MASTER=BASE.YMAX
$LOAD CASE=F TYPE=PRESSURE
  PUNCH.YMAX 20
$STEP NAME=S
  LOAD F 1
$END
)");
  ASSERT_TRUE(punch);
  for (std::size_t n = 0; n < punch->mesh().node_count(); ++n) {
    const Vec3& x = punch->mesh().x[n];
    const Vec3 u = punch->u(NodeId(n));
    if (x.y() < 5.0 - 1e-9) { // sigma_yy = -20 and nothing else
      EXPECT_NEAR(u.y(), -0.02 * x.y(), 1e-11);
      EXPECT_NEAR(u.x(), 0.25 * 0.02 * x.x(), 1e-11);
    } else if (x.y() < 5.0 + 1e-9 &&
               punch->mesh().node_net[n].index() == punch->mesh().node_net.back().index()) {
      EXPECT_NEAR(u.y(), -0.1, 1e-11); // the sole
      EXPECT_NEAR(u.x(), 0.0, 1e-11);
    }
  }
  const results::ContactResult& contact = punch->step().contacts.at(0);
  EXPECT_NEAR(contact.force_on_slave.y(), 200.0, 1e-9);
  EXPECT_NEAR(contact.max_pressure, 20.0, 1e-9);
  EXPECT_NEAR(contact.min_pressure, 20.0, 1e-9);
}

// Right-hand sides of equations hold in every step; loads come and go. Each step is the sum of what
// the equation and what the loads do alone.
TEST(TiedAnalyses, StepsSuperpose) {
  const std::string model = R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=2 NX=4 NY=2
$MATERIAL NAME=M E=1000 NU=0.25
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  XMIN
$FREEDOM CLASS=PRESCRIBED DOF=Y
  XMAX
$MPC TYPE=EQUATION RHS=0.01
  1 3 X -1 4 X
$LOAD CASE=F TYPE=TRACTION
  YMAX 1 2
$LOAD CASE=D TYPE=DISP
  XMAX 0 0.1
$STEP NAME=NONE
  LOAD F 0
$STEP NAME=BOTH
  LOAD F 2
  LOAD D 3
$STEP NAME=ONE
  LOAD F 1
  LOAD D 0
$STEP NAME=OTHER
  LOAD F 0
  LOAD D 1
$END
)";
  const auto solved = solve_text(model);
  ASSERT_TRUE(solved);
  const base::Vector& none = solved->step(0).u;
  const base::Vector f = solved->step(2).u - none;
  const base::Vector d = solved->step(3).u - none;
  const double size = solved->step(1).u.lpNorm<Eigen::Infinity>();
  EXPECT_GT(none.lpNorm<Eigen::Infinity>(), 1e-3);
  EXPECT_GT(f.lpNorm<Eigen::Infinity>(), 1e-3);
  EXPECT_LT((solved->step(1).u - none - 2.0 * f - 3.0 * d).lpNorm<Eigen::Infinity>(), 1e-12 * size);
}

} // namespace
} // namespace spricka::test_tied_analyses
