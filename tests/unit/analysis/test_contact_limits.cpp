// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/closing_motion.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>

#include <fmt/format.h>

namespace spricka::test_contact_limits {
namespace {

std::string notes_of(const test::Solved& s, std::size_t step = 0) {
  std::string all;
  for (const std::string& note : results::text_with_code(s.step(step).notes)) {
    all += note + "\n";
  }
  return all;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Two blocks of width 1 and `width`, the upper one moved by (ux, uy) at its top.
std::string blocks(double ux, double uy, const std::string& contact, double width = 1.0,
                   double gap = 0.0) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=A
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0={0} LX={1} LY=1 NX=20 NY=3
$ENDNET
$NET NAME=B
$MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=(1+{2}) LX=1 LY=1 NX=10 NY=3
$ENDNET
$MATERIAL NAME=M E=1000 NU=0
$PROPERTY ESET=A.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=B.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  A.YMIN
$FREEDOM CLASS=PRESCRIBED DOF=XY
  B.YMAX
$LOAD CASE=T TYPE=DISP
  B.YMAX {3} {4}
{5}
$STEP NAME=S
  LOAD T 1
$END
)",
                     0.5 * (1.0 - width), width, gap, ux, uy, contact);
}

constexpr const char* pair = "$CONTACT NAME=C SLAVE=B.YMIN MASTER=A.YMAX";

TEST(ContactLimits, SmallMotionsAreNotWarnedOf) {
  for (const char* pairing : {"", " PAIRING=SEGMENT MU=0.2"}) {
    const auto s = test::solve_text(blocks(0.001, -0.01, std::string(pair) + pairing, 2.0));
    ASSERT_TRUE(s);
    EXPECT_FALSE(has(notes_of(*s), "slide by")) << notes_of(*s);
    EXPECT_FALSE(has(notes_of(*s), "run into each other")) << notes_of(*s);
  }
}

// Half of the upper block hangs over the lower one at the end: half the force is nobody's.
TEST(ContactLimits, WhatSlidesOffIsTold) {
  const auto s = test::solve_text(blocks(0.5, -0.01, pair));
  ASSERT_TRUE(s);
  EXPECT_TRUE(has(notes_of(*s), "warning W508: contact C: the bodies slide by 0.5"))
      << notes_of(*s);
  EXPECT_TRUE(has(notes_of(*s), "50 % of the force") || has(notes_of(*s), "49 %") ||
              has(notes_of(*s), "48 %"))
      << notes_of(*s);
}

TEST(ContactLimits, ALittleThatSlidesOffMakesForcesLessExact) {
  const auto s = test::solve_text(blocks(0.05, -0.01, pair));
  ASSERT_TRUE(s);
  EXPECT_TRUE(has(notes_of(*s), "warning W507: contact C")) << notes_of(*s);
  EXPECT_TRUE(has(notes_of(*s), "forces and K are off by about 5 %")) << notes_of(*s);
}

// From the wide block's side a part of its pressed places is left, but others take their place:
// the narrow block is pressed on all of its foot as before.
TEST(ContactLimits, AShiftAlongAWideBlockLosesNothing) {
  for (const char* either : {pair, "$CONTACT NAME=C SLAVE=A.YMAX MASTER=B.YMIN"}) {
    const auto s = test::solve_text(blocks(0.05, -0.01, either, 4.0));
    ASSERT_TRUE(s);
    EXPECT_FALSE(has(notes_of(*s), "slide by")) << notes_of(*s);
  }
}

// A second pair of blocks, pressed by `depth` where the first has 0.01; half of it slides off.
TEST(ContactLimits, WhatSlidesOffCountsByItsPartOfTheForces) {
  for (const auto& [depth, says] :
       {std::pair(1e-5, "note: contact L"), std::pair(1e-3, "W507: "), std::pair(1e-2, "W508: ")}) {
    const std::string light = fmt::format(R"($NET NAME=E
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=10 LX=1 LY=1 NX=10 NY=3
$ENDNET
$NET NAME=D
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=10 Y0=1 LX=1 LY=1 NX=10 NY=3
$ENDNET
$PROPERTY ESET=E.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=D.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  E.YMIN
$FREEDOM CLASS=PRESCRIBED DOF=XY
  D.YMAX
$LOAD CASE=T TYPE=DISP
  D.YMAX 0.5 {}
$CONTACT NAME=L SLAVE=D.YMIN MASTER=E.YMAX)",
                                          -depth);
    const auto s = test::solve_text(blocks(0.0, -0.01, std::string(pair) + "\n" + light));
    ASSERT_TRUE(s);
    std::string notes;
    for (const results::Note& note : s->step().notes) {
      notes += (results::is_warning(note) ? "" : "note: ") + results::text_with_code(note) + "\n";
    }
    EXPECT_TRUE(has(notes, says)) << depth << notes;
    EXPECT_TRUE(has(notes, "contact L: the bodies slide by 0.5")) << depth << notes;
  }
}

// On a wide block the pressure stays where the narrow one has been.
TEST(ContactLimits, SlidesByElementsAreTold) {
  const auto s = test::solve_text(blocks(0.4, -0.01, pair, 4.0));
  ASSERT_TRUE(s);
  EXPECT_TRUE(has(notes_of(*s), "element lengths")) << notes_of(*s);
}

// The lower block turns about a point far below and so slides and tilts: 0.4 times 0.02 of gap that
// no row counts. Where the upper block is held it is pressed by as much less; where only a force
// presses it, it comes down by itself.
TEST(ContactLimits, GapsThatAFreeBodyClosesAreNotToldOf) {
  for (const bool held : {true, false}) {
    const auto s = test::solve_text(
        fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=A
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-1.5 LX=4 LY=1 NX=4 NY=2
$ENDNET
$NET NAME=B
$MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=1 LX=1 LY=1 NX=10 NY=3
$NSET NAME=MID WHERE=(abs(x-0.5) < 1e-9 and abs(y-2) < 1e-9)
$ENDNET
$MATERIAL NAME=M E=1000 NU=0
$PROPERTY ESET=A.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=B.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=PRESCRIBED DOF=XY
  A.YMIN
$FREEDOM CLASS={0}
  {1}
$LOAD CASE=TURN TYPE=DISP
  A.YMIN (0.02*20) (-0.02*(X-0.5))
  {2}
$CONTACT NAME=C SLAVE=B.YMIN MASTER=A.YMAX
$STEP NAME=S
  LOAD TURN 1
$END
)",
                    held ? "PRESCRIBED DOF=XY" : "SUPPRESSED DOF=X", held ? "B.YMAX" : "B.MID",
                    held ? "B.YMAX 0 (-0.02*(X-0.5)-0.02)"
                         : "\n$LOAD CASE=TURN TYPE=RESULTANT\n  B.YMAX 0 -10"));
    ASSERT_TRUE(s);
    EXPECT_EQ(has(notes_of(*s), "their gap changes by"), held) << notes_of(*s);
  }
}

// A wedge between two faces closes a gap of g on both by g / sin(angle) along its axis: taken while
// that is no farther than the bodies have slid. Along faces that are almost parallel it would be,
// and a motion of both bodies together, the second one, closes nothing.
TEST(ContactLimits, WedgesCloseGapsByNoMoreThanTheySlide) {
  constexpr double gap = 0.01;
  constexpr double slide = 0.5;
  for (const double angle : {0.2, 0.03, 0.01, 1e-4, 0.0}) {
    std::vector<contact::DisplacedContactPoint> points;
    for (const double side : {-1.0, 1.0}) {
      for (const double x : {0.0, 1.0, 2.0}) {
        contact::DisplacedContactPoint point;
        point.thrust = 1.0 + x;
        point.unseen = gap;
        point.normal = {-std::sin(angle), side * std::cos(angle), 0.0};
        point.relative_motions = base::Matrix::Zero(3, 2);
        point.relative_motions(0, 0) = 1.0;
        points.push_back(point);
      }
    }
    const base::Vector motion = analysis::fit_gap_closing_motion(points, slide);
    const double needed = gap / std::sin(angle);
    EXPECT_NEAR(motion[0], needed <= slide ? needed : 0.0, 1e-12) << angle;
    EXPECT_EQ(motion[1], 0.0) << angle;
  }
}

// A gap above a fifth of the extent is not seen: the pass through each other is.
TEST(ContactLimits, BodiesThatPassThroughEachOtherAreTold) {
  std::string deck = blocks(0.0, -0.6, pair, 1.0, 0.4);
  const std::string contact = pair;
  deck.replace(deck.find(contact), contact.size(), "");
  const auto s = test::solve_text(deck);
  ASSERT_TRUE(s);
  EXPECT_TRUE(has(notes_of(*s), "A and B run into each other by 0.2")) << notes_of(*s);
  EXPECT_TRUE(has(notes_of(*s), "no $CONTACT")) << notes_of(*s);
}

TEST(ContactLimits, BodiesThatTouchAndPartAreNot) {
  std::string deck = blocks(0.0, 0.1, pair);
  const std::string contact = pair;
  deck.replace(deck.find(contact), contact.size(), "");
  const auto s = test::solve_text(deck);
  ASSERT_TRUE(s);
  EXPECT_FALSE(has(notes_of(*s), "run into each other")) << notes_of(*s);
}

// A sheet that lies upon another one is drawn into it on purpose.
TEST(ContactLimits, SheetsUponEachOtherAreNot) {
  std::string deck = blocks(0.0, -0.05, pair, 4.0, -0.95);
  const std::string contact = pair;
  deck.replace(deck.find(contact), contact.size(), "");
  const auto s = test::solve_text(deck);
  ASSERT_TRUE(s);
  EXPECT_FALSE(has(notes_of(*s), "run into each other")) << notes_of(*s);
}

// A wedge of gap 0 to 0.4: the part beyond a fifth of the extent is unseen and passes through.
TEST(ContactLimits, TheUnseenPartOfAPairIsTold) {
  const auto s = test::solve_text(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=A
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=1 LY=1 NX=10 NY=3
$ENDNET
$NET NAME=B
$COOR DIM=2
1  0 1
2  1 1.5
3  1 2.5
4  0 2.5
5  0.5 1.25
6  1 2
7  0.5 2.5
8  0 1.75
$ELEMENT TYPE=QUAMC8 ESET=BODY
1  1 2 3 4 5 6 7 8
$NSET NAME=LOW
  1, 5, 2
$NSET NAME=UP
  3, 4, 7
$ENDNET
$MATERIAL NAME=M E=1000 NU=0
$PROPERTY ESET=A.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=B.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  A.YMIN
$FREEDOM CLASS=PRESCRIBED DOF=XY
  B.UP
$LOAD CASE=T TYPE=DISP
  B.UP 0 -0.7
$CONTACT NAME=C SLAVE=B.LOW MASTER=A.YMAX
$STEP NAME=S
  LOAD T 1
$END
)");
  ASSERT_TRUE(s);
  EXPECT_TRUE(has(notes_of(*s), "run into each other")) << notes_of(*s);
  EXPECT_TRUE(has(notes_of(*s), "contact C sees nothing there")) << notes_of(*s);
}

// A ring and a disc in it: fits of every kind and a turn within the bore are no slide.
TEST(ContactLimits, RingsWithFitsAreNotWarnedOf) {
  for (const char* fit : {"INTERFERENCE=0.01", "GAP=0.02", ""}) {
    const auto s = test::solve_text(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=PIN
$MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=10 NR=4 NT=40
$ENDNET
$NET NAME=RING
$MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=20 NR=4 NT=36
$ENDNET
$MATERIAL NAME=M E=200000 NU=0.3
$PROPERTY ESET=PIN.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=RING.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  RING.OUTER
$LOAD CASE=F TYPE=RESULTANT
  PIN.BODY 500 300
$CONTACT NAME=C SLAVE=PIN.OUTER MASTER=RING.INNER {}
$STEP NAME=S
  LOAD F 1
$END
)",
                                                fit));
    ASSERT_TRUE(s);
    EXPECT_FALSE(has(notes_of(*s), "warning")) << notes_of(*s);
  }
}

// A bush with a fit of nothing and a pin with clearance, pulled by ever less: closed rows without
// force and gaps without end beside each other. Where everything is in proportion to the load (the
// clearance shrinks with it) so are all pressures, and the way to them stays short.
TEST(LooseJoints, AreSolvedForLoadsOfAnySize) {
  std::vector<double> pressure;
  for (const double load : {1.0, 1e-3, 1e-6}) {
    const auto s = test::solve_text(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LUG
$MESH SHAPE=RING TYPE=TRIMC6 RI=10 RO=25 NR=5 NT=53
$ENDNET
$NET NAME=BUSH
$MESH SHAPE=RING TYPE=QUAMC8 RI=8 RO=10 NR=2 NT=60
$ENDNET
$NET NAME=PIN
$MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=8 NR=4 NT=54
$ENDNET
$MATERIAL NAME=M E=200000 NU=0.3
$PROPERTY ESET=LUG.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=BUSH.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=PIN.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LUG.OUTER
$LOAD CASE=F TYPE=RESULTANT
  PIN.BODY {0} 0
$CONTACT NAME=B SLAVE=BUSH.OUTER MASTER=LUG.INNER DIAMETRAL=0
$CONTACT NAME=P SLAVE=PIN.OUTER MASTER=BUSH.INNER GAP={1}
$STEP NAME=BACK
  LOAD F -0.2
$STEP NAME=UP
  LOAD F 1
$END
)",
                                                5000.0 * load, 0.02 * load));
    ASSERT_TRUE(s);
    const results::LoadStepResult& up = s->step(1);
    EXPECT_LT(up.pivots, 2000) << load;
    EXPECT_NEAR(up.contacts[0].force_on_slave.x(), -5000.0 * load, 1e-6 * 5000.0 * load);
    pressure.push_back(up.contacts[0].max_pressure / load);
  }
  EXPECT_NEAR(pressure[1], pressure[0], 1e-6 * pressure[0]);
  EXPECT_NEAR(pressure[2], pressure[0], 1e-6 * pressure[0]);
}

} // namespace
} // namespace spricka::test_contact_limits
