// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/deck_parts.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>

// Nets tied to each other, by decks: one mesh in pieces is the mesh in one piece; forces that pass
// through ties obey statics.
namespace spricka::test_tied_nets {
namespace {

using base::NodeId;
using base::Vec3;
using test::Folder;
using test::head;
using test::held;
using test::load;
using test::net;
using test::property;
using test::solve_text;
using test::Solved;
using test::tied;

// Displacements and reactions of the whole, node by node, against those of the pieces.
void expect_same(const Solved& whole, const Solved& pieces, double tolerance) {
  const double u_size = whole.step().u.lpNorm<Eigen::Infinity>();
  const double r_size = whole.step().reaction.lpNorm<Eigen::Infinity>();
  ASSERT_GT(u_size, 0.0);
  ASSERT_GT(r_size, 0.0);
  for (std::size_t n = 0; n < whole.mesh().node_count(); ++n) {
    Vec3 reaction = Vec3::Zero();
    int found = 0;
    for (std::size_t m = 0; m < pieces.mesh().node_count(); ++m) {
      if ((pieces.mesh().x[m] - whole.mesh().x[n]).norm() < 1e-9) {
        ++found;
        reaction += pieces.reaction(NodeId(m));
        EXPECT_LT((pieces.u(NodeId(m)) - whole.u(NodeId(n))).norm(), tolerance * u_size);
      }
    }
    EXPECT_GE(found, 1);
    EXPECT_LT((reaction - whole.reaction(NodeId(n))).norm(), tolerance * r_size);
  }
  EXPECT_NEAR(pieces.step().energy, whole.step().energy, tolerance * whole.step().energy);
}

void expect_balance(const Solved& solved) {
  for (const results::ForceBalance& b : solved.step().balance) {
    const double size = b.applied.norm() + b.reaction.norm() + b.contact.norm();
    EXPECT_LT((b.applied + b.reaction + b.contact).norm(), 1e-10 * size) << b.body;
  }
}

class MatchingNets : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(tied, MatchingNets,
                         testing::Values("TRIM3", "TRIMC6", "QUAM4", "QUAMC8", "QUAMC9"));

TEST_P(MatchingNets, TwoOrThreeInARowAreOne) {
  const std::string type = std::string("TYPE=") + GetParam();
  const std::string end = load("TRACTION", "C.XMAX 1 3") + "$END\n";
  const auto whole = solve_text(head + net("C", type + " LX=6 LY=2 NX=6 NY=2") +
                                property("C.BODY") + held("C.XMIN") + end);
  const std::string a = net("A", type + " LX=2 LY=2 NX=2 NY=2") + property("A.BODY");
  const auto two = solve_text(head + a + net("C", type + " X0=2 LX=4 LY=2 NX=4 NY=2") +
                              property("C.BODY") + held("A.XMIN") + tied("C.XMIN", "A.XMAX") + end);
  const auto three =
      solve_text(head + a + net("B", type + " X0=2 LX=2 LY=2 NX=2 NY=2") + property("B.BODY") +
                 net("C", type + " X0=4 LX=2 LY=2 NX=2 NY=2") + property("C.BODY") +
                 held("A.XMIN") + tied("C.XMIN", "B.XMAX") + tied("B.XMIN", "A.XMAX") + end);
  ASSERT_TRUE(whole && two && three);
  expect_same(*whole, *two, 1e-10);
  expect_same(*whole, *three, 1e-10);
  expect_balance(*two);
  expect_balance(*three);
  EXPECT_EQ(three->step().balance.size(), 1U); // one body
}

class MatchingSolids : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(tied, MatchingSolids,
                         testing::Values("TET10", "HEXE8", "HEXEC20", "HEXEC27"));

TEST_P(MatchingSolids, TwoOnTopOfEachOtherAreOne) {
  const std::string type = std::string("TYPE=") + GetParam() + " LX=1 LY=1 NX=2 NY=1";
  const std::string end = load("TRACTION", "B.ZMAX 1 2 3") + "$END\n";
  const auto whole = solve_text(head + net("B", type + " LZ=3 NZ=4") + property("B.BODY", "SOLID") +
                                held("B.ZMIN", "XYZ") + end);
  const auto two = solve_text(head + net("A", type + " LZ=1.5 NZ=2") + property("A.BODY", "SOLID") +
                              net("B", type + " Z0=1.5 LZ=1.5 NZ=2") + property("B.BODY", "SOLID") +
                              held("A.ZMIN", "XYZ") + tied("B.ZMIN", "A.ZMAX") + end);
  ASSERT_TRUE(whole && two);
  expect_same(*whole, *two, 1e-10);
  expect_balance(*two);
}

// C lies on A and B, which are tied to each other: at the corner a slave is a master.
TEST(TiedNets, ThreeMeetInACorner) {
  const std::string end = load("TRACTION", "C.YMAX 2 1") + "$END\n";
  const auto whole =
      solve_text(head + net("C", "TYPE=QUAMC8 LX=6 LY=4 NX=6 NY=4") + property("C.BODY") +
                 "$NSET NAME=FOOT WHERE=(abs(x) < 1e-9 and y < 2.1)\n" + held("FOOT") + end);
  const std::string nets = net("A", "TYPE=QUAMC8 LX=2 LY=2 NX=2 NY=2") + property("A.BODY") +
                           net("B", "TYPE=QUAMC8 X0=2 LX=4 LY=2 NX=4 NY=2") + property("B.BODY") +
                           net("C", "TYPE=QUAMC8 Y0=2 LX=6 LY=2 NX=6 NY=2") + property("C.BODY") +
                           "$FSET NAME=FLOOR\n  A.YMAX B.YMAX\n" + held("A.XMIN");
  const std::string upper = tied("C.YMIN", "FLOOR");
  const std::string lower = tied("B.XMIN", "A.XMAX");
  for (const std::string& ties : {upper + lower, lower + upper}) {
    std::string text = head + nets;
    text.append(ties).append(end);
    const auto pieces = solve_text(text);
    ASSERT_TRUE(whole && pieces);
    expect_same(*whole, *pieces, 1e-10);
    expect_balance(*pieces);
  }
}

// Some freedoms of the master edge are prescribed, the others free; constants of equations come on
// top.
TEST(TiedNets, PartlyPrescribedMaster) {
  const std::string end =
      "$LOAD CASE=F TYPE=DISP\n  FLOOR 0 (0.01*x*x)\n" + load("TRACTION", "B.XMAX 1 3") + "$END\n";
  const std::string floor = "$NSET NAME=FLOOR FROM=A.YMIN WHERE=(x < 2.1)\n"
                            "$FREEDOM CLASS=PRESCRIBED DOF=Y\n  FLOOR\n";
  const auto whole = solve_text(head + net("B", "TYPE=QUAMC8 LX=4 LY=2 NX=4 NY=2") +
                                "$NSET NAME=FLOOR FROM=B.YMIN WHERE=(x < 2.1)\n"
                                "$FREEDOM CLASS=PRESCRIBED DOF=Y\n  FLOOR\n" +
                                property("B.BODY") + held("B.XMIN", "X") + end);
  const auto two =
      solve_text(head + net("A", "TYPE=QUAMC8 LX=2 LY=2 NX=2 NY=2") +
                 net("B", "TYPE=QUAMC8 X0=2 LX=2 LY=2 NX=2 NY=2") + property("A.BODY") +
                 property("B.BODY") + held("A.XMIN", "X") + tied("B.XMIN", "A.XMAX") + floor + end);
  ASSERT_TRUE(whole && two);
  expect_same(*whole, *two, 1e-10);
  expect_balance(*two);
}

// A bar pulled by a tie of its free end to its held end: the stress of the strain that the tie
// asks for, and no support force, as a tie between two freedoms pulls at both.
TEST(TiedNets, EquationWithRightHandSide) {
  const auto bar = solve_text(head + net("A", "TYPE=QUAM4 LX=10 LY=2 NX=1 NY=1") +
                              property("A.BODY") + held("A.XMIN", "X") + R"(
$NSET NAME=CORNER WHERE=(abs(x) + abs(y) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  CORNER
$MPC TYPE=EQUATION RHS=0.01
  1 A.2 X  -1 A.1 X
$MPC TYPE=EQUATION RHS=0.02
  -2 A.4 X  2 A.3 X
$LOAD CASE=F TYPE=FORCE
  CORNER 0 0
$STEP NAME=S
  LOAD F 1
$END
)");
  ASSERT_TRUE(bar);
  const double sigma = 1000.0 * 0.01 / 10.0;
  for (const Vec3& x : {Vec3(10.0, 0.0, 0.0), Vec3(10.0, 2.0, 0.0)}) {
    EXPECT_NEAR(bar->u(bar->node_at(x)).x(), 0.01, 1e-14);
  }
  EXPECT_NEAR(bar->u(bar->node_at({10.0, 2.0, 0.0})).y(), -0.25 * 0.001 * 2.0, 1e-14);
  EXPECT_NEAR(bar->step().energy, 0.5 * sigma * 0.001 * 20.0, 1e-12);
  EXPECT_LT(bar->step().reaction.lpNorm<Eigen::Infinity>(), 1e-12 * sigma);
}

// A cantilever with a rigid end, moved by a point of that end outside the mesh.
TEST(TiedNets, PrescribedMasterMovesARigidEnd) {
  const auto beam = solve_text(head + R"($NET NAME=A
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=2 NX=5 NY=2
$ENDNET
$COOR NSET=GRIP DIM=2
  1001 13 1.5
$PROPERTY ESET=A.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  A.XMIN
$FREEDOM CLASS=PRESCRIBED DOF=Y
  GRIP
$NSET NAME=PLATE
  A.XMAX GRIP
$MPC TYPE=RIGID SLAVE=PLATE
$LOAD CASE=F TYPE=DISP
  GRIP 0 0.2
$STEP NAME=S
  LOAD F 1
$END
)");
  ASSERT_TRUE(beam);
  const NodeId grip = beam->node_at({13.0, 1.5, 0.0});
  EXPECT_NEAR(beam->u(grip).y(), 0.2, 1e-15);
  const Vec3 a = beam->u(beam->node_at({10.0, 0.0, 0.0}));
  const Vec3 b = beam->u(beam->node_at({10.0, 2.0, 0.0}));
  const double turn = (a - b).x() / 2.0;
  EXPECT_NEAR(b.y(), a.y(), 1e-14);
  EXPECT_NEAR(beam->u(grip).x(), a.x() - 1.5 * turn, 1e-13);
  EXPECT_NEAR(beam->u(grip).y(), a.y() + 3.0 * turn, 1e-13);
  const Vec3 force = beam->reaction(grip);
  EXPECT_GT(force.y(), 0.0);
  EXPECT_EQ(force.x(), 0.0);
  EXPECT_NEAR(0.5 * force.y() * 0.2, beam->step().energy, 1e-11 * beam->step().energy);
  const auto [sum, moment] = beam->support();
  EXPECT_LT(sum.norm(), 1e-10 * force.norm());
  EXPECT_LT(moment.norm(), 1e-10 * 13.0 * force.norm());
  // the beam's theory with shear and a rigid end of 3: within a few percent
  const double EI = 1000.0 * 8.0 / 12.0;
  const double flexibility = (13.0 * 13.0 * 13.0 - 27.0) / (3.0 * EI) + 10.0 * 1.2 / (400.0 * 2.0);
  EXPECT_NEAR(0.2 / force.y(), flexibility, 0.02 * flexibility);
}

// Two nets tied to one block that only a contact holds up; the tie lets constant stress through, as
// each coarse edge has whole fine edges.
TEST(TiedNets, FloatingTiedBodyOnAContact) {
  const Folder folder;
  const test::Outcome outcome = run_text(
      folder, head + net("LOWER", "TYPE=QUAMC8 LX=10 LY=5 NX=7 NY=3") + property("LOWER.BODY") +
                  net("MIDDLE", "TYPE=QUAMC8 Y0=5 LX=10 LY=2 NX=4 NY=1") + property("MIDDLE.BODY") +
                  net("UPPER", "TYPE=TRIMC6 Y0=7 LX=10 LY=3 NX=8 NY=2") + property("UPPER.BODY") +
                  held("LOWER.YMIN", "Y") + held("LOWER.XMIN MIDDLE.XMIN", "X") +
                  tied("UPPER.YMIN", "MIDDLE.YMAX") +
                  "$CONTACT NAME=FACE SLAVE=MIDDLE.YMIN MASTER=LOWER.YMAX\n" +
                  load("PRESSURE", "UPPER.YMAX 1000") + R"($CHECK
  CPRESS.MIN(FACE,S) = 1000  REL 1e-9  SOURCE 'exact'
  CPRESS.MAX(FACE,S) = 1000  REL 1e-9  SOURCE 'exact'
  S.YY.MIN(UPPER.BODY,S) = -1000  REL 1e-9  SOURCE 'exact'
  S.YY.MAX(UPPER.BODY,S) = -1000  REL 1e-9  SOURCE 'exact'
  S.YY.MAX(MIDDLE.BODY,S) = -1000  REL 1e-9  SOURCE 'exact'
  S.XX.MAX(UPPER.BODY,S) = 0  ABS 1e-6  SOURCE 'exact'
  SUM(FACE,S,Y) = 10000  REL 1e-11  SOURCE 'equilibrium'
  REACTION(LOWER.YMIN,S,Y) = 10000  REL 1e-11  SOURCE 'equilibrium'
$END
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
}

const std::string two_blocks = head + net("A", "TYPE=QUAMC8 LX=2 LY=2 NX=1 NY=1") +
                               net("B", "TYPE=QUAMC8 X0=2 LX=2 LY=2 NX=2 NY=2") +
                               property("A.BODY") + property("B.BODY");

// A force on a slave node at a quarter of the master edge is forces on its three nodes by their
// shape functions.
TEST(TiedNets, LoadOnADependentFreedomReachesItsMasters) {
  const std::string sets = R"(
$NSET NAME=SLAVE FROM=B.XMIN WHERE=(abs(y - 0.5) < 1e-6)
$NSET NAME=LOW   FROM=A.XMAX WHERE=(y < 0.1)
$NSET NAME=MID   FROM=A.XMAX WHERE=(abs(y - 1) < 0.1)
$NSET NAME=HIGH  FROM=A.XMAX WHERE=(y > 1.9)
)";
  const std::string model = two_blocks + sets + held("A.XMIN") + tied("B.XMIN", "A.XMAX");
  const auto slave = solve_text(model + load("FORCE", "SLAVE 8 16") + "$END\n");
  const auto masters =
      solve_text(model + load("FORCE", "LOW 3 6\n  MID 6 12\n  HIGH -1 -2") + "$END\n");
  ASSERT_TRUE(slave && masters);
  const double size = masters->step().u.lpNorm<Eigen::Infinity>();
  ASSERT_GT(size, 0.0);
  EXPECT_LT((slave->step().u - masters->step().u).lpNorm<Eigen::Infinity>(), 1e-12 * size);
  expect_balance(*slave);
  const NodeId n = slave->node_at({2.0, 0.5, 0.0});
  EXPECT_NEAR(slave->step().energy, 0.5 * slave->u(n).dot(Vec3(8.0, 16.0, 0.0)),
              1e-11 * slave->step().energy);
}

// The support stands on the master side, on the slave side, or on both; statics is the same.
TEST(TiedNets, ReactionsAtSupportsOfATie) {
  for (const char* where : {"A.XMAX", "B.XMIN", "A.XMAX B.XMIN"}) {
    SCOPED_TRACE(where);
    const auto solved = solve_text(two_blocks + held(where) + tied("B.XMIN", "A.XMAX") +
                                   load("TRACTION", "B.XMAX 1 3\n  A.XMIN 2 -1") + "$END\n");
    ASSERT_TRUE(solved);
    const auto [sum, moment] = solved->support();
    // forces (2, 6) at (4, 1) and (4, -2) at (0, 1)
    EXPECT_LT((sum + Vec3(6.0, 4.0, 0.0)).norm(), 1e-10);
    EXPECT_NEAR(moment.z(), -(4.0 * 6.0 - 2.0 - 4.0), 1e-10);
    for (std::size_t n = 0; n < solved->mesh().node_count(); ++n) {
      if (std::abs(solved->mesh().x[n].x() - 2.0) < 1e-9) {
        EXPECT_LT(solved->u(NodeId(n)).norm(), 1e-13);
      }
    }
  }
}

test::Outcome run_mpcs(const std::string& more) {
  const Folder folder;
  return run_text(folder, two_blocks + held("A.XMIN") + tied("B.XMIN", "A.XMAX") + more +
                              load("FORCE", "B.XMAX 1 0") + "$END\n");
}

TEST(TiedNets, ContradictionsAreNamed) {
  const std::string one = "$MPC TYPE=EQUATION RHS=0.01\n  1 B.2 X -1 B.3 X\n";
  EXPECT_EQ(run_mpcs(one).exit_code, 0);
  EXPECT_EQ(run_mpcs(one + one).exit_code, 0); // said twice
  for (const std::string& other : {one + "$MPC TYPE=EQUATION RHS=0.02\n  2 B.3 X -2 B.2 X\n",
                                   std::string("$MPC TYPE=EQUATION RHS=0.01\n  1 A.1 X -1 A.3 X\n"
                                               "$NSET NAME=FAR FROM=A.XMAX WHERE=(y < 1e-9)\n"
                                               "$FREEDOM CLASS=SUPPRESSED DOF=X\n  A.XMAX\n")}) {
    const test::Outcome outcome = run_mpcs(other);
    EXPECT_EQ(outcome.exit_code, 3) << outcome.messages;
    EXPECT_NE(outcome.messages.find("E416"), std::string::npos) << outcome.messages;
  }
}

// Both ends of a tie moved by hand: alike is a repetition, else a contradiction.
TEST(TiedNets, TiesBetweenPrescribedFreedoms) {
  const std::string model = two_blocks + held("A.XMIN") + tied("B.XMIN", "A.XMAX") +
                            "$FREEDOM CLASS=PRESCRIBED DOF=XY\n  A.XMAX B.XMIN\n";
  const auto run = [&](const std::string& lines) {
    const Folder folder;
    return run_text(folder, model + load("DISP", lines) + "$END\n");
  };
  const test::Outcome same = run("A.XMAX (0.1*y) 0.2\n  B.XMIN (0.1*y) 0.2");
  EXPECT_EQ(same.exit_code, 0) << same.messages;
  const test::Outcome other = run("A.XMAX (0.1*y) 0.2\n  B.XMIN (0.1*y) 0.21");
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_NE(other.messages.find("E416"), std::string::npos) << other.messages;
}

TEST(TiedNets, SlaveOffTheMasterIsNamed) {
  const Folder folder;
  const test::Outcome outcome =
      run_text(folder, head + net("A", "TYPE=QUAMC8 LX=2 LY=2 NX=1 NY=1") +
                           net("B", "TYPE=QUAMC8 X0=2.5 LX=2 LY=2 NX=2 NY=2") + property("A.BODY") +
                           property("B.BODY") + held("A.XMIN") + tied("B.XMIN", "A.XMAX") +
                           load("FORCE", "B.XMAX 1 0") + "$END\n");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.messages.find("E415"), std::string::npos) << outcome.messages;
  EXPECT_NE(outcome.messages.find("0.5 away"), std::string::npos) << outcome.messages;
}

} // namespace
} // namespace spricka::test_tied_nets
