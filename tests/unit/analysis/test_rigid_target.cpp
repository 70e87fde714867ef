// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <cmath>

#include <fmt/format.h>

// Models held by rigid targets alone: what holds, what does not, and closed forms.
namespace spricka::test_rigid_target {
namespace {

using test::Folder;
using test::run_text;
using test::solve_text;

// A block of 10 x 5 on a rigid floor, loaded by a resultant on its top.
std::string block(const std::string& load, const std::string& more = {}) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=BLOCK
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX=4 NY=2
$ENDNET
$MATERIAL NAME=M E=1e5 NU=0.3
$PROPERTY ESET=BLOCK.BODY MATERIAL=M STATE=STRAIN
$RIGID NAME=FLOOR SHAPE=LINE X0=-10 Y0=0 X1=20 Y1=0
$CONTACT NAME=FOOT SLAVE=BLOCK.YMIN MASTER=FLOOR
{}$LOAD CASE=L TYPE=RESULTANT
  BLOCK.YMAX {}
$STEP NAME=S
  LOAD L 1
$END
)",
                     more, load);
}

TEST(RigidTarget, HoldsABodyThatIsPressedAndTakesTheReaction) {
  const auto solved = solve_text(block("0 -300"));
  ASSERT_TRUE(solved);
  const results::LoadStepResult& step = solved->step();
  EXPECT_NEAR(step.contacts[0].force_on_slave.y(), 300.0, 1e-9);
  EXPECT_NEAR(step.contacts[0].mean_pressure, 30.0, 1e-10);
  ASSERT_EQ(step.targets.size(), 1U);
  EXPECT_EQ(step.targets[0].body, "FLOOR");
  EXPECT_NEAR(step.targets[0].contact.y(), -300.0, 1e-9);
  EXPECT_NEAR(step.targets[0].reaction.y(), 300.0, 1e-9);
  EXPECT_TRUE(step.contacts[0].unbounded.empty());
  EXPECT_LT((step.balance[0].applied + step.balance[0].contact).norm(), 1e-9);
}

TEST(RigidTarget, DoesNotHoldWhatMovesAwayOrAlong) {
  const struct {
    const char* load;
    const char* motion;
  } cases[] = {{"0 300", "direction Y"}, {"1 -300", "direction X"}};
  for (const auto& c : cases) {
    const Folder folder;
    const test::Outcome outcome = run_text(folder, block(c.load));
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_NE(outcome.messages.find("BLOCK is loaded but not held: "), std::string::npos)
        << outcome.messages;
    EXPECT_NE(outcome.messages.find(c.motion), std::string::npos) << outcome.messages;
  }
  // A couple that tips the block over: pressed beyond its edge.
  const Folder folder;
  const test::Outcome outcome = run_text(
      folder, block("0 -1", "$LOAD CASE=L TYPE=TRACTION\n  BLOCK.XMAX 0 -3\n  BLOCK.XMIN 0 2.9\n"));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.messages.find("rotation"), std::string::npos) << outcome.messages;
}

TEST(RigidTarget, WithoutLoadEverythingRests) {
  const auto solved = solve_text(block("0 0"));
  ASSERT_TRUE(solved);
  EXPECT_LT(solved->step().u.lpNorm<Eigen::Infinity>(), 1e-14);
  EXPECT_EQ(solved->step().contacts[0].force_on_slave.norm(), 0.0);
}

TEST(RigidTarget, BondedFloorIsASupport) {
  std::string glued = block("100 300");
  glued.insert(glued.find("MASTER=FLOOR"), "TYPE=BONDED ");
  const auto solved = solve_text(glued);
  ASSERT_TRUE(solved);
  EXPECT_NEAR(solved->step().contacts[0].force_on_slave.x(), -100.0, 1e-9);
  EXPECT_NEAR(solved->step().contacts[0].force_on_slave.y(), -300.0, 1e-9);
  std::string held = block("100 300", "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  BLOCK.YMIN\n");
  held.erase(held.find("$CONTACT"), held.find("$FREEDOM") - held.find("$CONTACT"));
  held.erase(held.find("$RIGID"), held.find("$FREEDOM") - held.find("$RIGID"));
  const auto fixed = solve_text(held);
  ASSERT_TRUE(fixed);
  EXPECT_LT((solved->step().u - fixed->step().u).lpNorm<Eigen::Infinity>(),
            1e-12 + 1e-9 * fixed->step().u.lpNorm<Eigen::Infinity>());
}

// Receding contact (benchmark C07): a strip pressed on a floor lifts its ends; where, no load
// moves.
TEST(RigidTarget, ContactThatRecedesDoesNotKnowTheLoad) {
  double from = 0.0;
  double to = 0.0;
  for (const char* force : {"-1", "-1e-6", "-1e6"}) {
    const auto solved = solve_text(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=STRIP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=8 LY=1 NX=65 NY=4
$ENDNET
$MATERIAL NAME=M E=1e5 NU=0.3
$PROPERTY ESET=STRIP.BODY MATERIAL=M STATE=STRAIN
$RIGID NAME=FLOOR SHAPE=LINE X0=-10 Y0=0 X1=20 Y1=0
$CONTACT NAME=FOOT SLAVE=STRIP.YMIN MASTER=FLOOR
$FSET NAME=SPOT FROM=STRIP.YMAX WHERE=(abs(x - 4) < 0.07)
$LOAD CASE=L TYPE=RESULTANT
  SPOT 0 {}
$STEP NAME=S
  LOAD L 1
$END
)",
                                               force));
    ASSERT_TRUE(solved);
    const results::ContactResult& c = solved->step().contacts[0];
    if (from == 0.0) {
      from = c.arc_from;
      to = c.arc_to;
      EXPECT_NEAR(from + to, 8.0, 1e-9); // symmetric
      EXPECT_GT(to - from, 1.0);
      EXPECT_LT(to - from, 2.5);
    }
    EXPECT_NEAR(c.arc_from, from, 1e-9);
    EXPECT_NEAR(c.arc_to, to, 1e-9);
  }
}

// Flat punch of half width b on a half plane (benchmark C09): K = lim p sqrt(2 pi r) = P/sqrt(pi b)
// follows from how the approach d changes with b, K^2 = -E* P/2 dd/db. The edges of the two punches
// lie inside elements; the load is that of Flamant on a remote boundary.
TEST(RigidTarget, EnergyOfAFlatPunchGivesItsStressIntensity) {
  const auto approach = [](double b) {
    const auto solved = solve_text(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  q = 2/pi
$MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=-10 LX=10 LY=10 NX=48 NY=40 BIAS=20
$MATERIAL NAME=M E=0.91 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  XMIN
$RIGID NAME=PUNCH SHAPE=LINE X0={0} Y0=0 X1=-1 Y1=0
$CONTACT NAME=C SLAVE=YMAX MASTER=PUNCH
$LOAD CASE=L TYPE=TRACTION
  YMIN (-q*y^2*x/rho^4)  (-q*y^3/rho^4)
  XMAX (q*x^2*y/rho^4)   (q*x*y^2/rho^4)
$STEP NAME=S
  LOAD L 1
$END
)",
                                               b));
    EXPECT_TRUE(solved);
    if (!solved) {
      return 0.0;
    }
    EXPECT_EQ(solved->step().contacts[0].unbounded.size(), 1U);
    return solved->u(solved->node_at({0.0, -10.0, 0.0})).y();
  };
  const double half = 0.2; // about the width of an element: noise of the cut averages out
  const double slope = (approach(1.0 + half) - approach(1.0 - half)) / (2.0 * half);
  // d = -(2/pi) ln b + const for P = E* = 1: the secant of the logarithm is known
  const double secant = std::log((1.0 + half) / (1.0 - half)) / (2.0 * half);
  const double K = std::sqrt(-0.5 * slope / secant);
  EXPECT_NEAR(K, 1.0 / std::sqrt(std::numbers::pi), 0.01 / std::sqrt(std::numbers::pi));
}

// A shaft 1e6 times as stiff as the ring round it is a rigid one (S07), also about an axis.
TEST(RigidTarget, IsTheLimitOfAStiffBody) {
  const auto pressure = [](bool rigid, bool axial) {
    const std::string ring = axial ? "SHAPE=BLOCK TYPE=QUAMC8 X0=20 LX=20 LY=10 NX=8 NY=4"
                                   : "SHAPE=RING TYPE=QUAMC8 RI=20 RO=40 NR=6 NT=32";
    const std::string shaft = axial ? "SHAPE=BLOCK TYPE=QUAMC8 LX=20 LY=10 NX=3 NY=7"
                                    : "SHAPE=RING TYPE=QUAMC8 RI=0 RO=20 NR=4 NT=24";
    std::string deck = "$DECK VERSION=1 LENGTH=mm FORCE=N\n$NET NAME=RING\n  $MESH " + ring +
                       "\n$ENDNET\n$MATERIAL NAME=M E=2e5 NU=0.3\n"
                       "$PROPERTY ESET=RING.BODY MATERIAL=M STATE=" +
                       (axial ? "AXI\n$FREEDOM CLASS=SUPPRESSED DOF=Y\n  RING.YMIN\n" : "STRESS\n");
    if (rigid) {
      deck += axial ? "$RIGID NAME=S SHAPE=LINE X0=20 Y0=50 X1=20 Y1=-50\n"
                    : "$RIGID NAME=S SHAPE=ARC X0=0 Y0=0 R=20\n";
    } else {
      deck += "$NET NAME=SHAFT\n  $MESH " + shaft +
              "\n$ENDNET\n$MATERIAL NAME=HARD E=2e11 NU=0.3\n"
              "$PROPERTY ESET=SHAFT.BODY MATERIAL=HARD STATE=" +
              (axial ? "AXI\n$FREEDOM CLASS=SUPPRESSED DOF=Y\n  SHAFT.YMIN\n" : "STRESS\n");
    }
    deck += std::string("$CONTACT NAME=FIT SLAVE=") + (axial ? "RING.XMIN" : "RING.INNER") +
            " MASTER=" + (rigid ? "S" : (axial ? "SHAFT.XMAX" : "SHAFT.OUTER")) +
            " INTERFERENCE=0.02\n$STEP NAME=S\n  FIT FIT 1\n$END\n";
    const auto solved = solve_text(deck);
    EXPECT_TRUE(solved);
    return solved ? solved->step().contacts[0].mean_pressure : 0.0;
  };
  for (const bool axial : {false, true}) {
    EXPECT_NEAR(pressure(true, axial), pressure(false, axial), 1e-4 * pressure(true, axial));
  }
}

// About an axis: rows whose nodes are slaves of ties or held by supports. All nodes of the face
// move alike under uniform pressure, tied or not.
TEST(AxialContact, TiedAndSupportedNodesOfASurfaceStayExact) {
  const auto solved = solve_text(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LO
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX=6 NY=2
$ENDNET
$NET NAME=UP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=5 LX=10 LY=5 NX=4 NY=2
$ENDNET
$MATERIAL NAME=M E=1e5 NU=0
$PROPERTY ESET=LO.BODY MATERIAL=M STATE=AXI
$PROPERTY ESET=UP.BODY MATERIAL=M STATE=AXI
$FREEDOM CLASS=SUPPRESSED DOF=Y
  LO.YMIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  LO.YMAX  UP.YMIN
$MPC TYPE=RIGID SLAVE=UP.YMIN
$CONTACT NAME=FACE SLAVE=UP.YMIN MASTER=LO.YMAX
$LOAD CASE=L TYPE=PRESSURE
  UP.YMAX 100
$STEP NAME=S
  LOAD L 1
$END
)");
  ASSERT_TRUE(solved);
  const results::ContactResult& c = solved->step().contacts[0];
  EXPECT_NEAR(c.mean_pressure, 100.0, 1e-9);
  EXPECT_NEAR(c.force_on_slave.y(), 100.0 * std::numbers::pi * 100.0, 1e-6);
  const auto lo = solved->node_at({3.0, 5.0 - 2.5, 0.0});
  EXPECT_NEAR(solved->u(lo).y(), -100.0 / 1e5 * 2.5, 1e-12);
}

// Discs glued together on meshes that do not match are one disc: pulled, pressed, the same pressure
// (negative: tension) comes through.
TEST(AxialContact, BondedDiscsCarryTension) {
  for (const char* pairing : {"SEGMENT", "NODE"}) {
    const auto solved = solve_text(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LO
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX={} NY=2
$ENDNET
$NET NAME=UP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=5 LX=10 LY=5 NX=4 NY=2
$ENDNET
$MATERIAL NAME=M E=1e5 NU=0.3
$PROPERTY ESET=LO.BODY MATERIAL=M STATE=AXI
$PROPERTY ESET=UP.BODY MATERIAL=M STATE=AXI
$FREEDOM CLASS=SUPPRESSED DOF=Y
  LO.YMIN
$CONTACT NAME=GLUE SLAVE=UP.YMIN MASTER=LO.YMAX TYPE=BONDED PAIRING={}
$LOAD CASE=L TYPE=PRESSURE
  UP.YMAX -100
$STEP NAME=S
  LOAD L 1
$END
)",
                                               pairing == std::string("NODE") ? 4 : 7, pairing));
    ASSERT_TRUE(solved);
    const results::ContactResult& c = solved->step().contacts[0];
    for (const results::ContactPoint& p : c.points) {
      EXPECT_NEAR(p.p_lumped, -100.0, 1e-8) << pairing << " at " << p.x.x();
    }
    EXPECT_NEAR(solved->u(solved->node_at({10.0, 10.0, 0.0})).x(), -0.3 * 100.0 / 1e5 * 10.0,
                1e-11);
    EXPECT_NEAR(solved->u(solved->node_at({0.0, 10.0, 0.0})).y(), 100.0 / 1e5 * 10.0, 1e-11);
  }
}

// A bore with a crack round a rigid pin: the bore's surface stays one through the mouth, the load
// goes into the pin, and the places without bound are told.
TEST(RigidTarget, PinInACrackedLug) {
  const auto solved = solve_text(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LUG
  $MESH SHAPE=LUG TYPE=QUAMC8 RI=20 W=80 L=100 NR=6 NT=48
$ENDNET
$MATERIAL NAME=AL E=70000 NU=0.33
$PROPERTY ESET=LUG.BODY MATERIAL=AL STATE=STRESS THICK=10
$RIGID NAME=PIN SHAPE=ARC X0=0 Y0=0 R=20
$CONTACT NAME=C SLAVE=LUG.BORE MASTER=PIN GAP=0
$CRACK NAME=TOP NET=LUG ANGLE=90[deg] A0=4
  0 20
$LOAD CASE=L TYPE=RESULTANT
  LUG.END -10000 0
$STEP NAME=S
  LOAD L 1
$END
)");
  ASSERT_TRUE(solved);
  const results::LoadStepResult& step = solved->step();
  // The lug turns freely about the pin; what the load's moment about the meshed bore is rests.
  EXPECT_NEAR(step.contacts[0].force_on_slave.x(), 10000.0, 1e-5);
  ASSERT_EQ(step.targets.size(), 1U);
  EXPECT_NEAR(step.targets[0].reaction.x(), 10000.0, 1e-5);
  EXPECT_GT(step.fronts[0].single_point().K1, 0.0);
  EXPECT_LT(step.contacts[0].max_penetration, 1e-12);
}

} // namespace
} // namespace spricka::test_rigid_target
