// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of nodes and sets that the patch of a crack has replaced. Linear fields, which the
// elements hold exactly, tell the truth at every place.
#include "tests/unit/support/run_text.hpp"

#include <fmt/format.h>

namespace spricka::test_gone_nodes {
namespace {

// A strip pulled along x has u = s x / E and v = -nu s y / E, with a crack along x, which it does
// not feel, from the middle of its left side.
std::string pulled(const std::string& more, const std::string& crack = "PATCH=YES") {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=4 LY=2 Y0=-1 NX=16 NY=8
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=X
  XMIN
$NSET NAME=LOW WHERE=(abs(x - 4) < 1e-9 and y < -0.999)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  LOW
$LOAD CASE=T TYPE=TRACTION
  XMAX 10 0
$CRACK NAME=C A0=0.6 ANGLE=0
  0 0
$TIPNET CRACK=C {}
$STEP NAME=S
  LOAD T 1
{}$END
)",
                     crack, more);
}

TEST(GoneNodes, DisplacementsEverywhereInTheBody) {
  const test::Folder folder;
  const test::Outcome outcome =
      test::run_text(folder, pulled(R"($NSET NAME=INNER WHERE=(abs(y - 0.25) < 1e-9 and x < 1.6)
$NSET NAME=PLACE WHERE=(abs(x - 0.5) < 1e-9 and abs(y - 0.25) < 1e-9)
$CHECK
  U.X.AT(0.5,0.25,S)     = 0.005    REL 1e-9 SOURCE 'uniform stress; a node of the net that is gone'
  U.X.AT(0.5123,0.2,S)   = 0.005123 REL 1e-9 SOURCE 'uniform stress; no node'
  U.X.AT(3.111,-0.77,S)  = 0.03111  REL 1e-9 SOURCE 'uniform stress; outside the patch'
  U.X.MAX(PLACE,S)       = 0.005    REL 1e-9 SOURCE 'uniform stress'
  U.X.MIN(PLACE,S)       = 0.005    REL 1e-9 SOURCE 'uniform stress'
  U.X.MIN(INNER,S)       = 0        ABS 1e-12 SOURCE 'uniform stress'
  U.X.MAX(INNER,S)       = 0.015    REL 1e-9 SOURCE 'uniform stress'
  U.Y.MAX(INNER,S)       = -0.00375 REL 1e-9 SOURCE 'v = -nu s (y + 1) / E'
  U.Y.MIN(INNER,S)       = -0.00375 REL 1e-9 SOURCE 'v = -nu s (y + 1) / E'
  S.XX.MAX(PLACE,S)      = 10       REL 1e-9 SOURCE 'uniform stress'
  S.XX.MIN(INNER,S)      = 10       REL 1e-9 SOURCE 'uniform stress'
  REACTION(XMIN,S,X)     = -20      REL 1e-9 SOURCE 'balance'
)"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
}

// Every node of a set that the net has is in the table, at its own place and with its value.
TEST(GoneNodes, TablesHaveAllNodesOfASet) {
  const test::Folder folder;
  const test::Outcome outcome =
      test::run_text(folder, pulled("$NSET NAME=INNER WHERE=(abs(y - 0.25) < 1e-9)\n"
                                    "$OUTPUT FILE='u.csv' FORMAT=CSV\n  U INNER\n  S INNER\n"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
  std::istringstream csv(test::slurp(folder.path() / "out" / "u.csv"));
  int rows = 0;
  for (std::string line; std::getline(csv, line);) {
    double x = 0.0;
    double y = 0.0;
    double value = 0.0;
    if (std::sscanf(line.c_str(), "1,S,U,INNER,%*[^,],%lf,%lf,X,%lf", &x, &y, &value) == 3) {
      ++rows;
      EXPECT_NEAR(y, 0.25, 1e-12);
      EXPECT_NEAR(value, 0.01 * x, 1e-12) << line;
    }
    if (std::sscanf(line.c_str(), "1,S,S,INNER,%*[^,],%lf,%lf,XX,%lf", &x, &y, &value) == 3) {
      EXPECT_NEAR(value, 10.0, 1e-9) << line;
    }
  }
  EXPECT_EQ(rows, 33); // 16 edges with their middles
}

// Pressed open, the faces part: nodes of the net on the crack have a value on each face, which is
// that of the mirror image; a point on it has none.
TEST(GoneNodes, NodesOnTheCrackHaveBothFaces) {
  const std::string deck = R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=4 LY=2 Y0=-1 NX=16 NY=8
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  XMAX
$NSET NAME=P WHERE=(abs(x - 0.25) < 1e-9 and abs(y) < 1e-9)
$CRACK NAME=C A0=0.6 ANGLE=0
  0 0
$LOAD CASE=T TYPE=PRESSURE
  C.LEFT 1
  C.RIGHT 1
$STEP NAME=S
  LOAD T 1
$CHECK
  U.Y.MAX(P,S) = {} REL {} SOURCE 'the node beside the crack'
  U.Y.AT(0.25,{},S) = 1 REL 1e-9 SOURCE 'refused, or far off'
$END
)";
  const auto said = [&](const std::string& value, const char* tolerance, const char* y) {
    const test::Folder folder;
    std::string text = deck;
    text.replace(text.find("{}"), 2, value);
    text.replace(text.find("{}"), 2, tolerance);
    text.replace(text.find("{}"), 2, y);
    test::run_text(folder, text);
    return test::slurp(folder.path() / "out" / "listing.txt");
  };
  const std::string on = said("1", "1", "0");
  EXPECT_NE(on.find("move apart"), std::string::npos) << on;
  const std::string beside = said("1", "1", "1e-5");
  const std::size_t at = beside.find("U.Y.AT(0.25,1e-05,S)");
  ASSERT_NE(at, std::string::npos) << beside;
  double u = 0.0;
  ASSERT_EQ(std::sscanf(beside.c_str() + at, "%*s %lf", &u), 1);
  EXPECT_GT(u, 1e-5);
  const std::string both = said(fmt::format("{}", u), "1e-3", "1e-5");
  const std::size_t row = both.rfind("U.Y.MAX(P,S)"); // of the table, behind the deck
  EXPECT_NE(both.substr(row, both.find('\n', row) - row).find("passed"), std::string::npos)
      << both.substr(row, 200);
}

// One node of a support's edge, beside a mouth: what it bore is spread over the patch's nodes.
TEST(GoneNodes, TheReactionOfOneReplacedNodeIsNotTold) {
  const test::Folder folder;
  std::string deck = pulled("$NSET NAME=ONE WHERE=(abs(x) < 1e-9 and abs(y - 0.125) < 1e-9)\n"
                            "$CHECK\n  REACTION(ONE,S,X) = 0 ABS 9 SOURCE 'none'\n");
  const std::string mouth = "\n  0 0\n";
  deck.replace(deck.find(mouth), mouth.size(), "\n  0 0.1\n");
  const test::Outcome outcome = test::run_text(folder, deck);
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_NE(test::slurp(folder.path() / "out" / "listing.txt").find("whole edge"),
            std::string::npos);
}

} // namespace
} // namespace spricka::test_gone_nodes
