// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace spricka::test_mounted {
namespace {

// A plate under tension, cracked from below; when the load is on, a strap is bonded to its upper
// side.
std::string strapped(const std::string& mounted, const std::string& angle = "90[deg]",
                     const std::string& y = "0") {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=PLATE
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=4 NX=20 NY=8
$ENDNET
$NET NAME=STRAP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=3 Y0=4 LX=4 LY=1 NX=7 NY=2
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=PLATE.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=STRAP.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  PLATE.XMIN
$CONTACT NAME=GLUE SLAVE=STRAP.YMIN MASTER=PLATE.YMAX TYPE=BONDED GAP=0
$CRACK NAME=C NET=PLATE A0=1 ANGLE={}
  5  {}
$LOAD CASE=PULL TYPE=TRACTION
  PLATE.XMAX 1 0
$STEP NAME=LOAD
  LOAD PULL 1
$STEP NAME=FIX
  MOUNT GLUE
$GROW LAW=INCREMENT KMAX=FIX MOUNTED={}
  1 1.01 1.02
$END
)",
                     angle, y, mounted);
}

double strap_energy(const test::Solved& solved, std::size_t increment) {
  for (const results::ForceBalance& net : solved.run.increments[increment].steps[1].nets) {
    if (net.body == "STRAP") {
      return net.energy;
    }
  }
  throw std::runtime_error("no strap");
}

TEST(ContactMountingPolicy, EachLengthMountsWithoutStress) {
  const std::optional<test::Solved> solved = test::solve_text(strapped("EACH"));
  ASSERT_TRUE(solved);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(strap_energy(*solved, i), 1e-18);
  }
}

// What was bonded at the first length feels the crack grow: its stress is in proportion to the
// growth, its energy to the square.
TEST(ContactMountingPolicy, FirstLengthsStrapFeelsTheCrackGrow) {
  const std::optional<test::Solved> solved = test::solve_text(strapped("FIRST"));
  ASSERT_TRUE(solved);
  EXPECT_LT(strap_energy(*solved, 0), 1e-18);
  EXPECT_GT(strap_energy(*solved, 1), 1e-12);
  EXPECT_NEAR(strap_energy(*solved, 2) / strap_energy(*solved, 1), 4.0, 0.3);
}

// Where the crack opens into the strap's own seat the seat is meshed anew with each length.
TEST(ContactMountingPolicy, FirstNeedsTheSameRowsAtAllLengths) {
  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "test.deck";
  std::ofstream(file) << strapped("FIRST", "-90[deg]", "4");
  program::CheckedDeck ready =
      program::read_and_check_deck(file, {}, program::Log(program::LogFormat::text));
  ASSERT_TRUE(ready.model);
  base::Diagnostics diagnostics;
  base::OptionalFailure trouble;
  EXPECT_FALSE(analysis::solve_run(*ready.model, {}, diagnostics, trouble));
  ASSERT_TRUE(trouble);
  EXPECT_EQ(trouble->kind, base::ProgramOutcome::not_solvable);
  EXPECT_NE(trouble->why.find("GLUE"), std::string::npos) << trouble->why;
}

} // namespace
} // namespace spricka::test_mounted
