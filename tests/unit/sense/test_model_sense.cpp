// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/check_text.hpp"

#include <fmt/format.h>

/// Models that the language allows and that hardly anybody means.
namespace spricka::test_model_sense {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string messages(const std::string& text) {
  const test::Folder folder;
  return test::check_text(folder, text).outcome.messages;
}

constexpr std::string_view frame = R"($DECK VERSION=1 LENGTH=mm FORCE=N
{}
$MATERIAL NAME=M E=200000 NU=0.3
$PROPERTY ESET=A.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=B.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  A.XMIN B.XMAX
$LOAD CASE=F TYPE=TRACTION
  A.YMAX 0 1
{}
$STEP NAME=S
  LOAD F 1
$END
)";

std::string two_nets(const std::string& a, const std::string& b, const std::string& cards = "") {
  const std::string nets =
      fmt::format("$NET NAME=A\n$MESH TYPE=QUAMC8 {}\n$ENDNET\n$NET NAME=B\n$MESH TYPE=QUAMC8 "
                  "{}\n$ENDNET",
                  a, b);
  return fmt::format(fmt::runtime(frame), nets, cards);
}

const std::string left = "SHAPE=BLOCK LX=10 LY=10 NX=3 NY=3";

TEST(UnjoinedBodies, SidesThatLieOnEachOtherWhateverTheirDivision) {
  for (const std::string right :
       {"SHAPE=BLOCK X0=10 LX=5 LY=10 NX=2 NY=3", "SHAPE=BLOCK X0=10 LX=5 LY=10 NX=2 NY=7",
        "SHAPE=BLOCK X0=10 Y0=7 LX=5 LY=10 NX=2 NY=2",
        "SHAPE=BLOCK X0=10 Y0=4 LX=2 LY=1 NX=2 NY=2"}) {
    const std::string said = messages(two_nets(left, right));
    EXPECT_TRUE(has(said, "W451")) << right << said;
    EXPECT_TRUE(has(said, "A and B are drawn touching")) << said;
  }
}

TEST(UnjoinedBodies, PointsGapsAndBodiesUponEachOtherAreNotSeams) {
  for (const std::string right :
       {"SHAPE=BLOCK X0=10 Y0=10 LX=5 LY=10 NX=2 NY=3", // corner on corner
        "SHAPE=BLOCK X0=10.01 LX=5 LY=10 NX=2 NY=3",    // a gap
        "SHAPE=BLOCK X0=0 LX=10 LY=10 NX=2 NY=5",       // a doubler
        "SHAPE=BLOCK X0=2 LX=8 LY=10 NX=2 NY=5"}) {
    EXPECT_FALSE(has(messages(two_nets(left, right)), "W451")) << right;
  }
}

TEST(UnjoinedBodies, ContactsTiesAndSupportsSettleASide) {
  const std::string right = "SHAPE=BLOCK X0=10 LX=5 LY=10 NX=2 NY=6";
  for (const std::string cards : {"$CONTACT NAME=C SLAVE=A.XMAX MASTER=B.XMIN",
                                  "$CONTACT NAME=C SLAVE=A.XMAX "
                                  "MASTER=B.XMIN TYPE=BONDED",
                                  "$MPC TYPE=TRANSITION SLAVE=B.XMIN MASTER=A.XMAX",
                                  "$FREEDOM CLASS=SUPPRESSED DOF=X\n  A.XMAX B.XMIN"}) {
    EXPECT_FALSE(has(messages(two_nets(left, right, cards)), "W451")) << cards;
  }
}

TEST(UnjoinedBodies, InSpaceCornerOnCorner) {
  const auto deck = [](const std::string& cards) {
    return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=A
$MESH SHAPE=BLOCK TYPE=HEXE8 LX=2 LY=2 LZ=2 NX=2 NY=2 NZ=2
$ENDNET
$NET NAME=B
$MESH SHAPE=BLOCK TYPE=HEXE8 X0=2 LX=2 LY=2 LZ=2 NX=2 NY=2 NZ=2
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=A.BODY MATERIAL=M STATE=SOLID
$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  A.XMIN B.XMAX
$LOAD CASE=F TYPE=TRACTION
  A.YMAX 0 1 0
{}
$STEP NAME=S
  LOAD F 1
$END
)",
                       cards);
  };
  EXPECT_TRUE(has(messages(deck("")), "touching in 4 sides")) << messages(deck(""));
  EXPECT_FALSE(has(messages(deck("$MPC TYPE=TRANSITION SLAVE=B.XMIN MASTER=A.XMAX")), "W451"));
}

// A pin drawn in its bore, other divisions on either side: curves lie on each other as well.
TEST(UnjoinedBodies, CurvedSides) {
  std::string text = R"($DECK VERSION=1 LENGTH=m FORCE=N
$NET NAME=PIN
$MESH SHAPE=RING TYPE=QUAMC8 RI=0.004 RO=0.01 NR=3 NT=30
$ENDNET
$NET NAME=RING
$MESH SHAPE=RING TYPE=QUAMC8 RI=0.01 RO=0.02 NR=3 NT=44
$ENDNET
$MATERIAL NAME=M E=2e11 NU=0.3
$PROPERTY ESET=PIN.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=RING.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  RING.OUTER PIN.INNER
$LOAD CASE=F TYPE=RESULTANT
  PIN.BODY 500 300
$STEP NAME=S
  LOAD F 1
$END
)";
  EXPECT_TRUE(has(messages(text), "PIN and RING are drawn touching along 0.06")) << messages(text);
}

std::string strip(const std::string& cards, const std::string& load = "YMAX 0 10") {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=20 LY=40 NX=10 NY=20
$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)
$NSET NAME=AHEAD WHERE=(abs(y) < 1e-9 and x > 3) ORDER=(x)
$NSET NAME=INSIDE WHERE=(abs(y-20) < 1e-9 and x > 3) ORDER=(x)
$NSET NAME=CORNER WHERE=(abs(y) < 1e-9 and abs(x-20) < 1e-9)
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  CORNER
$LOAD CASE=F TYPE=TRACTION
  {}
$STEP NAME=S
  LOAD F 1
{}
$END
)",
                     load, cards);
}

const std::string symmetric = "$FREEDOM CLASS=SUPPRESSED DOF=Y\n  LINE\n";

TEST(HeldPlaces, ALoadThatGoesIntoItsSupport) {
  EXPECT_TRUE(has(messages(strip(symmetric, "YMIN 0 -10")), "W457"));
  EXPECT_FALSE(has(messages(strip(symmetric, "YMIN 3 -10")), "W457")); // x is free
  EXPECT_FALSE(has(messages(strip(symmetric, "YMAX 0 0")), "W457"));   // there is none
  EXPECT_FALSE(has(messages(strip(symmetric)), "W457"));
  // Squares of such loads are beyond the range of numbers.
  EXPECT_TRUE(has(messages(strip(symmetric, "YMIN 0 -1e200")), "W457"));
  EXPECT_FALSE(has(messages(strip(symmetric, "YMAX 0 1e200")), "W457"));
}

// A displacement counts where it is prescribed: elsewhere nothing is left out.
TEST(ShortLoads, WantTheValuesThatCount) {
  const auto moved = [](const std::string& along) {
    return messages(strip(symmetric + "$FREEDOM CLASS=PRESCRIBED DOF=" + along +
                          "\n  XMAX\n$LOAD CASE=F TYPE=DISP\n  XMAX 0.1\n"));
  };
  EXPECT_FALSE(has(moved("X"), "W312")) << moved("X");
  EXPECT_TRUE(has(moved("XY"), "W312: TYPE=DISP has 1 of 2 values: along y")) << moved("XY");
  EXPECT_TRUE(has(messages(strip(symmetric, "YMAX 3")), "W312"));
}

TEST(HeldPlaces, AMouthThatCannotOpen) {
  const std::string crack = "$CRACK NAME=C A0=4 ANGLE=0\n  0 21\n";
  const std::string held = "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  XMIN\n";
  EXPECT_TRUE(has(messages(strip(symmetric + crack + held)), "W458"));
  EXPECT_FALSE(has(messages(strip(symmetric + crack)), "W458"));
}

// The floor is a base for the block; a body with a load of its own is more than that.
TEST(HeldPlaces, AContactSurfaceThatIsAllHeld) {
  const std::string held = "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  B.XMIN\n"
                           "$CONTACT NAME=C SLAVE=A.XMAX MASTER=B.XMIN\n";
  const std::string right = "SHAPE=BLOCK X0=10 LX=5 LY=10 NX=2 NY=6";
  EXPECT_FALSE(has(messages(two_nets(left, right, held)), "W458"));
  const std::string load = "$LOAD CASE=F TYPE=TRACTION\n  B.YMAX 0 1\n";
  EXPECT_TRUE(has(messages(two_nets(left, right, held + load)), "W458"));
}

TEST(PathMouths, APathBeginsWhereTheBoundaryTurns) {
  EXPECT_FALSE(has(messages(strip(symmetric + "$CRACK NAME=C PATH=LINE A0=4")), "W459"));
  const std::string inside = messages(strip(symmetric + "$CRACK NAME=C PATH=AHEAD A0=4"));
  EXPECT_TRUE(has(inside, "W459") && has(inside, "PATH begins at (4, 0)")) << inside;
  EXPECT_TRUE(has(inside, "held like a line of symmetry")) << inside;
  const std::string open =
      messages(strip("$FREEDOM CLASS=SUPPRESSED DOF=Y\n  AHEAD\n$CRACK NAME=C PATH=AHEAD A0=4"));
  EXPECT_TRUE(has(open, "W459") && has(open, "as if cracked already")) << open;
  const std::string slit = symmetric + "$CRACK NAME=C PATH=INSIDE A0=4\n";
  EXPECT_TRUE(has(messages(strip(slit)), "E421")) << messages(strip(slit));
  const std::string doubled = messages(strip(slit + "$TIPNET CRACK=C PATCH=NO"));
  EXPECT_TRUE(has(doubled, "E458")) << doubled;
}

// A block on a rigid floor, held along x by its side: what it says when the floor does not hold it.
std::string on_the_floor(const std::string& steps) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=10 NX=2 NY=2
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=X
  XMIN
$RIGID NAME=FLOOR SHAPE=LINE X0=-10 Y0=0 X1=20 Y1=0
$CONTACT NAME=FOOT SLAVE=YMIN MASTER=FLOOR GAP=0
$LOAD CASE=F TYPE=TRACTION
  YMAX  0  -1
{}
$END
)",
                     steps);
}

TEST(LetGo, AContactThatIsThereButDoesNotHold) {
  const auto says = [](const std::string& deck, const std::string& part) {
    const std::string text = messages(deck);
    EXPECT_TRUE(has(text, "E510") && has(text, part)) << text;
  };
  says(on_the_floor("$STEP NAME=A\n  LOAD F 1\n$STEP NAME=B\n  MOUNT FOOT\n"),
       "its contact FOOT is not mounted before step B");
  says(on_the_floor("$STEP NAME=A\n  LOAD F 1\n$STEP NAME=B\n  DISMOUNT FOOT\n"),
       "step B: body MODEL is loaded but not held: direction Y: its contact FOOT was dismounted in "
       "step B");
  says(on_the_floor("$STEP NAME=A\n  LOAD F -1\n"), "contact FOOT only presses");
}

// Rings may grow six times from one to the next, whatever the unit.
TEST(SteepRings, AreRefusedWithTheRemedy) {
  const std::string crack = symmetric + "$CRACK NAME=C PATH=LINE A0=4\n$TIPNET CRACK=C ";
  for (const std::string size : {"SIZE=1e-9", "SIZE=1e-4", "SIZE=1e-4 RADIUS=1"}) {
    const std::string said = messages(strip(crack + size));
    EXPECT_TRUE(has(said, "E457") && has(said, "RINGS=")) << size << said;
  }
  for (const std::string size : {"SIZE=0.01", "SIZE=1e-4 RINGS=12", "SIZE=1e-4 RADIUS=0.1"}) {
    EXPECT_FALSE(has(messages(strip(crack + size)), "E457")) << size;
  }
}

} // namespace
} // namespace spricka::test_model_sense
