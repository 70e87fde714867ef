// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/deck_parts.hpp"
#include "tests/unit/support/run_text.hpp"

// What only the mesh of a crack length shows: forces that nothing takes, ties that do not pass
// constant stress.
namespace spricka::test_scene {
namespace {

using test::Folder;
using test::head;
using test::held;
using test::load;
using test::net;
using test::Outcome;
using test::property;
using test::run_text;
using test::tied;

bool has(const Outcome& outcome, const std::string& text) {
  return outcome.messages.find(text) != std::string::npos;
}

// A cantilever and a node beside it, which carries the load.
std::string beam(const std::string& tie) {
  return head + net("A", "TYPE=QUAMC8 LX=10 LY=2 NX=5 NY=2") + R"($COOR NSET=GRIP DIM=2
  1001 13 1
$PROPERTY ESET=A.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  A.XMIN
)" + tie +
         R"($LOAD CASE=F TYPE=FORCE
  GRIP 0 -3
$STEP NAME=S
  LOAD F 1
$CHECK
  REACTION(A.XMIN,S,Y) = 3 REL 1e-9 SOURCE 'equilibrium'
$END
)";
}

TEST(Discretisation, AForceOnALooseNodeIsRefused) {
  const Folder folder;
  const Outcome loose = run_text(folder, beam(""));
  EXPECT_EQ(loose.exit_code, 3) << loose.messages;
  EXPECT_TRUE(has(loose, "E418: load case F: no element has node 1001, which it loads"))
      << loose.messages;
  EXPECT_TRUE(has(loose, "tie the node by $MPC")) << loose.messages;
}

TEST(Discretisation, AForceOnATiedNodeArrives) {
  const Folder folder;
  const Outcome tied = run_text(folder, beam("$NSET NAME=PLATE\n  A.XMAX GRIP\n"
                                             "$MPC TYPE=RIGID SLAVE=PLATE\n"));
  EXPECT_EQ(tied.exit_code, 0) << tied.messages;
}

// A plate with an edge crack to (a, 10); elements of 1, `more` is a load or a support.
std::string cracked_plate(const std::string& a, const std::string& more) {
  return head + R"($MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=20 NX=10 NY=20
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  YMIN
$NSET NAME=AHEAD WHERE=(abs(x - 4) < 1e-6 and abs(y - 10) < 1e-6)
$NSET NAME=RIM WHERE=(abs(x) < 1e-6 and y > 1)
)" + more +
         R"($CRACK NAME=C A0=)" + a + R"( ANGLE=0
  0 10
$STEP NAME=S
  LOAD F 1
$CHECK
  REACTION(YMIN,S,Y) = -1 REL 1e-9 SOURCE 'equilibrium'
$END
)";
}

TEST(Discretisation, AForceOnANodeThatAPatchReplacedIsRefused) {
  const Folder folder;
  const std::string force = "$LOAD CASE=F TYPE=FORCE\n  AHEAD 0 1\n";
  const Outcome taken = run_text(folder, cracked_plate("3.8", force));
  EXPECT_EQ(taken.exit_code, 3) << taken.messages;
  EXPECT_TRUE(has(taken, "E418: load case F: a crack has cut out node")) << taken.messages;
  const Outcome far = run_text(folder, cracked_plate("0.5", force));
  EXPECT_EQ(far.exit_code, 0) << far.messages;
}

// The patch has more nodes on the rim than the plate had: a force on each would be another load.
TEST(Discretisation, AForceOnNodesThatAPatchRefinesIsRefused) {
  const Folder folder;
  const std::string force = "$LOAD CASE=F TYPE=FORCE\n  RIM 0 1\n";
  const Outcome rim = run_text(folder, cracked_plate("0.5", force));
  EXPECT_EQ(rim.exit_code, 3) << rim.messages;
  EXPECT_TRUE(has(rim, "E418")) << rim.messages;
  const Outcome zero =
      run_text(folder, cracked_plate("0.5", "$LOAD CASE=F TYPE=FORCE\n  RIM 0 0\n  AHEAD 0 1\n"));
  EXPECT_EQ(zero.exit_code, 0) << zero.messages;
}

TEST(Discretisation, ASupportOnANodeThatAPatchReplacedIsRefused) {
  const Folder folder;
  const std::string load = "$LOAD CASE=F TYPE=RESULTANT\n  YMAX 0 1\n";
  const std::string held = "$FREEDOM CLASS=SUPPRESSED DOF=X\n  AHEAD\n" + load;
  const Outcome lost = run_text(folder, cracked_plate("3.8", held));
  EXPECT_EQ(lost.exit_code, 3) << lost.messages;
  EXPECT_TRUE(has(lost, "E419: a crack has cut out node")) << lost.messages;
  const Outcome kept = run_text(folder, cracked_plate("0.5", held));
  EXPECT_EQ(kept.exit_code, 0) << kept.messages;
  // the nodes of whole sides come back with the patch
  const Outcome rim =
      run_text(folder, cracked_plate("0.5", "$FREEDOM CLASS=SUPPRESSED DOF=X\n  RIM\n" + load));
  EXPECT_EQ(rim.exit_code, 0) << rim.messages;
}

// Two blocks on top of each other under pressure; the upper has n elements on the lower's 4.
Outcome stacked(const std::string& n, bool solid) {
  const std::string type =
      solid ? "TYPE=HEXEC20 LX=4 LY=1 LZ=1 NY=1 NZ=1 NX=" : "TYPE=QUAMC8 LX=4 LY=1 NY=1 NX=";
  const std::string up = solid ? "Z" : "Y";
  const std::string state = solid ? "SOLID" : "STRESS";
  const Folder folder;
  return run_text(folder, head + net("LOW", type + "4") + net("TOP", type + n + " " + up + "0=1") +
                              property("LOW.BODY", state) + property("TOP.BODY", state) +
                              held("LOW." + up + "MIN", solid ? "XYZ" : "XY") +
                              tied("TOP." + up + "MIN", "LOW." + up + "MAX") +
                              load("PRESSURE", "TOP." + up + "MAX 5") + "$END\n");
}

TEST(Discretisation, TransitionsBetweenMeshesThatDoNotNestAreTold) {
  for (const bool solid : {false, true}) {
    for (const std::string n : {"4", "8", "12"}) {
      const Outcome nested = stacked(n, solid);
      EXPECT_EQ(nested.exit_code, 0) << nested.messages;
      EXPECT_FALSE(has(nested, "W503")) << n << nested.messages;
    }
    const Outcome straddling = stacked("6", solid);
    EXPECT_EQ(straddling.exit_code, 0) << straddling.messages;
    // the second and the fifth of six span a joint of the four; the middle joints agree
    EXPECT_TRUE(
        has(straddling, "W503: $MPC: 2 slave side(s) span several master faces (element 2)"))
        << straddling.messages;
    EXPECT_TRUE(has(straddling, "$CONTACT TYPE=BONDED")) << straddling.messages;
  }
}

} // namespace
} // namespace spricka::test_scene
