// SPDX-License-Identifier: GPL-3.0-or-later
// The time that a run still takes, foretold from what its parts have taken.
#include "program/job/progress_line.hpp"
#include "tests/unit/support/shell_text.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace spricka::program::test_progress {
namespace {

// Each increment takes 2 s before its steps and 4 s for each of two.
TEST(RemainingTime, IsThatOfEqualParts) {
  RemainingTime left;
  left.record_progress({.increments = 3, .stage = "read"}, 0.0);
  EXPECT_FALSE(left.seconds(0.5));
  left.record_progress({.stage = "condensed"}, 2.0);
  EXPECT_FALSE(left.seconds(4.0));
  left.record_progress({.stage = "step A: K", .step = 0, .steps = 2}, 5.0);
  EXPECT_FALSE(left.seconds(5.0)); // the first step is not over
  left.record_progress({.stage = "step A", .step = 1, .steps = 2}, 6.0);
  ASSERT_TRUE(left.seconds(6.0));
  EXPECT_DOUBLE_EQ(*left.seconds(6.0), 4.0 + 2.0 * 10.0);
  EXPECT_DOUBLE_EQ(*left.seconds(7.0), 3.0 + 2.0 * 10.0); // the clock goes on
  left.record_progress({.stage = "step B", .step = 2, .steps = 2}, 10.0);
  left.record_progress({.increment = 1, .increments = 3}, 10.0);
  EXPECT_DOUBLE_EQ(*left.seconds(10.0), 20.0);
  left.record_progress({.stage = "condensed"}, 12.0);
  EXPECT_DOUBLE_EQ(*left.seconds(12.0), 18.0);
  left.record_progress({.increment = 2, .increments = 3}, 20.0);
  left.record_progress({.increment = 3, .increments = 3}, 30.0);
  EXPECT_DOUBLE_EQ(*left.seconds(30.0), 0.0);
}

// Increments that an earlier run had solved take no time and foretell none.
TEST(RemainingTime, CountsNothingThatWasTakenOver) {
  RemainingTime left;
  left.record_progress({.increment = 1, .increments = 4}, 0.1);
  left.record_progress({.increment = 2, .increments = 4}, 0.2);
  EXPECT_FALSE(left.seconds(0.2));
  left.record_progress({.stage = "meshed"}, 2.2);
  left.record_progress({.increment = 3, .increments = 4}, 10.2);
  ASSERT_TRUE(left.seconds(10.2));
  EXPECT_NEAR(*left.seconds(10.2), 8.0, 1e-9);
}

// Unloaded without friction a joint is as it was pressed: that state is not solved again, and its K
// is there as soon as it is known.
TEST(RunProgress, UnloadingIsNotSolvedAnew) {
  const std::string deck =
      test::cracked_hub("A0=4", "INTERFERENCE=0.01", "$STEP NAME=BACK\n  LOAD PULL 0\n");
  std::vector<std::size_t> steps; // that have K, at each call
  std::size_t to_solve = 0;
  analysis::SolveOptions options;
  options.found = [&](const results::CrackLengthResult& increment) {
    steps.push_back(increment.steps.size());
    EXPECT_NE(increment.steps.back().fronts.front().single_point().K1, 0.0);
  };
  options.progress = [&](const analysis::RunProgress& progress) {
    to_solve = std::max(to_solve, progress.steps);
  };
  const std::optional<test::Solved> solved = test::solve_text(deck, options);
  ASSERT_TRUE(solved);
  EXPECT_EQ(to_solve, 2U);
  EXPECT_EQ(steps, (std::vector<std::size_t>{1, 1, 2, 2, 3})); // K, then its bars
  EXPECT_EQ(solved->step(2).fronts.front().single_point().K1,
            solved->step(0).fronts.front().single_point().K1);
  EXPECT_TRUE(solved->step(2).fronts.front().missing_bar_reason.empty());
}

// Stresses are those of the step with the largest K, which is known when all are solved, or of the
// one that the deck names, here one that repeats another.
TEST(ShownStep, AloneHasStresses) {
  for (const bool named : {false, true}) {
    const std::string deck = test::cracked_hub("A0=4", "INTERFERENCE=0.01",
                                               std::string("$STEP NAME=BACK\n  LOAD PULL 0\n") +
                                                   (named ? "$CONTROL SHOW=BACK\n" : ""));
    const std::optional<test::Solved> solved = test::solve_text(deck);
    ASSERT_TRUE(solved);
    for (const std::size_t s : {0U, 1U, 2U}) {
      const bool shown = s == (named ? 2U : 1U);
      EXPECT_EQ(solved->step(s).stress.empty(), !shown) << s;
      EXPECT_EQ(solved->step(s).element_stress.empty(), !shown) << s;
      EXPECT_EQ(solved->step(s).errors.empty(), !shown) << s;
    }
  }
}

} // namespace
} // namespace spricka::program::test_progress
