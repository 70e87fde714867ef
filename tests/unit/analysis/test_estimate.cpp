// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/places.hpp"
#include "tests/unit/support/deck_parts.hpp"
#include "tests/unit/support/run_text.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>

// The estimated error of plain stress analyses: beams whose stiffness is known, and what is said.
#include <fmt/format.h>

namespace spricka::test_estimate {
namespace {

using test::Folder;
using test::head;
using test::net;
using test::Outcome;
using test::property;
using test::run_text;
using test::solve_text;

// The straight cantilever of MacNeal and Harder (1985), l = 6, h = 0.2; its tip moves by 0.1081.
std::string cantilever(const std::string& mesh, const std::string& set, const std::string& more) {
  return "$DECK VERSION=1 LENGTH=in FORCE=lbf\n" + mesh + R"($MATERIAL NAME=M E=1e7 NU=0.3
$PROPERTY ESET=)" +
         set + R"( MATERIAL=M STATE=STRESS THICK=0.1
$NSET NAME=ROOT WHERE=(x < 1e-9)
$NSET NAME=TIP WHERE=(x > 6 - 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  ROOT
$LOAD CASE=PULL TYPE=RESULTANT
  TIP 0 1
$STEP NAME=BENDING
  LOAD PULL 1
)" + more +
         "$END\n";
}

std::string block(const std::string& type_and_counts) {
  return "$MESH SHAPE=BLOCK LX=6 LY=0.2 Y0=-0.1 " + type_and_counts + "\n";
}
// Sides at 45 degrees in turn; 6 elements.
std::string trapezia(bool serendipity) {
  return fmt::format("$PARAMETER\n  form = 2\n  n = 6\n  serendipity = {}\n"
                     "$IMPORT FILE='{}/cantilever.geo' FORMAT=GEO\n",
                     serendipity ? 1 : 0, test::decks_folder());
}

bool warned(const Outcome& outcome) {
  return outcome.messages.find("W504: net (deck): the mesh is coarse for step BENDING") !=
         std::string::npos;
}

TEST(Estimate, MeshesThatAreStiffInBendingAreTold) {
  for (const std::string& mesh :
       {block("TYPE=TRIM3 NX=60 NY=2"), block("TYPE=QUAM4 NX=6 NY=1"),
        block("TYPE=QUAM4 NX=60 NY=2"), trapezia(true), trapezia(false)}) {
    const Folder folder;
    const Outcome outcome = run_text(folder, cantilever(mesh, "BODY", ""));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
    EXPECT_TRUE(warned(outcome)) << mesh << outcome.messages;
  }
  for (const std::string& mesh : {block("TYPE=QUAM4 NX=240 NY=8"), block("TYPE=QUAMC8 NX=12 NY=1"),
                                  block("TYPE=TRIMC6 NX=30 NY=1")}) {
    const Folder folder;
    const Outcome outcome = run_text(folder, cantilever(mesh, "BODY", ""));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
    EXPECT_FALSE(warned(outcome)) << mesh << outcome.messages;
  }
}

// One load: the energy that is missing is the displacement that is missing.
TEST(Estimate, ItsSquareIsTheLostDisplacement) {
  for (const std::string& mesh :
       {trapezia(true), block("TYPE=QUAM4 NX=60 NY=2"), block("TYPE=QUAM4 NX=120 NY=4"),
        block("TYPE=HEXE8 NX=60 NY=2")}) {
    const bool solid = mesh.find("HEXE8") != std::string::npos;
    std::string deck = cantilever(mesh, "BODY", "");
    if (solid) {
      deck.replace(deck.find("STATE=STRESS THICK=0.1"), 22, "STATE=SOLID");
      deck.replace(deck.find("NX=60"), 5, "LZ=0.1 NZ=1 NX=60");
      deck.replace(deck.find("DOF=XY"), 6, "DOF=XYZ");
      deck.replace(deck.find("TIP 0 1"), 7, "TIP 0 1 0");
    }
    const auto solved = solve_text(deck);
    ASSERT_TRUE(solved);
    const double u = 2.0 * solved->step().energy; // of a force of 1
    const double lost = (0.1081 - u) / 0.1081;
    ASSERT_EQ(solved->step().errors.size(), 2U);
    const double part = solved->step().errors.back().part;
    EXPECT_NEAR(part, std::sqrt(lost), 0.15 * std::sqrt(lost)) << mesh;
    EXPECT_EQ(part, solved->step().errors.front().part); // all is one net
  }
}

// Stresses under a force on a single node have no bound, on any mesh: no reason to call it coarse.
TEST(Estimate, AForceOnANodeIsNoCoarseMesh) {
  const std::string deck = head + "$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=10 NX=12 NY=12\n" +
                           property("BODY") +
                           "$NSET NAME=P WHERE=(abs(x-5) < 1e-9 and abs(y-10) < 1e-9)\n"
                           "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  YMIN\n"
                           "$LOAD CASE=F TYPE=FORCE\n  P 0 -1\n$STEP NAME=S\n  LOAD F 1\n$END\n";
  const Folder folder;
  const Outcome outcome = run_text(folder, deck);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_EQ(outcome.messages.find("W504"), std::string::npos) << outcome.messages;
}

TEST(Estimate, IsCheckedByNetAndNamedInTheListing) {
  const Folder folder;
  const std::string deck =
      head + net("A", "TYPE=QUAM4 LX=10 LY=1 NX=10 NY=1") +
      net("B", "TYPE=QUAMC8 Y0=5 LX=10 LY=1 NX=10 NY=1") + property("A.BODY") + property("B.BODY") +
      "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  A.XMIN B.XMIN\n$LOAD CASE=F TYPE=TRACTION\n"
      "  A.XMAX 0 1\n  B.XMAX 0 1\n$STEP NAME=S\n  LOAD F 1\n$STEP NAME=REST\n  LOAD F 0\n"
      "$CHECK\n  ERROR(A,S) = 0.6 ABS 0.2 SOURCE 'coarse'\n"
      "  ERROR(B,S) = 0.04 ABS 0.03 SOURCE 'fine'\n"
      "  ERROR(*,REST) = 0 ABS 0 SOURCE 'nothing is loaded'\n$END\n";
  const Outcome outcome = run_text(folder, deck);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_NE(outcome.messages.find("W504: net A"), std::string::npos) << outcome.messages;
  EXPECT_EQ(outcome.messages.find("W504: net B"), std::string::npos) << outcome.messages;
  const std::string listing = test::slurp(folder.path() / "out" / "listing.txt");
  EXPECT_NE(listing.find("Estimated energy error\n"), std::string::npos);
}

// Free expansion has stresses of round-off, a part of which is round-off too: no error is made of
// it.
TEST(Estimate, RoundOffIsNoError) {
  const auto hot = solve_text(
      "$DECK VERSION=1 LENGTH=mm FORCE=N\n$MATERIAL NAME=M E=1000 NU=0.25 ALPHA=1e-5\n" +
      net("A", "TYPE=QUAMC8 LX=3 LY=1 NX=3 NY=1") + property("A.BODY") +
      "$FREEDOM CLASS=SUPPRESSED DOF=X\n  A.XMIN\n$FREEDOM CLASS=SUPPRESSED DOF=Y\n  A.YMIN\n"
      "$LOAD CASE=F TYPE=TEMPERATURE\n  A.BODY 100\n$STEP NAME=S\n  LOAD F 1\n$END\n");
  ASSERT_TRUE(hot);
  ASSERT_EQ(hot->step().errors.size(), 2U);
  for (const results::NetErrorEstimate& error : hot->step().errors) {
    EXPECT_LT(error.part, 1e-6);
  }
}

} // namespace
} // namespace spricka::test_estimate
