// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "tests/unit/support/shell_text.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

/// What a session says against what a run of the same deck says.
namespace spricka::test {

inline void good(const base::OptionalFailure& trouble) {
  ShellOnText::good(trouble);
}

/// K of the first tip at the end of a run's last step, as the mesh has it: a session takes the
/// estimated error out when it is asked for K.
inline base::Vec2 k_of_run(const std::string& deck) {
  const std::optional<Solved> solved = solve_text(deck);
  if (!solved) {
    return base::Vec2::Zero();
  }
  const results::FrontPointResult& tip =
      solved->run.increments.back().steps.back().fronts.front().single_point();
  return {tip.raw_K()[0], tip.raw_K()[1]};
}

inline void expect_k(const ShellOnText& shell, const base::Vec2& wanted, double tolerance) {
  const double size = wanted.norm();
  ASSERT_GT(size, 0.0);
  EXPECT_NEAR(shell.K1(), wanted[0], tolerance * size);
  EXPECT_NEAR(shell.K2(), wanted[1], tolerance * size);
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

/// Supports hold both parts, so that the seat may come apart.
inline std::string held_hub() {
  return replaced(cracked_hub(), "  HELD\n", "  HELD\n  PIN.INNER\n");
}

} // namespace spricka::test
