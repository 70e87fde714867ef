// SPDX-License-Identifier: GPL-3.0-or-later
// Growth at the prompt: the life of a run, and other laws over fronts that are there.
#include "deck/growth_cards.hpp"
#include "program/shell/result_value.hpp"
#include "shell_runs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_shell_growth {
namespace {

using test::good;
using test::replaced;
using test::ShellOnText;
using test::solve_text;
using test::Solved;

constexpr double of_tolerance = 2e-3; // two growths, each to TOL

std::string plate(const std::string& crack = "ANGLE=0 A0=2\n  0  20",
                  const std::string& law = "C=(C0) M=3") {
  return R"($DECK VERSION=1 LENGTH=MM FORCE=N
$PARAMETER
  C0 = 1e-13
  width = 20
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=(width) LY=40 NX=8 NY=16
$MATERIAL NAME=STEEL E=210[GPa] NU=0.3
$PROPERTY ESET=BODY MATERIAL=STEEL STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  YMIN
$LOAD CASE=PULL TYPE=TRACTION
  YMAX  0  100
$STEP NAME=LOW
  LOAD PULL 0.1
$STEP NAME=HIGH
  LOAD PULL 1
$LOADPATH NAME=UP FROM=LOW TO=HIGH
$SPECTRUM NAME=FLIGHT PATH=UP TYPE=SEQUENCE
  0 0.5 0.2 1 0.1 0.8 0
$INTERACTION NAME=W1 TYPE=WHEELER W=1 KAPPA=0.2 YIELD=100
$CRACK NAME=C )" +
         crack + "\n$GROW LAW=PARIS KUNIT='MPa*mm^0.5' AUNIT='mm' AMAX=5 KMAX=HIGH KMIN=LOW " +
         law + "\n$END\n";
}

double life_of_run(const std::string& deck) {
  const std::optional<Solved> solved = solve_text(deck);
  return solved ? solved->run.growth->final_cycles() : 0.0;
}

double life(const ShellOnText& shell) {
  good(shell->grow(false));
  return shell->growth().result().growth->final_cycles();
}

TEST(ShellGrowth, IsThatOfARun) {
  const ShellOnText shell(plate());
  EXPECT_EQ(life(shell), life_of_run(plate()));
  EXPECT_EQ(shell->growth().solved_count(), shell->growth().result().increments.size());
  model::ResultCheck check;
  double value = 0.0;
  good(program::read_result_request(shell->model(), "LIFE()", check));
  good(program::evaluate_result(*shell, check, value));
  EXPECT_EQ(value, life(shell));
}

TEST(ShellGrowth, AnotherLawSolvesNoFront) {
  const ShellOnText shell(plate());
  const double first = life(shell);
  good(shell->change_parameter("C0 = 2e-13"));
  EXPECT_NEAR(life(shell), 0.5 * first, 1e-12 * first);
  EXPECT_EQ(shell->growth().solved_count(), 0);
  for (const char* law : {"$GROW LAW=WALKER P=0.5 M=3.3", "$GROW SPECTRUM=FLIGHT"}) {
    good(shell->change_card(law));
    const double wanted = life_of_run(
        std::string(law).find("SPECTRUM") == std::string::npos
            ? replaced(plate("ANGLE=0 A0=2\n  0  20", "C=2e-13 M=3.3 P=0.5"), "PARIS", "WALKER")
            : replaced(replaced(plate("ANGLE=0 A0=2\n  0  20", "C=2e-13 M=3.3 P=0.5"), "PARIS",
                                "WALKER"),
                       "KMAX=HIGH KMIN=LOW", "SPECTRUM=FLIGHT"));
    EXPECT_NEAR(life(shell), wanted, of_tolerance * wanted);
    EXPECT_EQ(shell->growth().solved_count(), 0) << law;
  }
  const double alone = life(shell);
  good(shell->change_card("$GROW INTERACTION=W1,NONE"));
  EXPECT_GT(life(shell), 1.02 * alone);
  EXPECT_EQ(shell->growth().solved_count(), 0);
  for (int k = 0; k < 4; ++k) {
    good(shell->undo());
  }
  EXPECT_EQ(life(shell), first);
  EXPECT_EQ(shell->growth().solved_count(), 0);
}

TEST(ShellGrowth, ANearerEndSolvesNoFrontAndALaterOneOnlyThoseBehind) {
  const ShellOnText shell(plate());
  life(shell);
  const auto fronts = shell->growth().result().increments.size();
  for (const double end : {3.3, 6.0}) {
    good(shell->change_card(fmt::format("$GROW AMAX={}", end)));
    const double wanted = life_of_run(replaced(plate(), "AMAX=5", fmt::format("AMAX={}", end)));
    EXPECT_NEAR(life(shell), wanted, of_tolerance * wanted);
    EXPECT_EQ(shell->growth().result().growth->ended, "AMAX");
    EXPECT_NEAR(shell->growth().result().growth->curve.back().a.front(), end, 1e-9);
    EXPECT_EQ(shell->growth().solved_count() > 0, end > 5.0);
  }
  EXPECT_LT(shell->growth().solved_count(), fronts);
}

// Two tips that see the same K share the growth evenly, whatever the law.
TEST(ShellGrowth, TipsThatShareTheGrowthAsBefore) {
  const std::string inside = "\n  8 20\n  12 20";
  const ShellOnText shell(replaced(plate(inside), "AMAX=5", "AMAX=4"));
  const double first = life(shell);
  good(shell->change_card("$GROW C=4e-13"));
  EXPECT_NEAR(life(shell), 0.25 * first, 1e-12 * first);
  good(shell->change_card("$GROW M=3.5"));
  const double wanted = life_of_run(replaced(plate(inside, "C=4e-13 M=3.5"), "AMAX=5", "AMAX=4"));
  EXPECT_NEAR(life(shell), wanted, of_tolerance * wanted);
  EXPECT_EQ(shell->growth().solved_count(), 0);
}

// Beside an edge the nearer tip takes the more of it the larger the exponent is.
TEST(ShellGrowth, TipsThatShareItOtherwiseAreSolvedAnew) {
  const std::string beside = "\n  3 20\n  8 20";
  const auto deck = [&](const char* law) {
    return replaced(plate(beside, law), "AMAX=5", "AMAX=4");
  };
  const ShellOnText shell(deck("C=1e-13 M=2"));
  life(shell);
  good(shell->change_card("$GROW M=5"));
  const double wanted = life_of_run(deck("C=1e-13 M=5"));
  EXPECT_NEAR(life(shell), wanted, 2.0 * of_tolerance * wanted);
  EXPECT_GT(shell->growth().solved_count(), 0);
  EXPECT_NE(shell->growth().why_solved_anew().find("share"), std::string::npos);
  good(shell->change_card("$GROW M=2")); // the first path is still there
  life(shell);
  EXPECT_EQ(shell->growth().solved_count(), 0);
}

TEST(ShellGrowth, WithAnotherCrackOrLoadAllIsSolved) {
  const ShellOnText shell(plate());
  life(shell);
  good(shell->change_card("$CRACK NAME=C A0=2.5"));
  EXPECT_NEAR(life(shell), life_of_run(plate("ANGLE=0 A0=2.5\n  0  20")),
              of_tolerance * life(shell));
  EXPECT_EQ(shell->growth().why_solved_anew(), "");
  good(shell->grow(true));
  EXPECT_EQ(shell->growth().solved_count(), shell->growth().result().increments.size());
}

TEST(ShellGrowth, CtrlCKeepsTheFrontsThatAreSolved) {
  ShellOnText shell(plate());
  shell.stop = true;
  const base::OptionalFailure trouble = shell->grow(false);
  ASSERT_TRUE(trouble);
  EXPECT_EQ(trouble->kind, base::ProgramOutcome::stopped);
  shell.stop = false;
  EXPECT_EQ(life(shell), life_of_run(plate()));
}

TEST(ShellGrowth, WithoutALawThereIsNone) {
  const ShellOnText shell(test::cracked_hub());
  EXPECT_TRUE(shell->grow(false));
}

deck::DeckCardList cards_of(const ShellOnText& shell) {
  return *shell->changes().text;
}

TEST(GrowthCards, TellTheLawFromAllElse) {
  const ShellOnText shell(plate());
  const deck::DeckCardList before = cards_of(shell);
  const auto alone = [&](const char* card, const char* key, const char* value) {
    deck::DeckCardList after = before;
    std::ranges::find(after, card, &deck::DeckCard::name)->set_key(key, value);
    return deck::differ_in_growth_law_alone(before, after, {});
  };
  EXPECT_TRUE(alone("GROW", "M", "4"));
  EXPECT_TRUE(alone("SPECTRUM", "FACTOR", "0.9"));
  EXPECT_FALSE(alone("GROW", "DIRECTION", "HOOP"));
  EXPECT_FALSE(alone("GROW", "LAW", "INCREMENT"));
  EXPECT_FALSE(alone("MATERIAL", "E", "70000"));
  const auto with = [&](const char* parameter, const std::set<std::string>& script = {}) {
    deck::DeckCardList after = before;
    EXPECT_TRUE(deck::replace_parameter(after, parameter, "21"));
    return deck::differ_in_growth_law_alone(before, after, script);
  };
  EXPECT_TRUE(with("C0"));
  EXPECT_FALSE(with("C0", {"C0"}));
  EXPECT_FALSE(with("WIDTH"));
}

} // namespace
} // namespace spricka::test_shell_growth
