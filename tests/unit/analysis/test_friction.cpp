// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/places.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace spricka::test_friction {
namespace {

using results::ContactState;

// A long flat bar on a rigid floor, pressed by p and pulled at its right end: T at the end of PULL,
// then let go. Where it is thin it slips over l = T / (mu p).
std::string bar(const std::string& pairing, int substeps, double size = 1.0) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=BAR
$MESH SHAPE=BLOCK TYPE=QUAM4 LX=100 LY=1 NX=120 NY=2
$ENDNET
$NET NAME=FLOOR
$MESH SHAPE=BLOCK TYPE=QUAM4 LX=100 LY=1 Y0=-1 NX=120 NY=1
$ENDNET
$MATERIAL NAME=M E=10000 NU=0
$PROPERTY ESET=BAR.BODY MATERIAL=M STATE=STRESS THICK=2
$PROPERTY ESET=FLOOR.BODY MATERIAL=M STATE=STRESS THICK=2
$FREEDOM CLASS=SUPPRESSED DOF=XY
  FLOOR.YMIN
  FLOOR.YMAX
$CONTACT NAME=C SLAVE=BAR.YMIN MASTER=FLOOR.YMAX MU=0.1 PAIRING={}
$LOAD CASE=P TYPE=PRESSURE
  BAR.YMAX {}
$LOAD CASE=T TYPE=TRACTION
  BAR.XMAX {} 0
$STEP NAME=PRESS
  LOAD P 1
$STEP NAME=PULL SUBSTEPS={}
  LOAD T 1
$STEP NAME=BACK SUBSTEPS={}
  LOAD T 0
$END
)",
                     pairing, size, 5.0 * size, substeps, substeps);
}

double end_displacement(const test::Solved& s, std::size_t step) {
  return s.vector(s.step(step).u, s.node_at({100.0, 0.5, 0.0})).x();
}

// u = mu p l^2 / (2 E h) at the end; let go, it slips back over l / 2 and half of u remains.
TEST(Friction, ThinBarSlipsAsFarAsItsPullReaches) {
  for (const char* pairing : {"SEGMENT", "NODE"}) {
    SCOPED_TRACE(pairing);
    const auto s = test::solve_text(bar(pairing, 10));
    ASSERT_TRUE(s);
    constexpr double l = 50.0;
    constexpr double u = 0.1 * l * l / (2.0 * 10000.0);
    constexpr double work = 2.0 * 0.1 * 0.1 * l * l * l / (6.0 * 10000.0); // thickness 2
    EXPECT_NEAR(end_displacement(*s, 1), u, 0.03 * u);
    EXPECT_NEAR(end_displacement(*s, 2), 0.5 * u, 0.03 * u);
    const results::ContactResult& pulled = s->step(1).contacts[0];
    const results::ContactResult& back = s->step(2).contacts[0];
    EXPECT_NEAR(pulled.friction_work, work, 0.03 * work);
    EXPECT_NEAR(back.friction_work, 1.25 * work, 0.03 * work);
    EXPECT_NEAR(pulled.stick_to, l, 2.0);
    EXPECT_NEAR(back.stick_to, 0.5 * (l + 100.0), 2.0);
    EXPECT_NEAR(pulled.max_slip, u, 0.03 * u);
    EXPECT_NEAR(back.max_slip, 1.5 * u, 0.04 * u); // there and half the way back
    EXPECT_NEAR(pulled.force_on_slave.x(), -10.0, 1e-9);
    EXPECT_NEAR(back.force_on_slave.x(), 0.0, 1e-9);
    for (const results::ContactPoint& point : pulled.points) {
      EXPECT_LE(std::abs(point.q_lumped), 0.1 * point.p_lumped * (1.0 + 1e-9));
      if (point.state == ContactState::slip) { // shear stops the slip
        EXPECT_LE(point.q_lumped * point.slip, 0.0);
      }
    }
  }
}

// A thin tube shrunk onto a mandrel (rigid, or a solid one that is held), pulled at its upper end:
// where mu p 2 pi R has taken up the pull the tube rests.
std::string tube(const std::string& mandrel) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=TUBE
$MESH SHAPE=BLOCK TYPE=QUAM4 X0=50 LX=0.5 LY=100 NX=2 NY=100
$ENDNET
$MATERIAL NAME=M E=10000 NU=0
$PROPERTY ESET=TUBE.BODY MATERIAL=M STATE=AXI
{}
$LOAD CASE=T TYPE=TRACTION
  TUBE.YMAX 0 10
$STEP NAME=SHRINK
  FIT C 1
$STEP NAME=PULL SUBSTEPS=5
  LOAD T 1
$STEP NAME=BACK SUBSTEPS=5
  LOAD T 0
$END
)",
                     mandrel);
}

TEST(Friction, TubeIsPulledFromItsMandrelAsFarAsThePullReaches) {
  const std::array<std::string, 2> mandrels{
      "$RIGID NAME=CORE SHAPE=LINE X0=50 Y0=110 X1=50 Y1=-10\n"
      "$CONTACT NAME=C SLAVE=TUBE.XMIN MASTER=CORE INTERFERENCE=0.5 MU=0.1\n",
      "$NET NAME=CORE\n$MESH SHAPE=BLOCK TYPE=QUAM4 X0=49 LX=1 LY=100 NX=1 NY=120\n$ENDNET\n"
      "$PROPERTY ESET=CORE.BODY MATERIAL=M STATE=AXI\n"
      "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  CORE.XMIN  CORE.XMAX\n"
      "$CONTACT NAME=C SLAVE=TUBE.XMIN MASTER=CORE.XMAX INTERFERENCE=0.5 MU=0.1\n"};
  for (const std::string& mandrel : mandrels) {
    SCOPED_TRACE(mandrel);
    const auto s = test::solve_text(tube(mandrel));
    ASSERT_TRUE(s);
    constexpr double E = 10000.0, mu = 0.1, ri = 50.0, ro = 50.5;
    constexpr double p = 0.5 / ri * E * (ro * ro - ri * ri) / (ro * ro + ri * ri); // Lame, nu = 0
    constexpr double wall = (ro * ro - ri * ri) / (2.0 * ri); // area over the bore's perimeter
    constexpr double l = 10.0 * wall / (mu * p);
    constexpr double u = mu * p * l * l / (2.0 * E * wall);
    const results::ContactResult& pulled = s->step(1).contacts[0];
    const results::ContactResult& back = s->step(2).contacts[0];
    EXPECT_NEAR(pulled.mean_pressure, p, 0.01 * p);
    EXPECT_NEAR(pulled.force_on_slave.y(), -10.0 * std::numbers::pi * (ro * ro - ri * ri), 1e-7);
    EXPECT_NEAR(back.force_on_slave.y(), 0.0, 1e-7);
    const base::NodeId end = s->node_at({50.25, 100.0, 0.0});
    EXPECT_NEAR(s->vector(s->step(1).u, end).y(), u, 0.03 * u);
    EXPECT_NEAR(s->vector(s->step(2).u, end).y(), 0.5 * u, 0.04 * u);
    for (const results::ContactPoint& point : pulled.points) {
      EXPECT_LE(std::abs(point.q_lumped), mu * point.p_lumped * (1.0 + 1e-9));
      const double from_end = 100.0 - point.x.y();
      if (from_end > 3.0 && from_end < l - 5.0) {
        EXPECT_EQ(point.state, ContactState::slip);
      } else if (from_end > l + 5.0) {
        EXPECT_EQ(point.state, ContactState::stick);
      }
    }
  }
}

TEST(Friction, MonotonePullDoesNotDependOnItsSubsteps) {
  const auto one = test::solve_text(bar("SEGMENT", 1));
  const auto many = test::solve_text(bar("SEGMENT", 7));
  ASSERT_TRUE(one && many);
  EXPECT_NEAR(end_displacement(*one, 1), end_displacement(*many, 1),
              1e-9 * end_displacement(*one, 1));
  EXPECT_EQ(many->step(1).increments, 7);
}

TEST(Friction, AnswerGrowsWithTheLoads) {
  const auto one = test::solve_text(bar("SEGMENT", 4));
  ASSERT_TRUE(one);
  for (const double size : {1e-6, 1e6}) {
    const auto other = test::solve_text(bar("SEGMENT", 4, size));
    ASSERT_TRUE(other);
    for (std::size_t step = 0; step < 3; ++step) {
      const base::Vector& u = one->step(step).u;
      // where rows are at their limit without slip, states may differ, and round-off with them
      EXPECT_LT((other->step(step).u / size - u).norm(), 1e-7 * u.norm());
      const results::ContactResult& a = one->step(step).contacts[0];
      const results::ContactResult& b = other->step(step).contacts[0];
      EXPECT_EQ(a.sticking, b.sticking);
      EXPECT_NEAR(b.friction_work / (size * size), a.friction_work, 1e-9 * a.friction_work);
    }
  }
}

// A disc in a ring that is held outside, net fit, pushed to the right.
std::string pushed_disc(double mu) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=DISC
$MESH SHAPE=RING TYPE=QUAMC8 RI=0.3 RO=1 NR=3 NT=40
$ENDNET
$NET NAME=RING
$MESH SHAPE=RING TYPE=QUAMC8 RI=1 RO=3 NR=4 NT=36
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=DISC.BODY MATERIAL=M STATE=STRAIN
$PROPERTY ESET=RING.BODY MATERIAL=M STATE=STRAIN
$FREEDOM CLASS=SUPPRESSED DOF=XY
  RING.OUTER
$CONTACT NAME=C SLAVE=DISC.OUTER MASTER=RING.INNER GAP=0 MU={}
$LOAD CASE=F TYPE=RESULTANT
  DISC.BODY 1 0
$STEP NAME=PUSH SUBSTEPS=4
  LOAD F 1
$END
)",
                     mu);
}

TEST(Friction, LittleFrictionChangesLittle) {
  const auto none = test::solve_text(pushed_disc(0.0));
  const auto some = test::solve_text(pushed_disc(1e-4));
  const auto more = test::solve_text(pushed_disc(2e-4));
  ASSERT_TRUE(none && some && more);
  EXPECT_FALSE(none->step().contacts[0].rubs);
  const auto moved = [](const test::Solved& s) { return s.u(s.node_at({0.3, 0.0, 0.0})).x(); };
  const double first = moved(*some) - moved(*none);
  const double second = moved(*more) - moved(*none);
  EXPECT_LT(std::abs(first), 1e-3 * moved(*none));
  EXPECT_LT(first, 0.0); // friction carries a part of the load
  EXPECT_NEAR(second / first, 2.0, 0.01);
}

// A disc pressed into a ring: p = E d / (2 R) (1 - R^2 / Ro^2), and it turns when the couple on it
// passes 2 pi R^2 mu p. Nothing but the elastic solution knows that.
test::Outcome turned_disc(const test::Folder& folder, double share) {
  const double p = 1000.0 * 0.001 / 2.0 * (1.0 - 1.0 / 9.0);
  const double couple = share * 2.0 * std::numbers::pi * 0.2 * p;
  return test::run_text(folder, fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=DISC
$MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=1 NR=4 NT=32
$ENDNET
$NET NAME=RING
$MESH SHAPE=RING TYPE=QUAMC8 RI=1 RO=3 NR=6 NT=32
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=DISC.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=RING.BODY MATERIAL=M STATE=STRESS
$NSET NAME=EAST WHERE=(abs(x) > 2.9 and abs(y) < 1e-6)
$NSET NAME=NORTH WHERE=(abs(y) > 2.9 and abs(x) < 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  EAST
$FREEDOM CLASS=SUPPRESSED DOF=X
  NORTH
$CONTACT NAME=C SLAVE=DISC.OUTER MASTER=RING.INNER INTERFERENCE=0.001 MU=0.2
$LOAD CASE=TURN TYPE=BODY
  DISC.BODY ({0}*-y) ({0}*x)
$STEP NAME=PRESS
$STEP NAME=TURN SUBSTEPS=5
  LOAD TURN 1
$END
)",
                                            couple * 2.0 / std::numbers::pi));
}

TEST(Friction, PressedDiscHoldsItsCoupleAndNoMore) {
  const test::Folder folder;
  const test::Outcome held = turned_disc(folder, 0.97);
  EXPECT_EQ(held.exit_code, 0) << held.messages;
  const test::Outcome turns = turned_disc(folder, 1.03);
  EXPECT_EQ(turns.exit_code, 4);
  EXPECT_NE(turns.messages.find("step TURN: substep 5 of 5: body DISC slides"), std::string::npos)
      << turns.messages;
  EXPECT_NE(turns.messages.find("rotation"), std::string::npos) << turns.messages;
}

// Three blocks on each other, the lower joint bonded; sheared within the cone of friction they
// behave as if the upper joint were bonded, too.
std::string stack(const std::string& upper) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=A
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=4 LY=1 NX=4 NY=2
$ENDNET
$NET NAME=B
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=4 LY=1 Y0=1 NX=6 NY=2
$ENDNET
$NET NAME=D
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=4 LY=1 Y0=2 NX=5 NY=2
$ENDNET
$MATERIAL NAME=M E=1000 NU=0
$PROPERTY ESET=A.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=B.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=D.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  A.YMIN
$CONTACT NAME=LOW SLAVE=B.YMIN MASTER=A.YMAX TYPE=BONDED
$CONTACT NAME=UP SLAVE=D.YMIN MASTER=B.YMAX {}
$LOAD CASE=P TYPE=TRACTION
  D.YMAX 0.02 -1
$STEP NAME=S SUBSTEPS=2
  LOAD P 1
$END
)",
                     upper);
}

TEST(Friction, WhatSticksIsBonded) {
  const auto bonded = test::solve_text(stack("TYPE=BONDED"));
  const auto stuck = test::solve_text(stack("MU=5"));
  ASSERT_TRUE(bonded && stuck);
  const results::ContactResult& joint = stuck->step().contacts[1];
  ASSERT_EQ(joint.sticking, joint.rows);
  EXPECT_LT((bonded->step().u - stuck->step().u).norm(), 1e-10 * bonded->step().u.norm());
  EXPECT_NEAR(joint.force_on_slave.x(), -0.08, 1e-10);
  EXPECT_EQ(joint.friction_work, 0.0);
}

// The lower block is sheared before the upper one is mounted: their offset then is no slip, and no
// force. Sheared on, the upper one is dragged along.
TEST(Friction, OffsetAtMountIsNoSlip) {
  const std::string deck = R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LOW
$MESH SHAPE=BLOCK TYPE=QUAM4 LX=4 LY=1 NX=4 NY=2
$ENDNET
$NET NAME=TOP
$MESH SHAPE=BLOCK TYPE=QUAM4 LX=4 LY=1 Y0=1 NX=4 NY=2
$ENDNET
$MATERIAL NAME=M E=1000 NU=0
$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=PRESCRIBED DOF=XY
  LOW.YMIN
  LOW.YMAX
$FREEDOM CLASS=SUPPRESSED DOF=Y
  TOP.YMAX
$CONTACT NAME=C SLAVE=TOP.YMIN MASTER=LOW.YMAX INTERFERENCE=0.01 MU=0.3
$LOAD CASE=SHEAR TYPE=DISP
  LOW.YMIN 0 0
  LOW.YMAX 0.5 0
$STEP NAME=FIRST
  LOAD SHEAR 1
$STEP NAME=JOIN
  MOUNT C
$STEP NAME=DRAG SUBSTEPS=3
  LOAD SHEAR 1.2
$END
)";
  const auto s = test::solve_text(deck);
  ASSERT_TRUE(s);
  const results::ContactResult& joined = s->step(1).contacts[0];
  EXPECT_EQ(joined.sticking, joined.rows);
  EXPECT_NEAR(joined.force_on_slave.y(), 40.0, 1e-9); // 0.01 of its height, times E and width
  for (const results::ContactPoint& point : joined.points) {
    EXPECT_NEAR(point.q_consistent, 0.0, 1e-9);
  }
  // nothing holds the upper block along x: it rides along, without force
  const double before = s->vector(s->step(1).u, s->node_at({0.0, 2.0, 0.0})).x();
  const double after = s->vector(s->step(2).u, s->node_at({0.0, 2.0, 0.0})).x();
  EXPECT_NEAR(after - before, 0.1, 1e-9);
  EXPECT_NEAR(s->step(2).contacts[0].max_slip, 0.0, 1e-12);
}

std::string block_deck() {
  std::ifstream in(std::filesystem::path(test::decks_folder()) / "friction_block.deck");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string with(std::string deck, const std::string& from, const std::string& to) {
  const std::size_t at = deck.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return deck.replace(at, from.size(), to);
}

TEST(Friction, BlocksSlideAtTheLimitOfC12) {
  const test::Folder folder;
  EXPECT_EQ(test::run_text(folder, block_deck()).exit_code, 0);
  const test::Outcome slides =
      test::run_text(folder, with(block_deck(), "T     = 3.96", "T = 4.04"));
  EXPECT_EQ(slides.exit_code, 4);
  EXPECT_NE(slides.messages.find("step PUSHED: substep 10 of 10: body BLOCK slides"),
            std::string::npos)
      << slides.messages;
  EXPECT_NE(slides.messages.find("direction X"), std::string::npos) << slides.messages;
  const test::Outcome steep =
      test::run_text(folder, with(block_deck(), "slope = 0.58", "slope = 0.57"));
  EXPECT_EQ(steep.exit_code, 4);
  EXPECT_NE(steep.messages.find("body CASE slides"), std::string::npos) << steep.messages;
}

// The sufficient test fails at much friction, which alone is no reason to warn.
TEST(Friction, MuchFrictionIsNoReasonToWarn) {
  const test::Folder folder;
  for (const double mu : {1e-5, 0.1, 1.5}) {
    const test::Outcome outcome = test::run_text(folder, pushed_disc(mu));
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.messages.find("solutions"), std::string::npos) << outcome.messages;
  }
}

} // namespace
} // namespace spricka::test_friction
