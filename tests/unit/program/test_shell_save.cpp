// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/save.hpp"
#include "shell_runs.hpp"

#include <cmath>

namespace spricka::test_shell_save {
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

void expect_saved(const ShellOnText& shell, double tolerance) {
  std::string text;
  good(program::make_saved_deck_text(*shell, shell.folder.path(), text));
  SCOPED_TRACE(text);
  expect_k(shell, k_of_run(text), tolerance);
}

TEST(ShellSave, RunsToTheSameK) {
  const ShellOnText shell(cracked_hub());
  expect_saved(shell, 1e-10);
  good(shell->add_step_line("LOAD PULL 2.5"));
  good(shell->add_step_line("FIT SEAT 0.9"));
  good(shell->solve());
  expect_saved(shell, 1e-10);
  good(shell->change_card("$CRACK NAME=C A0=5.5"));
  good(shell->change_card("$CONTACT NAME=SEAT INTERFERENCE=0.03"));
  good(shell->change_parameter("T = 7[mm] ! thinner"));
  expect_saved(shell, 1e-10);
}

TEST(ShellSave, KeepsTheOrderWithFriction) {
  const ShellOnText shell(cracked_hub("A0=4", "INTERFERENCE=0.01 MU=0.2"));
  good(shell->add_step_line("LOAD PULL 3.0"));
  good(shell->solve(3));
  good(shell->add_step_line("LOAD PULL 1.0"));
  good(shell->solve(4));
  expect_saved(shell, 1e-10);
  good(shell->go_to_step("PRESS"));
  std::string text;
  const base::OptionalFailure refused =
      program::make_saved_deck_text(*shell, shell.folder.path(), text);
  ASSERT_TRUE(refused); // the deck's further steps would come in between
  EXPECT_NE(refused->hint.find("PULLED"), std::string::npos);
}

// A contact that no step mounts is in force from the beginning and stays so in the earlier steps.
TEST(ShellSave, NamesAMountThatNoStepNamed) {
  const ShellOnText shell(held_hub());
  good(shell->add_step_line("DISMOUNT SEAT"));
  good(shell->solve());
  good(shell->add_step_line("MOUNT SEAT"));
  good(shell->solve());
  expect_saved(shell, 1e-10);
  std::string text;
  good(program::make_saved_deck_text(*shell, shell.folder.path(), text));
  const std::optional<Solved> before = solve_text(held_hub());
  const std::optional<Solved> after = solve_text(text);
  ASSERT_TRUE(before && after);
  const double pressed = before->step(0).fronts.front().single_point().K1;
  EXPECT_GT(std::abs(pressed), 0.0);
  EXPECT_NEAR(after->step(0).fronts.front().single_point().K1, pressed, 1e-12 * std::abs(pressed));
}

// A fit that no step names is 1 from the beginning and stays so in the earlier steps.
TEST(ShellSave, NamesAFitThatNoStepNamed) {
  const std::string deck = replaced(cracked_hub(), "  FIT SEAT 1\n", "  LOAD PULL 0\n");
  const ShellOnText shell(deck);
  good(shell->add_step_line("FIT SEAT 2.0"));
  good(shell->solve());
  expect_saved(shell, 1e-10);
  std::string text;
  good(program::make_saved_deck_text(*shell, shell.folder.path(), text));
  const std::optional<Solved> before = solve_text(deck);
  const std::optional<Solved> after = solve_text(text);
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(after->step(0).fronts.front().single_point().K1,
              before->step(0).fronts.front().single_point().K1,
              1e-10 * before->step(0).fronts.front().single_point().K1);
}

TEST(ShellSave, LeavesOutWhatSpeaksOfOtherLengths) {
  const ShellOnText shell(
      cracked_hub("A0=4", "INTERFERENCE=0.01",
                  "$GROW LAW=INCREMENT KMAX=PULLED\n  4 6\n$CHECK\n  K(C,PULLED,4) = 1 REL 1\n"));
  good(shell->change_card("$CRACK NAME=C A0=6.0"));
  expect_saved(shell, 1e-10);
}

} // namespace
} // namespace spricka::test_shell_save
