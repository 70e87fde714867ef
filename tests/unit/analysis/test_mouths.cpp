// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks whose mouth is exactly where something ends that holds one of their faces: a mouth beside
// it, by much less than any element, must give the same K.
#include "tests/unit/support/run_text.hpp"

#include <cmath>
#include <fmt/format.h>

namespace spricka::test_mouths {
namespace {

struct K {
  double one = 0.0, two = 0.0;
};

// K of crack C at step S of a deck with the mouth at (e, 0).
K intensity(const std::string& text, double e) {
  const test::Folder folder;
  const std::string deck = fmt::format("$DECK VERSION=1 LENGTH=mm FORCE=N\n$PARAMETER\n  e = {}\n{}"
                                       "$STEP NAME=S\n  LOAD T 1\n$END\n",
                                       e, text);
  const test::Outcome outcome = test::run_text(folder, deck);
  if (outcome.exit_code != 0) {
    ADD_FAILURE() << outcome.messages << deck;
    return {};
  }
  const std::filesystem::path csv = folder.path() / "out" / "k.csv";
  return {test::column(csv, "K1").at(0), test::column(csv, "K2").at(0)};
}

void expect_alike(const std::string& text, double e = 1e-5) {
  const K at = intensity(text, 0.0);
  const K beside = intensity(text, e);
  EXPECT_GT(std::hypot(beside.one, beside.two), 1e-6);
  const double within = 0.012 * std::hypot(beside.one, beside.two);
  EXPECT_NEAR(at.one, beside.one, within) << text;
  EXPECT_NEAR(at.two, beside.two, within) << text;
}

const std::string plate = R"($MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-1 LX=2 LY=1 NX=16 NY=8
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$NSET NAME=L FROM=YMIN WHERE=(x < 1e-9)
$NSET NAME=R FROM=YMIN WHERE=(x > -1e-9)
$CRACK NAME=C A0=0.1 ANGLE=90[deg]
  (e) 0
)";
const std::string pull = "$LOAD CASE=T TYPE=TRACTION\n  XMAX 1 0\n  XMIN -1 0\n  YMAX 0 0.5\n";

TEST(Mouths, AClampThatEndsThereHoldsTheFaceOnItsSide) {
  expect_alike(plate + "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  L\n" + pull);
  expect_alike(plate + "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  R\n" + pull, -1e-5);
}

TEST(Mouths, SetsOfFacesAlike) {
  expect_alike(plate +
               "$FSET NAME=F FROM=YMIN WHERE=(x < 1e-9)\n"
               "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  F\n" +
               pull);
}

// Rollers beside a clamp: of each the face on its side. Rollers that begin an edge farther on, as
// those cannot, hold no node of the mouth.
TEST(Mouths, SupportsThatMeetThereHoldOneFaceEach) {
  const std::string clamp = "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  L\n";
  const std::string rollers = "$FREEDOM CLASS=SUPPRESSED DOF=Y\n";
  const std::string beyond = "$NSET NAME=B FROM=YMIN WHERE=(x > 0.124)\n";
  const K met = intensity(plate + clamp + rollers + "  R\n" + pull, 0.0);
  const K apart = intensity(plate + beyond + clamp + rollers + "  B\n" + pull, 0.0);
  const K closed = intensity(plate + "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  YMIN\n" + pull, 0.0);
  EXPECT_NEAR(met.one, apart.one, 0.02 * apart.one);
  EXPECT_GT(met.one, 4.0 * closed.one);
}

TEST(Mouths, APrescribedEdgeAlike) {
  expect_alike(plate + "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  XMAX\n"
                       "$FREEDOM CLASS=PRESCRIBED DOF=XY\n  L\n"
                       "$LOAD CASE=T TYPE=DISP\n  L -0.001 0\n");
}

TEST(Mouths, ARigidTieAlike) {
  expect_alike(plate + "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  XMIN\n$MPC TYPE=RIGID SLAVE=L\n"
                       "$LOAD CASE=T TYPE=TRACTION\n  XMAX 1 0\n");
}

TEST(Mouths, ASymmetryEdgeAlike) {
  expect_alike(plate + "$FREEDOM CLASS=SUPPRESSED DOF=Y\n  L\n"
                       "$FREEDOM CLASS=SUPPRESSED DOF=X\n  XMIN\n"
                       "$LOAD CASE=T TYPE=TRACTION\n  XMAX 1 0\n");
}

// From the corner of a clamped side, whose lower edge is free.
TEST(Mouths, ACrackFromAClampedCorner) {
  const std::string corner = R"($MESH SHAPE=BLOCK TYPE=QUAMC8 LX=2 LY=1 NX=16 NY=8
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$FREEDOM CLASS=SUPPRESSED DOF=XY
  XMIN
$LOAD CASE=T TYPE=TRACTION
  XMAX 0 1
$CRACK NAME=C A0=0.1 ANGLE=45[deg]
  (e) 0
)";
  expect_alike(corner);
}

std::string tied(bool crack_below) {
  return fmt::format(R"($NET NAME=P
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-1 LX=2 LY=1 NX=32 NY=16
  $NSET NAME=CL FROM=YMIN WHERE=(x < 1e-9)
  $NSET NAME=CR FROM=YMIN WHERE=(x > -1e-9)
$ENDNET
$NET NAME=Q
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-1 Y0=-0.5 LX={0} LY=0.5 NX=16 NY=16
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=P.BODY MATERIAL=M STATE=STRAIN
$PROPERTY ESET=Q.BODY MATERIAL=M STATE=STRAIN
$FREEDOM CLASS=SUPPRESSED DOF=XY
  Q.YMIN
$LOAD CASE=T TYPE=TRACTION
  P.XMAX 1 0
  P.YMAX 0 1
$CRACK NAME=C NET={1} A0=0.1 ANGLE={2}[deg]
  (e) 0
)",
                     crack_below ? 2 : 1, crack_below ? "Q" : "P", crack_below ? -90 : 90);
}

TEST(Mouths, ATransitionThatEndsThereTiesTheFaceOnItsSide) {
  const std::string tie = "$MPC TYPE=TRANSITION SLAVE=P.CL MASTER=Q.YMAX\n";
  expect_alike(tied(false) + tie);
}

// The crack opens in the master: of a slave that ends at the mouth the face on its side is tied, of
// one that goes on across it both, as a bonded contact does. (The patch is finer than the slave, so
// that ties of points are a few per cent off, which W503 says.)
TEST(Mouths, ATransitionTiesTheFacesOfAMasterThatOpens) {
  const std::string load = "  P.XMAX 1 0\n";
  std::string body = tied(true);
  body.replace(body.find(load), load.size(), "  Q.XMAX 1 0\n");
  for (const char* slave : {"P.CL", "P.CR", "P.YMIN"}) {
    const K tie =
        intensity(body + fmt::format("$MPC TYPE=TRANSITION SLAVE={} MASTER=Q.YMAX\n", slave), 0.0);
    const K bond = intensity(
        body + fmt::format("$CONTACT NAME=K TYPE=BONDED SLAVE={} MASTER=Q.YMAX\n", slave), 0.0);
    const double within = 0.035 * std::hypot(bond.one, bond.two);
    EXPECT_NEAR(tie.one, bond.one, within) << slave;
    EXPECT_NEAR(tie.two, bond.two, within) << slave;
  }
}

// A crack from a clamped side, half and whole.
TEST(Mouths, AHalfModelKeepsItsClampedSide) {
  const std::string material = "$MATERIAL NAME=M E=1000 NU=0.3\n"
                               "$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN\n"
                               "$LOAD CASE=T TYPE=PRESSURE\n";
  const std::string half = "$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=2 LY=1 NX=32 NY=16\n"
                           "$NSET NAME=LINE FROM=YMIN ORDER=(x)\n"
                           "$FREEDOM CLASS=SUPPRESSED DOF=Y\n  LINE\n"
                           "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  XMIN\n"
                           "$CRACK NAME=C PATH=LINE A0=0.3\n" +
                           material + "  C.LEFT 1\n";
  const std::string full = "$MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=-1 LX=2 LY=2 NX=32 NY=32\n"
                           "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  XMIN\n"
                           "$CRACK NAME=C A0=0.3 ANGLE=0\n  0 0\n" +
                           material + "  C.LEFT 1\n  C.RIGHT 1\n";
  const K one = intensity(half, 0.0);
  const K both = intensity(full, 0.0);
  EXPECT_NEAR(one.one, both.one, 5e-3 * both.one);
}

std::string refused(const std::string& text) {
  const test::Folder folder;
  const test::Outcome outcome =
      test::run_text(folder, "$DECK VERSION=1 LENGTH=mm FORCE=N\n$PARAMETER\n  e = 0\n" + text +
                                 "$STEP NAME=S\n  LOAD T 1\n$END\n");
  EXPECT_NE(outcome.exit_code, 0);
  return outcome.messages;
}

const std::string point = "$NSET NAME=P FROM=YMIN WHERE=(abs(x) < 1e-9)\n";

TEST(Mouths, ASingleNodeThereTellsNoFace) {
  const std::string clamp = "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  XMIN\n";
  for (const std::string& card : {std::string("$FREEDOM CLASS=SUPPRESSED DOF=Y\n  P\n") + pull,
                                  "$NSET NAME=W\n  P XMAX\n$MPC TYPE=RIGID SLAVE=W\n" + pull,
                                  std::string("$LOAD CASE=T TYPE=FORCE\n  P 0 1\n")}) {
    EXPECT_NE(refused(fmt::format("{}{}{}{}", plate, point, clamp, card)).find("E437"),
              std::string::npos)
        << card;
  }
}

TEST(Mouths, TheFaceThatAHalfModelLacksIsNotLoaded) {
  const std::string half = "$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=1 LY=2 NX=8 NY=16\n"
                           "$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)\n"
                           "$MATERIAL NAME=M E=1000 NU=0.3\n"
                           "$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN\n"
                           "$FREEDOM CLASS=SUPPRESSED DOF=Y\n  LINE\n"
                           "$FREEDOM CLASS=SUPPRESSED DOF=X\n  XMAX\n"
                           "$CRACK NAME=C PATH=LINE A0=0.3\n";
  for (const char* load : {"PRESSURE\n  C.RIGHT 1\n", "TRACTION\n  C.RIGHT 0 1\n",
                           "PRESSURE\n  C.LEFT 1\n  C.RIGHT 1\n"}) {
    const std::string said = refused(half + "$LOAD CASE=T TYPE=" + load);
    EXPECT_NE(said.find("E438"), std::string::npos) << said;
    EXPECT_NE(said.find("C.LEFT alone"), std::string::npos) << said;
  }
}

// A rigid line wedges a part of the crack open: the patch has no node where the set of the host
// ends. (A load there is refused, as its total changes.)
TEST(Mouths, BordersOfContactsThatAPatchMovesAreTold) {
  const auto said = [](const std::string& tip_net) {
    const test::Folder folder;
    const test::Outcome outcome = test::run_text(
        folder, "$DECK VERSION=1 LENGTH=mm FORCE=N\n"
                "$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=1 LY=2 NX=10 NY=20\n"
                "$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)\n"
                "$FSET NAME=UNDER FROM=YMIN WHERE=(x < 0.401)\n"
                "$MATERIAL NAME=M E=1000 NU=0.3\n"
                "$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN\n"
                "$FREEDOM CLASS=SUPPRESSED DOF=Y\n  LINE\n"
                "$FREEDOM CLASS=SUPPRESSED DOF=X\n  XMAX\n"
                "$CRACK NAME=C PATH=LINE A0=0.5\n" +
                    tip_net +
                    "$RIGID NAME=WEDGE SHAPE=LINE X0=-1 Y0=0 X1=1 Y1=0\n"
                    "$CONTACT NAME=WEDGE SLAVE=UNDER MASTER=WEDGE INTERFERENCE=1e-4\n"
                    "$STEP NAME=S\n  FIT WEDGE 1\n$END\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
    return outcome.messages;
  };
  const std::string moved = said("");
  EXPECT_NE(moved.find("W425"), std::string::npos) << moved;
  EXPECT_NE(moved.find("UNDER at (0.4, 0)"), std::string::npos) << moved;
  const std::string kept = said("$TIPNET CRACK=C PATCH=NO\n");
  EXPECT_EQ(kept.find("W425"), std::string::npos) << kept;
}

} // namespace
} // namespace spricka::test_mouths
