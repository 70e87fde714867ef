// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of K along a front against differences of solutions.
#include "tests/unit/analysis/front_decks.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace spricka {
namespace {

struct Values {
  double pull = 1.0, press = 1.0, fit = 1.0, E = 1000.0;
  bool held = false; ///< the upper block is held, so that the fit presses
};

std::optional<test::Solved> solved_with(const Values& v) {
  if (v.held) {
    return test::solve_text(test::pressed_mouth(
        fmt::format("$FREEDOM CLASS=SUPPRESSED DOF=Z\n  B.ZMAX\n$STEP NAME=S\n  FIT ON "
                    "{:.12g}\n  LOAD PULL {:.12g}\n",
                    100.0 * v.fit, v.pull),
        v.E));
  }
  return test::solve_text(
      test::pressed_mouth(fmt::format("$STEP NAME=S\n  FIT ON {:.12g}\n  LOAD PULL {:.12g}\n  LOAD "
                                      "PRESS {:.12g}\n  LOAD TILT 0.4\n",
                                      v.fit, v.pull, v.press),
                          v.E));
}

const results::FrontSensitivity* find(const results::FrontResult& front, results::Cause cause,
                                      const std::string& name) {
  for (const results::FrontSensitivity& s : front.sensitivities.of) {
    if (s.cause == cause && s.name == name) {
      return &s;
    }
  }
  return nullptr;
}

// dK = value * derivative times the small part against (K(+) - K(-)) / 2.
void compare(const results::FrontResult& at, const results::FrontSensitivity* s, double part,
             const Values& up, const Values& down) {
  ASSERT_NE(s, nullptr);
  const auto ahead = solved_with(up);
  const auto behind = solved_with(down);
  ASSERT_TRUE(ahead && behind);
  const results::FrontResult& a = ahead->step().fronts[0];
  const results::FrontResult& b = behind->step().fronts[0];
  double size = 0.0;
  for (std::size_t i = 0; i < at.points.size(); ++i) {
    size = std::max(size, std::abs(s->value * s->above[i][0]));
  }
  ASSERT_GT(size, 0.0);
  for (std::size_t i = 0; i < at.points.size(); ++i) {
    const double scale = part * s->value;
    EXPECT_NEAR(scale * s->above[i][0], 0.5 * (a.points[i].K1 - b.points[i].K1), 1e-4 * part * size)
        << i;
    EXPECT_NEAR(scale * s->above[i][1], 0.5 * (a.points[i].K2 - b.points[i].K2), 1e-4 * part * size)
        << i;
    EXPECT_NEAR(scale * s->above[i][2], 0.5 * (a.points[i].K3 - b.points[i].K3), 1e-4 * part * size)
        << i;
  }
}

TEST(FrontSensitivity, AgreesWithDifferences) {
  const auto solved = solved_with({});
  ASSERT_TRUE(solved);
  const results::FrontResult& front = solved->step().fronts[0];
  ASSERT_TRUE(front.sensitivities.notes.empty()) << front.sensitivities.notes.front();
  constexpr double part = 1e-5;
  compare(front, find(front, results::Cause::load, "PULL"), part, {.pull = 1.0 + part},
          {.pull = 1.0 - part});
  compare(front, find(front, results::Cause::load, "PRESS"), part, {.press = 1.0 + part},
          {.press = 1.0 - part});
  compare(front, find(front, results::Cause::modulus, "M"), part, {.E = 1000.0 * (1.0 + part)},
          {.E = 1000.0 * (1.0 - part)});
}

TEST(FrontSensitivity, OfAFitAgreesWithDifferences) {
  const auto solved = solved_with({.held = true});
  ASSERT_TRUE(solved);
  const results::FrontResult& front = solved->step().fronts[0];
  ASSERT_TRUE(front.sensitivities.notes.empty()) << front.sensitivities.notes.front();
  constexpr double part = 1e-5;
  compare(front, find(front, results::Cause::fit, "ON"), part, {.fit = 1.0 + part, .held = true},
          {.fit = 1.0 - part, .held = true});
}

// K is the sum of what loads and fits do to it.
TEST(FrontSensitivity, LoadsAndFitsAddUpToK) {
  const auto solved = solved_with({});
  ASSERT_TRUE(solved);
  const results::FrontResult& front = solved->step().fronts[0];
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    double sum = 0.0;
    for (const results::FrontSensitivity& s : front.sensitivities.of) {
      if (s.cause == results::Cause::load || s.cause == results::Cause::fit) {
        sum += s.value * s.above[i][0];
      }
    }
    EXPECT_NEAR(sum, front.points[i].K1, 1e-9 * front.points[i].K1) << i;
  }
}

} // namespace
} // namespace spricka
