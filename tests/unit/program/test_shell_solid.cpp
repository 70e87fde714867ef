// SPDX-License-Identifier: GPL-3.0-or-later
// The shell on a crack in space: its answers are those of runs.
#include "program/shell/command_table.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/shell_text.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_shell_solid {
namespace {

using test::ShellOnText;
using test::Solved;

constexpr auto good = ShellOnText::good;

// An ellipse in a block under tension, sheared in a second step.
std::string buried(const std::string& crack) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  r = 1
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE=TET10 X0=-8 Y0=-8 Z0=-8 LX=16 LY=16 LZ=16 NX=3 NY=3 NZ=3
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID
$NSET NAME=P1 WHERE=(x < -7.99 and y < -7.99 and z < -7.99)
$NSET NAME=P2 WHERE=(x > 7.99 and y < -7.99 and z < -7.99)
$NSET NAME=P3 WHERE=(x < -7.99 and y > 7.99 and z < -7.99)
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  P1
$FREEDOM CLASS=SUPPRESSED DOF=YZ
  P2
$FREEDOM CLASS=SUPPRESSED DOF=Z
  P3
$CRACK NAME=C NET=B {}
$LOAD CASE=PULL TYPE=TRACTION
  B.ZMAX 0 0 1
  B.ZMIN 0 0 -1
$LOAD CASE=SHEAR TYPE=TRACTION
  B.ZMAX  1 0 0
  B.ZMIN  -1 0 0
  B.XMAX  0 0 1
  B.XMIN  0 0 -1
$STEP NAME=PULLED
  LOAD PULL 1
$STEP NAME=SHEARED
  LOAD SHEAR 1
$END
)",
                     crack);
}

results::FrontResult front_of_run(const std::string& deck, std::size_t step) {
  const std::optional<Solved> run = test::solve_text(deck);
  EXPECT_TRUE(run);
  return run ? run->step(step).fronts.at(0) : results::FrontResult();
}

void expect_same(const results::FrontResult& found, const results::FrontResult& wanted) {
  ASSERT_EQ(found.points.size(), wanted.points.size());
  double scale = 0.0;
  for (const results::FrontPointResult& place : wanted.points) {
    scale = std::max(scale, std::abs(place.K1));
  }
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    EXPECT_NEAR(found.points[i].K1, wanted.points[i].K1, 1e-10 * scale) << i;
    EXPECT_NEAR(found.points[i].K2, wanted.points[i].K2, 1e-10 * scale) << i;
    EXPECT_NEAR(found.points[i].K3, wanted.points[i].K3, 1e-10 * scale) << i;
    EXPECT_NEAR(found.points[i].bar[0].size(), wanted.points[i].bar[0].size(), 1e-8 * scale) << i;
  }
}

TEST(ShellSolid, LoadsAndSizesAreThoseOfARun) {
  const ShellOnText shell(buried("A=1 C=1.25 X0=0 Y0=0 Z0=0 NORMAL=Z"));
  const results::FrontResult first = shell->current_result().fronts.at(0);
  good(shell->add_step_line("LOAD PULL 2.0"));
  good(shell->add_step_line("LOAD SHEAR 2.0"));
  good(shell->solve());
  for (std::size_t i = 0; i < first.points.size(); ++i) {
    EXPECT_NEAR(shell->current_result().fronts.at(0).points[i].K1, 2.0 * first.points[i].K1,
                1e-10 * std::abs(first.points[i].K1));
  }
  good(shell->go_to_step("SHEARED"));
  good(shell->change_card("$CRACK NAME=C A=1.2 C=1.5"));
  EXPECT_EQ(shell.crack_size(), (program::CrackSize{1.2, 1.5}));
  good(shell->estimate_accuracy());
  expect_same(shell->current_result().fronts.at(0),
              front_of_run(buried("A=1.2 C=1.5 X0=0 Y0=0 Z0=0 NORMAL=Z"), 1));
  good(shell->change_card("$CRACK NAME=C C=1.25"));
  EXPECT_EQ(shell.crack_size(), (program::CrackSize{1.2, 1.25}));
  EXPECT_EQ(shell->fronts_by_size().size(), 3U);
  // A size that fits nowhere leaves all as it is.
  EXPECT_TRUE(shell->change_card("$CRACK NAME=C A=80 C=100"));
  EXPECT_EQ(shell.crack_size(), (program::CrackSize{1.2, 1.25}));
  EXPECT_NEAR(shell->current_result().fronts.at(0).a, 1.2, 1e-12);
}

// What `save_state` writes is the state: a run of it has the same K.
TEST(ShellSolid, SavedDeckHasTheSameK) {
  if (!test::full_size()) {
    GTEST_SKIP() << "at full size; decks that the shell saves: terminal.shell_session, "
                    "program.shell_session";
  }
  const ShellOnText shell(buried("A=1 C=(r) X0=0 Y0=0 Z0=0 NORMAL=Z"));
  const auto type = [&](const std::string& line) {
    const program::ShellReply reply = program::run_shell_line(*shell, {}, line);
    EXPECT_EQ(reply.outcome, base::ProgramOutcome::done) << line << ": " << reply.messages;
    return reply.out;
  };
  type("$CRACK NAME=C A=1.1 C=1.4");
  type("LOAD SHEAR 0.5");
  const std::string points = type("list K C");
  EXPECT_NE(points.find("+- K3"), std::string::npos) << points;
  EXPECT_NE(type("list sensitivity").find("LOAD PULL"), std::string::npos);
  EXPECT_NE(type("map SHEAR 0 1").find("dK1/dfactor C point"), std::string::npos);
  const std::filesystem::path file = shell.folder.path() / "saved.deck";
  type("save '" + file.string() + "'");
  for (const char* kind : {"k", "mesh", "path"}) {
    type(fmt::format("plot {} '{}'", kind, (shell.folder.path() / kind).string() + ".svg"));
  }
  std::ifstream in(file);
  const std::string saved((std::istreambuf_iterator<char>(in)), {});
  EXPECT_NE(saved.find("A=1.1 C=1.4"), std::string::npos) << saved;
  expect_same(shell->current_result().fronts.at(0), front_of_run(saved, 2));
  // A parameter of the deck does not reach an axis that was given another value.
  type("r = 2");
  EXPECT_EQ(shell.crack_size(), (program::CrackSize{1.1, 1.4}));
}

// Its points say how large it is.
TEST(ShellSolid, DrawnFrontsHaveNoLength) {
  std::string points;
  for (int i = 0; i < 12; ++i) {
    const double at = i * 0.5235987755982988;
    points += fmt::format("  {} {} 0\n", std::cos(at), std::sin(at));
  }
  const ShellOnText shell(buried("CLOSED=YES\n" + points));
  testing::internal::CaptureStderr();
  EXPECT_TRUE(shell->change_card("$CRACK NAME=C A=1.5"));
  EXPECT_NE(testing::internal::GetCapturedStderr(), "");
}

} // namespace
} // namespace spricka::test_shell_solid
