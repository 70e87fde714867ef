// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/crack_face_plate.hpp"

// Crack faces that touch, together with whatever else a deck may hold.
namespace spricka::test_crack_face_company {
namespace {

using test::bent;
using test::faces;
using test::plate;
using test::root_pi;
using test::solve_text;
using test::Solved;
using test::stressed;

// Two cracks of which one closes: the other is left as it is.
TEST(CrackFaceContact, OnlyFacesThatMeetAreAPair) {
  const std::string cracks = "$CRACK NAME=UP\n  -1 8\n  1 8\n$CRACK NAME=ACROSS\n  0 -9\n  0 -7\n";
  const std::optional<Solved> solved = solve_text(plate(cracks, stressed(-1.0, 1.0, 0.0)));
  ASSERT_TRUE(solved);
  ASSERT_EQ(solved->step().contacts.size(), 1U);
  EXPECT_EQ(solved->step().contacts[0].name, "ACROSS.FACES");
  EXPECT_GT(solved->step().fronts[0].single_point().K1, 0.9 * root_pi);
  EXPECT_EQ(solved->step().fronts[2].single_point().K1, 0.0);
}

// Linear elements and tips without quarter points have contact between their faces too.
TEST(CrackFaceContact, OnTheDecksOwnElements) {
  const auto solve = [](const std::string& type, const std::string& tip) {
    return solve_text(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE={} X0=0 Y0=-6 LX=8 LY=12 NX=32 NY=48
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)
$NSET NAME=END WHERE=(abs(y) < 1e-9 and abs(x-8) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  END
$NSET NAME=OTHER WHERE=(abs(y+6) < 1e-9 and abs(x-8) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=X
  OTHER
$CRACK NAME=C PATH=LINE A0=5
{}$LOAD CASE=F TYPE=TRACTION
  YMAX 0 (x-3)
  YMIN 0 (3-x)
$STEP NAME=S
  LOAD F 1
$END
)",
                                  type, tip));
  };
  const std::optional<Solved> patch = solve("QUAMC8", "");
  ASSERT_TRUE(patch);
  const double K = patch->step().fronts[0].single_point().K1;
  for (const std::string type : {"QUAM4", "QUAMC8", "QUAMC9"}) {
    const std::optional<Solved> solved = solve(type, "$TIPNET CRACK=C PATCH=NO QUARTER=NO\n");
    ASSERT_TRUE(solved);
    EXPECT_GT(faces(*solved).closed, 0) << type;
    EXPECT_GE(faces(*solved).min_pressure, 0.0);
    EXPECT_NEAR(faces(*solved).max_penetration, 0.0, 1e-12);
    EXPECT_NEAR(faces(*solved).arc_to, faces(*patch).arc_to, 0.15) << type;
    EXPECT_NEAR(solved->step().fronts[0].single_point().K1, K, 0.01 * K) << type;
    EXPECT_FALSE(solved->step().fronts[0].single_point().closed);
  }
}

// K on load paths on which the faces meet, between the steps or only beyond the last, is that of
// steps: bending x + r with r = 0.7 - t.
TEST(CrackFaceContact, LoadPathsCloseFaces) {
  const auto path = [](double beyond) {
    return plate("$CRACK NAME=C\n  -1 0\n  1 0\n", fmt::format(R"($LOAD CASE=BEND TYPE=TRACTION
  YMAX 0 (x)
  YMIN 0 (-x)
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 0 1
  YMIN 0 -1
$STEP NAME=FIRST
  LOAD BEND 1
  LOAD PULL 0.7
$STEP NAME=LAST
  LOAD PULL {}
$LOADPATH NAME=P FROM=FIRST TO=LAST BEYOND={}
)",
                                                               0.7 - 2.0 / beyond, beyond));
  };
  for (const double beyond : {1.0, 16.0}) { // the ends of the second are both open
    const std::optional<Solved> solved = test::solve_text_with_raw_K(path(beyond));
    ASSERT_TRUE(solved);
    const results::LoadPathResult& found = solved->run.increments[0].paths.at(0);
    EXPECT_LT(found.mismatch, 1e-6);
    EXPECT_TRUE(found.fronts[1].front_without_points.invalid_reason.empty());
    EXPECT_GT(found.t.size(), 10U);
    for (const double t : {0.05, 0.4, 0.7, 1.3, 1.95}) {
      const std::optional<Solved> step = test::solve_text_with_raw_K(bent(0.7 - t));
      ASSERT_TRUE(step);
      for (const std::size_t tip : {std::size_t{0}, std::size_t{1}}) {
        EXPECT_NEAR(found.fronts[tip].single_point().K[0](0.5 * beyond * t),
                    step->step().fronts[tip].single_point().K1, 1e-6)
            << beyond << ' ' << t;
      }
    }
  }
}

// The mouth of a closed crack in the middle of a contact surface (S11): blocks under pressure from
// all sides do not feel the crack, whatever the pairing of their own contact.
TEST(CrackFaceContact, MouthInAnotherContact) {
  for (const std::string pairing : {"SLAVE=TOP.YMIN MASTER=LOW.YMAX PAIRING=SEGMENT",
                                    "SLAVE=LOW.YMAX MASTER=TOP.YMIN PAIRING=SEGMENT",
                                    "SLAVE=TOP.YMIN MASTER=LOW.YMAX PAIRING=NODE",
                                    "SLAVE=LOW.YMAX MASTER=TOP.YMIN PAIRING=NODE"}) {
    for (const std::string mu : {"0", "0.4"}) {
      const std::optional<Solved> solved =
          solve_text(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LOW
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=0 Y0=0 LX=8 LY=6 NX=8 NY=6
  $NSET NAME=DOWN WHERE=(abs(x-4) < 1e-9) ORDER=(-y)
$ENDNET
$NET NAME=TOP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=0 Y0=6 LX=8 LY=3 NX=8 NY=3
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=Y
  LOW.YMIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  LOW.XMIN
  TOP.XMIN
$CONTACT NAME=PRESSED {}
$CRACK NAME=C PATH=LOW.DOWN A0=3 MU={}
$TIPNET CRACK=C PATCH=NO
$LOAD CASE=F TYPE=PRESSURE
  TOP.YMAX 2
  TOP.XMAX 2
  LOW.XMAX 2
$STEP NAME=S
  LOAD F 1
$END
)",
                                 pairing, mu));
      ASSERT_TRUE(solved) << pairing;
      const double strain = -2.0 * 0.7 / 1000.0;
      for (std::size_t n = 0; n < solved->mesh().node_count(); ++n) {
        const base::Vec3& x = solved->mesh().x[n];
        const base::Vec3 u = solved->u(base::NodeId(n));
        EXPECT_NEAR(u.x(), strain * x.x(), 1e-9 * std::abs(strain) * 9.0);
        EXPECT_NEAR(u.y(), strain * x.y(), 1e-9 * std::abs(strain) * 9.0);
      }
      EXPECT_NEAR(faces(*solved).min_pressure, 2.0, 1e-7);
      EXPECT_NEAR(faces(*solved).max_pressure, 2.0, 1e-7);
      EXPECT_EQ(solved->step().fronts[0].single_point().K1, 0.0);
    }
  }
}

// A block with a crack that bending closes in part; then another block is mounted on it, and
// pressed.
std::string mounted_on(const std::string& length, const std::string& growth) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LOW
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=0 Y0=0 LX=20 LY=12 NX=20 NY=12
$ENDNET
$NET NAME=TOP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=4 Y0=12 LX=3 LY=3 NX=3 NY=3
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=STRESS
$NSET NAME=HELD WHERE=(x < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  HELD
$FREEDOM CLASS=SUPPRESSED DOF=X
  TOP.XMIN
$CONTACT NAME=ON SLAVE=TOP.YMIN MASTER=LOW.YMAX GAP=0
$CRACK NAME=C NET=LOW A0={} ANGLE=90[deg]
  10 0
$LOAD CASE=BEND TYPE=TRACTION
  LOW.XMAX (y-4) 0
$LOAD CASE=PRESS TYPE=PRESSURE
  TOP.YMAX 1
$STEP NAME=FIRST
  LOAD BEND 1
$STEP NAME=SECOND
  MOUNT ON
$STEP NAME=THIRD
  LOAD PRESS 1
{}$END
)",
                     length, growth);
}

// Each length of a growing crack finds its own contact; what is mounted at the first one keeps what
// it took on there.
TEST(CrackFaceContact, GrowsWithMountedParts) {
  for (const std::string mounted : {"EACH", "FIRST"}) {
    const std::optional<Solved> grown = solve_text(
        mounted_on("5", "$GROW LAW=INCREMENT KMAX=THIRD MOUNTED=" + mounted + "\n  5 6.5\n"));
    ASSERT_TRUE(grown);
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      if (i == 1 && mounted == "FIRST") {
        continue;
      }
      const std::optional<Solved> alone = solve_text(mounted_on(i == 0 ? "5" : "6.5", ""));
      ASSERT_TRUE(alone);
      ASSERT_EQ(alone->step(0).contacts.size(), 2U);
      EXPECT_GT(alone->step(0).contacts[1].closed, 2);
      for (const std::size_t s : {std::size_t{0}, std::size_t{2}}) {
        const results::LoadStepResult& step = grown->run.increments[i].steps[s];
        const double K1 = alone->step(s).fronts[0].single_point().K1;
        EXPECT_GT(K1, 0.1);
        EXPECT_NEAR(step.fronts[0].single_point().K1, K1, 1e-7 * K1) << i << ' ' << s;
        EXPECT_NEAR(step.contacts[0].force_on_slave.y(),
                    alone->step(s).contacts[0].force_on_slave.y(), 1e-7);
        EXPECT_EQ(step.contacts[1].closed, alone->step(s).contacts[1].closed);
      }
    }
  }
}

} // namespace
} // namespace spricka::test_crack_face_company
