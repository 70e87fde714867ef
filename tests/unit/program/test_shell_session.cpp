// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/result_value.hpp"
#include "shell_runs.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_shell_session {
namespace {

using test::cracked_hub;
using test::expect_k;
using test::good;
using test::held_hub;
using test::k_of_run;
using test::replaced;
using test::ShellOnText;
using test::solve_text;
using test::Solved;

TEST(ShellSession, OpensAtTheLeadingStep) {
  const ShellOnText shell(cracked_hub());
  EXPECT_EQ(shell->base_step_name(), "PULLED");
  expect_k(shell, k_of_run(cracked_hub()), 1e-13);
}

TEST(ShellSession, LoadIsThatOfARun) {
  const ShellOnText shell(cracked_hub());
  good(shell->add_step_line("LOAD PULL 3.5"));
  EXPECT_TRUE(shell->has_pending_changes());
  good(shell->solve());
  EXPECT_FALSE(shell->has_pending_changes());
  expect_k(shell, k_of_run(replaced(cracked_hub(), "LOAD PULL 1", "LOAD PULL 3.5")), 1e-10);
  good(shell->add_step_line("LOAD PULL 0.2")); // and back on another way
  good(shell->add_step_line("LOAD PULL 0.7"));
  good(shell->solve());
  expect_k(shell, k_of_run(replaced(cracked_hub(), "LOAD PULL 1", "LOAD PULL 0.7")), 1e-10);
}

TEST(ShellSession, IsHomogeneous) {
  const ShellOnText shell(cracked_hub());
  const double K1 = shell.K1();
  const double K2 = shell.K2();
  good(shell->add_step_line("LOAD PULL 2.0"));
  good(shell->add_step_line("FIT SEAT 2.0"));
  good(shell->solve());
  EXPECT_NEAR(shell.K1(), 2.0 * K1, 1e-10 * std::abs(K1));
  EXPECT_NEAR(shell.K2(), 2.0 * K2, 1e-10 * std::abs(K1));
}

TEST(ShellSession, LengthIsThatOfARun) {
  const ShellOnText shell(cracked_hub());
  const double first = shell.K1();
  good(shell->change_card("$CRACK NAME=C A0=6.0"));
  const base::Vec2 wanted = k_of_run(cracked_hub("A0=6"));
  expect_k(shell, wanted, 1e-10);
  EXPECT_GT(std::abs(shell.K1() - first), 0.01 * first);
  EXPECT_GT(shell->solver().condensation_figures().reused, 0); // the pin at least
  good(shell->change_card("$CRACK NAME=C A0=4.0"));
  EXPECT_NEAR(shell.K1(), first, 1e-10 * first);
}

TEST(ShellSession, WhatACrackDoesNotTouchStaysCondensed) {
  const auto hub = [](const char* crack) {
    return replaced(cracked_hub(crack), "NR=4 NT=36", "NR=10 NT=90");
  };
  const ShellOnText shell(hub("A0=4"));
  good(shell->change_card("$CRACK NAME=C A0=6.0")); // region and rest are parted here
  good(shell->change_card("$CRACK NAME=C A0=6.5"));
  EXPECT_EQ(shell->solver().condensation_figures().condensed, 1); // the region
  EXPECT_EQ(shell->solver().condensation_figures().reused, 2);    // the rest and the pin
  expect_k(shell, k_of_run(hub("A0=6.5")), 1e-9);
}

// With the lengths that a growth run has, region and rest are the same: so are the bits.
TEST(ShellSession, LengthOfAGrowthRunToTheBit) {
  const std::string deck =
      cracked_hub("A0=4", "INTERFERENCE=0.01", "$GROW LAW=INCREMENT KMAX=PULLED\n  4 6 9\n");
  const std::optional<Solved> run = solve_text(deck);
  ASSERT_TRUE(run);
  const ShellOnText shell(deck);
  for (const int i : {0, 2, 1, 0}) {
    const results::FrontResult& wanted =
        run->run.increments[static_cast<std::size_t>(i)].steps.back().fronts.front();
    good(shell->change_card(fmt::format("$CRACK NAME=C A0={}", wanted.a)));
    good(shell->go_to_step("PULLED"));
    EXPECT_EQ(shell.K1(), wanted.single_point().raw_K()[0]) << wanted.a;
    EXPECT_EQ(shell.K2(), wanted.single_point().raw_K()[1]) << wanted.a;
    good(shell->estimate_accuracy());
    EXPECT_EQ(shell.K1(), wanted.single_point().K1) << wanted.a;
    EXPECT_EQ(shell.K2(), wanted.single_point().K2) << wanted.a;
  }
}

TEST(ShellSession, ChangesStayAcrossLengths) {
  const ShellOnText shell(cracked_hub());
  good(shell->add_step_line("LOAD PULL 2.0"));
  good(shell->solve());
  good(shell->change_card("$CRACK NAME=C A0=6.0"));
  expect_k(shell, k_of_run(replaced(cracked_hub("A0=6"), "LOAD PULL 1", "LOAD PULL 2")), 1e-10);
  good(shell->go_to_step("PRESS"));
  const std::optional<Solved> run = solve_text(cracked_hub("A0=6"));
  ASSERT_TRUE(run);
  EXPECT_NEAR(shell.K1(), run->step(0).fronts.front().single_point().raw_K()[0],
              1e-10 * shell.K1());
}

TEST(ShellSession, InterferenceAndParameterAreThoseOfARun) {
  const ShellOnText shell(cracked_hub());
  good(shell->change_card("$CONTACT NAME=SEAT INTERFERENCE=0.02"));
  expect_k(shell, k_of_run(cracked_hub("A0=4", "INTERFERENCE=0.02")), 1e-10);
  good(shell->change_parameter("T = 5"));
  const std::string thin = replaced(cracked_hub("A0=4", "INTERFERENCE=0.02"), "T = 10", "T = 5 ");
  expect_k(shell, k_of_run(thin), 1e-10);
  good(shell->open());
  expect_k(shell, k_of_run(cracked_hub()), 1e-10);
}

// A key takes the place of those that exclude it; the factor of the fit stays.
TEST(ShellSession, KeysTakeThePlaceOfOthers) {
  const ShellOnText shell(cracked_hub());
  good(shell->add_step_line("FIT SEAT 0.5"));
  good(shell->solve());
  good(shell->change_card("$CONTACT NAME=SEAT DIAMETRAL=0.08"));
  EXPECT_EQ(shell->solver().action_factors().fit[0], 0.5);
  expect_k(shell, k_of_run(cracked_hub("A0=4", "INTERFERENCE=0.02")), 1e-10);
  EXPECT_TRUE(shell->change_card("$CONTACT NAME=SAET GAP=0"));
  EXPECT_TRUE(shell->change_card("$CONTACT NAME=SEAT GAP"));
}

// Cards replace what stood there, expressions of a parameter too.
TEST(ShellSession, ParameterReachesWhatIsLeftOfIt) {
  const std::string fit = "INTERFERENCE=(T/1000)";
  const ShellOnText shell(cracked_hub("A0=(T/2)", fit));
  good(shell->change_card("$CRACK NAME=C A0=6"));
  good(shell->change_parameter("T = 9"));
  expect_k(shell, k_of_run(replaced(cracked_hub("A0=6", fit), "T = 10", "T = 9 ")), 1e-10);
}

TEST(ShellSession, UndoTakesChangesBackOneByOne) {
  const ShellOnText shell(cracked_hub());
  const double first = shell.K1();
  good(shell->add_step_line("LOAD PULL 2"));
  good(shell->solve());
  const double loaded = shell.K1();
  good(shell->change_card("$CRACK NAME=C A0=6"));
  good(shell->undo());
  EXPECT_NEAR(shell.K1(), loaded, 1e-10 * loaded);
  good(shell->undo());
  EXPECT_NEAR(shell.K1(), first, 1e-10 * first);
  EXPECT_TRUE(shell->undo());
}

// Between the ends of a map its error is interpolated, so that K agrees within the bars of both.
TEST(ShellSession, MapAgreesWithSolutions) {
  const ShellOnText shell(cracked_hub());
  const double before = shell.K1();
  good(shell->follow_load_case_range("PULL", "0", "6"));
  EXPECT_EQ(shell.K1(), before);
  const results::LoadPathResult path = *shell->last_followed_path();
  ASSERT_GT(path.t.size(), 4U); // the contact opens on the way
  for (const double t : {0.0, 0.21, 0.5, 0.83, 1.0}) {
    good(shell->add_step_line(fmt::format("LOAD PULL {}", 6.0 * t)));
    good(shell->solve());
    good(shell->estimate_accuracy());
    const double bar = shell->current_result().fronts[0].single_point().bar[0].size();
    EXPECT_NEAR(path.fronts.front().single_point().K[0](t), shell.K1(),
                1e-9 * path.fronts.front().single_point().K[0].largest_value() +
                    (t > 0.0 && t < 1.0 ? 2.0 * bar : 0.0))
        << t;
  }
  EXPECT_EQ(shell->last_followed_path(), nullptr); // of another state
}

TEST(ShellSession, QuantitiesOfNowAndOfSteps) {
  const std::string deck = cracked_hub();
  const std::optional<Solved> run = solve_text(deck);
  ASSERT_TRUE(run);
  const ShellOnText shell(deck);
  good(shell->add_step_line("LOAD PULL 2.0"));
  model::ResultCheck check;
  check.relative = false;
  check.quantity = "K1";
  double value = 0.0;
  check.arguments = {std::string("C"), std::string("PRESS")};
  good(program::evaluate_result(*shell, check, value));
  EXPECT_NEAR(value, run->step(0).fronts.front().single_point().K1, 1e-10 * value);
  check.arguments = {std::string("C"), std::string("NOW")};
  good(program::evaluate_result(*shell, check, value));
  EXPECT_EQ(value, shell.K1()); // what was pending is solved
  EXPECT_FALSE(shell->has_pending_changes());
  check.quantity = "SUM"; // equilibrium of the pin
  check.arguments = {std::string("SEAT"), std::string("NOW"), std::string("X")};
  good(program::evaluate_result(*shell, check, value));
  EXPECT_NEAR(value, -40000.0, 1e-4);
}

TEST(ShellSession, ErrorBarsAreThoseOfARun) {
  const std::string deck = cracked_hub();
  const std::optional<Solved> run = solve_text(deck);
  ASSERT_TRUE(run);
  const ShellOnText shell(deck);
  good(shell->go_to_step("PRESS"));
  good(shell->estimate_accuracy());
  good(shell->go_to_step("PULLED"));
  good(shell->estimate_accuracy());
  const results::FrontResult& wanted = run->step(1).fronts.front();
  const results::FrontResult& found = shell->current_result().fronts.front();
  ASSERT_EQ(found.missing_bar_reason, wanted.missing_bar_reason);
  EXPECT_NEAR(found.single_point().bar[0].size(), wanted.single_point().bar[0].size(),
              1e-8 * wanted.single_point().K1);
  ASSERT_EQ(found.sensitivities.by_parameter.size(), wanted.sensitivities.by_parameter.size());
}

TEST(ShellSession, FailuresLeaveEverything) {
  const ShellOnText shell(cracked_hub());
  const double before = shell.K1();
  const base::OptionalFailure unknown = shell->add_step_line("LOAD PUL 1.0");
  ASSERT_TRUE(unknown);
  EXPECT_EQ(unknown->kind, base::ProgramOutcome::usage);
  EXPECT_NE(unknown->why.find("PULL"), std::string::npos);
  const base::OptionalFailure long_one = shell->change_card("$CRACK NAME=C A0=200");
  ASSERT_TRUE(long_one);
  EXPECT_EQ(long_one->kind, base::ProgramOutcome::deck_error);
  testing::internal::CaptureStderr();
  EXPECT_TRUE(shell->change_card("$CRACK NAME=C A0=-1.0"));
  EXPECT_NE(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(shell->change_parameter("T = 1/"));
  testing::internal::CaptureStderr();
  EXPECT_TRUE(shell->change_parameter("T = 1/0"));
  EXPECT_NE(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(shell.K1(), before);
  good(shell->open());
  EXPECT_NEAR(shell.K1(), before, 1e-12 * before);
}

TEST(ShellSession, LooseBodyIsNamedAndTheStateStays) {
  const ShellOnText shell(cracked_hub("A0=4", "GAP=0.01"));
  const double before = shell->current_result().energy;
  good(shell->add_step_line("LOAD PULL 1e-3"));
  good(shell->solve());
  const double small = shell->current_result().energy;
  EXPECT_LT(small, before);
  good(shell->add_step_line("DISMOUNT SEAT")); // nothing holds the pin
  const base::OptionalFailure loose = shell->solve();
  ASSERT_TRUE(loose);
  EXPECT_EQ(loose->kind, base::ProgramOutcome::not_solvable);
  EXPECT_NE(loose->why.find("PIN"), std::string::npos) << loose->why;
  EXPECT_EQ(shell->current_result().energy, small);
}

TEST(ShellSession, StopsWhenAsked) {
  ShellOnText shell(cracked_hub());
  const double before = shell.K1();
  shell.stop = true;
  const base::OptionalFailure stopped = shell->change_card("$CRACK NAME=C A0=6.0");
  ASSERT_TRUE(stopped);
  EXPECT_EQ(stopped->kind, base::ProgramOutcome::stopped);
  EXPECT_TRUE(shell->go_to_step("PRESS"));
  EXPECT_TRUE(shell->follow_load_case_range("PULL", "0", "1"));
  shell.stop = false;
  good(shell->restore_after_failure());
  EXPECT_EQ(shell.K1(), before);
  EXPECT_EQ(shell.crack_size().a, 4.0);
}

// With friction the order counts: the shell follows it as steps of a run do.
TEST(ShellSession, FollowsFriction) {
  const std::string contact = "INTERFERENCE=0.01 MU=0.2";
  const std::string deck = cracked_hub("A0=4", contact);
  const ShellOnText shell(deck);
  EXPECT_TRUE(shell->has_friction());
  const double before = shell.K1();
  good(shell->add_step_line("LOAD PULL 3.0"));
  good(shell->solve(5));
  good(shell->add_step_line("LOAD PULL 1.0"));
  good(shell->solve(5));
  const std::string steps = "  LOAD PULL 1\n$STEP NAME=UP SUBSTEPS=5\n  LOAD PULL 3\n"
                            "$STEP NAME=DOWN SUBSTEPS=5\n  LOAD PULL 1\n";
  const base::Vec2 wanted = k_of_run(replaced(deck, "  LOAD PULL 1\n", steps));
  expect_k(shell, wanted, 1e-10);
  EXPECT_GT(std::abs(shell.K1() - before), 1e-3 * before);
  EXPECT_TRUE(shell->follow_load_case_range("PULL", "0", "1"));
  good(shell->change_card("$CRACK NAME=C A0=5.0")); // the whole history again
  expect_k(shell, k_of_run(replaced(cracked_hub("A0=5", contact), "  LOAD PULL 1\n", steps)), 1e-9);
}

TEST(ShellSession, MountsAsARunDoes) {
  std::string deck = replaced(cracked_hub(), "  HELD\n", "  HELD\n  PIN.INNER\n");
  deck = replaced(deck, "  FIT SEAT 1\n", "  LOAD PULL 5\n");
  deck = replaced(deck, "  LOAD PULL 1\n", "  MOUNT SEAT\n$STEP NAME=BACK\n  LOAD PULL 0\n");
  const ShellOnText shell(deck);
  expect_k(shell, k_of_run(deck), 1e-12);
  const double mounted = shell.K1();
  good(shell->add_step_line("DISMOUNT SEAT"));
  good(shell->solve());
  EXPECT_NEAR(shell.K1(), 0.0, 1e-12 * mounted); // nothing acts on the hub
  good(shell->go_to_step("PRESS"));
  good(shell->add_step_line("MOUNT SEAT")); // onto the pin as it is pulled
  good(shell->solve());
  good(shell->add_step_line("LOAD PULL 0.0"));
  good(shell->solve());
  EXPECT_NEAR(shell.K1(), mounted, 1e-10 * mounted);
  EXPECT_EQ(shell->changes().applied.size(), 2U); // mounting is not merged into what comes after it
}

// A contact in force has taken on its fit: mounted once more it would count it twice.
TEST(ShellSession, MountsNothingTwice) {
  const ShellOnText shell(held_hub());
  const double before = shell.K1();
  const base::OptionalFailure refused = shell->add_step_line("MOUNT SEAT");
  ASSERT_TRUE(refused);
  EXPECT_NE(refused->why.find("SEAT is mounted already"), std::string::npos) << refused->why;
  EXPECT_FALSE(shell->has_pending_changes());
  good(shell->add_step_line("DISMOUNT SEAT"));
  EXPECT_TRUE(shell->has_pending_changes());
  good(shell->add_step_line("MOUNT SEAT")); // it was not dismounted yet
  EXPECT_FALSE(shell->has_pending_changes());
  good(shell->solve());
  EXPECT_EQ(shell.K1(), before);
  good(shell->add_step_line("DISMOUNT SEAT"));
  good(shell->solve());
  EXPECT_TRUE(shell->add_step_line("DISMOUNT SEAT")); // absent already
}

// Faces that would overlap become a pair, as in a run.
TEST(ShellSession, ClosesFaces) {
  const std::string plate = R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=20 LY=20 NX=10 NY=10
$MATERIAL NAME=S E=210000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=S STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  YMIN
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 20 100
$STEP NAME=UP
  LOAD PULL 1
$CRACK NAME=C ANGLE=0 A0=5
  0 10
$END
)";
  const ShellOnText shell(plate);
  const double open = shell.K1();
  EXPECT_GT(open, 0.0);
  good(shell->add_step_line("LOAD PULL -1.0"));
  good(shell->solve());
  expect_k(shell, k_of_run(replaced(plate, "LOAD PULL 1", "LOAD PULL -1")), 1e-9);
  EXPECT_EQ(shell.K1(), 0.0);
  good(shell->add_step_line("LOAD PULL 1.0"));
  good(shell->solve());
  EXPECT_NEAR(shell.K1(), open, 1e-9 * open);
}

} // namespace
} // namespace spricka::test_shell_session
