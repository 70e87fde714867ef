// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/exit_codes.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/run_text.hpp"

namespace spricka::test_exit_codes {
namespace {

using test::Folder;
using test::Outcome;
using test::run_text;

// Two plates, one above the other, with a gap of nothing; what the tests change stands in braces.
std::string plates(const std::string& supports, const std::string& contact,
                   const std::string& more = "") {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LOW
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX=4 NY=2
$ENDNET
$NET NAME=TOP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 Y0=5 NX=3 NY=2
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LOW.YMIN
)" + supports +
         contact + R"(
$LOAD CASE=PUSH TYPE=PRESSURE
  TOP.YMAX 10
$STEP NAME=PRESS
  LOAD PUSH 1
)" + more +
         "$END\n";
}

const std::string side_support = "$FREEDOM CLASS=SUPPRESSED DOF=X\n  TOP.XMIN\n";
const std::string face = "$CONTACT NAME=FACE SLAVE=TOP.YMIN MASTER=LOW.YMAX\n";

bool has_results(const Folder& folder) {
  return std::filesystem::exists(folder.path() / "out" / "k.csv");
}

TEST(ExitCode, DoneIsZeroAndLeavesAllFiles) {
  const Folder folder;
  const Outcome outcome = run_text(folder, plates(side_support, face));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  for (const char* file : {"listing.txt", "k.csv", "pressure.csv", "report.html", "results.pvd"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / file)) << file;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out.part"));
}

TEST(ExitCode, FailedCheckIsOne) {
  const Folder folder;
  const Outcome outcome =
      run_text(folder, plates(side_support, face,
                              "$CHECK\n  CPRESS.MEAN(FACE,PRESS) = 11 REL 1e-6 SOURCE 'wrong'\n"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.messages.find("CPRESS.MEAN(FACE,PRESS)"), std::string::npos);
}

TEST(ExitCode, SurfacesThatNeverFaceEachOther) {
  const Folder folder;
  const Outcome outcome =
      run_text(folder, plates(side_support, "$CONTACT NAME=FACE SLAVE=TOP.YMAX MASTER=LOW.YMIN\n"));
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.messages.find("never face each other"), std::string::npos);
  EXPECT_NE(outcome.messages.find("test.deck:15:"), std::string::npos) << outcome.messages;
  EXPECT_FALSE(has_results(folder));
}

TEST(ExitCode, LoadedBodyThatSlidesAwayIsNamed) {
  const Folder folder;
  const Outcome outcome = run_text(folder, plates("", face,
                                                  "$LOAD CASE=SIDE TYPE=RESULTANT\n  TOP.BODY 5 0\n"
                                                  "$STEP NAME=SHOVE\n  LOAD SIDE 1\n"));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.messages.find("body TOP"), std::string::npos) << outcome.messages;
  EXPECT_NE(outcome.messages.find("direction X"), std::string::npos) << outcome.messages;
  EXPECT_FALSE(has_results(folder));
}

TEST(ExitCode, BodyPulledOffItsOnlyContactIsNamed) {
  const Folder folder;
  const Outcome outcome =
      run_text(folder, plates(side_support, face, "$STEP NAME=LIFT\n  LOAD PUSH -1\n"));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.messages.find("body TOP"), std::string::npos) << outcome.messages;
  EXPECT_NE(outcome.messages.find("step LIFT"), std::string::npos) << outcome.messages;
}

TEST(ExitCode, UnloadedFreeModeRests) {
  const Folder folder;
  const Outcome outcome = run_text(folder, plates("", face));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_NE(test::slurp(folder.path() / "out" / "listing.txt").find("at rest"), std::string::npos);
}

TEST(ExitCode, CrackThatTouchesNoElement) {
  const Folder folder;
  const Outcome outcome =
      run_text(folder, plates(side_support, face, "$CRACK NAME=C NET=LOW A0=1 ANGLE=0\n  50 50\n"));
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.messages.find("test.deck:"), std::string::npos) << outcome.messages;
  EXPECT_FALSE(has_results(folder));
}

// Faces that may overlap and do: K1 < 0, an answer, but not without a word. Else they close.
TEST(ExitCode, OverlappingCrackFacesAreWarnedOf) {
  const auto pressed = [](const Folder& folder, const std::string& keys) {
    return run_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=PLATE
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=20 NX=10 NY=20
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=PLATE.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  PLATE.YMIN
$CRACK NAME=C NET=PLATE A0=3 ANGLE=0 )" +
                                keys + R"(
  0 10
$LOAD CASE=PUSH TYPE=PRESSURE
  PLATE.YMAX 10
$STEP NAME=PRESS
  LOAD PUSH 1
$CHECK
  K1(C,PRESS) = 0 ABS 1e-12
  CPRESS.MIN(C.FACES,PRESS) = 10 REL 0.01
$END
)");
  };
  const Folder folder;
  const Outcome free = pressed(folder, "FACES=FREE");
  EXPECT_EQ(free.exit_code, 1) << free.messages; // neither check has a value
  EXPECT_NE(free.messages.find("overlap"), std::string::npos) << free.messages;
  EXPECT_NE(test::slurp(folder.path() / "out" / "listing.txt").find("overlap"), std::string::npos);
  const Folder other;
  const Outcome closed = pressed(other, "");
  EXPECT_EQ(closed.exit_code, 0) << closed.messages;
  EXPECT_EQ(closed.messages.find("overlap"), std::string::npos) << closed.messages;
  const std::string listing = test::slurp(other.path() / "out" / "listing.txt");
  EXPECT_NE(listing.find("C: the crack faces touch at the tip: K1 = 0"), std::string::npos);
  EXPECT_NE(listing.find("C.FACES"), std::string::npos);
}

TEST(ExitCode, NearlyIncompressibleTrianglesAreWarnedOf) {
  const Folder folder;
  std::string deck = plates(side_support, face);
  deck.replace(deck.find("NU=0.3"), 6, "NU=0.4999");
  deck.replace(deck.find("STATE=STRESS"), 12, "STATE=STRAIN");
  const Outcome projected = run_text(folder, deck);
  EXPECT_EQ(projected.messages.find("incompressible"), std::string::npos) << projected.messages;
  deck.replace(deck.find("QUAMC8"), 6, "TRIM3 ");
  const Outcome outcome = run_text(folder, deck);
  EXPECT_NE(outcome.messages.find("incompressible"), std::string::npos) << outcome.messages;
}

// Each of the coarse edge's functions is covered to less than 20 %: what is covered must hold.
TEST(ExitCode, NarrowBlockOnACoarseEdgeIsHeld) {
  const Folder folder;
  const Outcome outcome = run_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LOW
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX=1 NY=1
$ENDNET
$NET NAME=TOP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=0.3 LY=0.5 X0=4.8 Y0=5 NX=1 NY=2
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LOW.YMIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  TOP.XMIN
$CONTACT NAME=FACE SLAVE=TOP.YMIN MASTER=LOW.YMAX
$LOAD CASE=PUSH TYPE=PRESSURE
  TOP.YMAX 10
$STEP NAME=PRESS
  LOAD PUSH 1
$CHECK
  SUM(FACE,PRESS,Y) = 3 REL 1e-9
$END
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
}

TEST(ExitCode, BearingLoadThatMissesTheBoreIsRefused) {
  const Folder folder;
  const Outcome outcome =
      run_text(folder, plates(side_support, face,
                              "$LOAD CASE=PIN TYPE=BEARING\n  TOP.XMAX 5 0\n$STEP NAME=MORE\n"
                              "  LOAD PIN 1\n"));
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.messages.find("bearing"), std::string::npos) << outcome.messages;
}

TEST(ExitCode, CardOfALaterVersionIsRefused) {
  const Folder folder;
  const Outcome outcome = run_text(
      folder, plates(side_support, face, "$OUTPUT FILE='later.json' FORMAT=JSON\n  U TOP.YMAX\n"));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.messages.find("not available in this version"), std::string::npos);
}

TEST(ExitCode, MissingDeckIsFileTrouble) {
  program::RunOptions options;
  options.deck = "no_such.deck";
  options.out = "no_such_out";
  testing::internal::CaptureStderr();
  EXPECT_EQ(program::run_deck(options), base::ProgramOutcome::file_trouble);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("no_such.deck"), std::string::npos);
}

TEST(ExitCode, FolderOfSomethingElseIsNotTouched) {
  const Folder folder;
  std::filesystem::create_directories(folder.path() / "out");
  std::ofstream(folder.path() / "out" / "thesis.txt") << "years of work";
  EXPECT_EQ(run_text(folder, plates(side_support, face)).exit_code, 7);
  EXPECT_EQ(test::slurp(folder.path() / "out" / "thesis.txt"), "years of work");
}

TEST(ExitCode, OldResultsOutliveAFailedRun) {
  const Folder folder;
  ASSERT_EQ(run_text(folder, plates(side_support, face)).exit_code, 0);
  ASSERT_TRUE(has_results(folder));
  EXPECT_EQ(run_text(folder, plates("", face,
                                    "$LOAD CASE=SIDE TYPE=RESULTANT\n  TOP.BODY 5 0\n"
                                    "$STEP NAME=SHOVE\n  LOAD SIDE 1\n"))
                .exit_code,
            4);
  EXPECT_TRUE(has_results(folder));
}

// What scripts rely on is said in one place of the sources and in one of the manual.
TEST(ExitCode, OfEachOutcomeIsThatOfTheManual) {
  const std::string page = test::slurp(test::source_folder() + "/manual/exit_codes.md");
  for (std::size_t i = 0; i < base::exit_code_table.size(); ++i) {
    const auto outcome = static_cast<base::ProgramOutcome>(i);
    const int code = base::exit_code(outcome);
    EXPECT_EQ(base::exit_code_table.at(i).outcome, outcome) << i;
    EXPECT_EQ(base::outcome_of_exit_code(code), outcome) << code;
    EXPECT_NE(page.find("\n| " + std::to_string(code) + " | "), std::string::npos) << code;
    if (i > 0) { // the worst outcome of a sweep's points has the largest code
      EXPECT_GT(code, base::exit_code_table.at(i - 1).code);
    }
  }
  EXPECT_EQ(base::exit_code_table.back().outcome, base::ProgramOutcome::defect);
  EXPECT_EQ(base::outcome_of_exit_code(8), std::nullopt);
}

} // namespace
} // namespace spricka::test_exit_codes
