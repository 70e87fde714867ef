// SPDX-License-Identifier: GPL-3.0-or-later
// The closed rows of contacts between solids are the same wherever the search for them begins.
#include "solve/contact_qp.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/solved_scene.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace spricka::test_contact_starts {
namespace {

// A deck of decks/ with changes of its text, what it imports found where it is.
std::string deck_with(const std::string& name,
                      std::vector<std::pair<std::string, std::string>> changes) {
  std::ifstream file(test::decks_folder() + "/" + name);
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (text.find("$IMPORT FILE='") != std::string::npos) {
    changes.emplace_back("$IMPORT FILE='",
                         std::string("$IMPORT FILE='") + test::decks_folder() + "/");
  }
  for (const auto& [from, to] : changes) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  }
  return text;
}

// What the first step asks of the contact system.
solve::ContactProblem first_problem(const std::string& deck) {
  test::SolvedScene scene(deck);
  EXPECT_TRUE(scene.solve(0));
  return scene.solver->contact_system()->condense_problem(scene.solver->contact_problem());
}

// None, all, and twenty at random.
std::vector<std::vector<bool>> starts(std::size_t rows) {
  std::vector<std::vector<bool>> all{std::vector<bool>(rows, false), std::vector<bool>(rows, true)};
  std::mt19937 engine(1);
  for (int k = 0; k < 20; ++k) {
    std::vector<bool>& start = all.emplace_back(rows);
    std::bernoulli_distribution closed(std::uniform_real_distribution<double>(0.0, 1.0)(engine));
    for (std::size_t i = 0; i < rows; ++i) {
      start[i] = closed(engine);
    }
  }
  return all;
}

// `unique`: forces are, too; else the motions they cause.
void expect_one_solution(const solve::ContactProblem& p, bool unique) {
  std::optional<solve::ContactSolution> first;
  int iterations = 0;
  int pivots = 0;
  for (const std::vector<bool>& start : starts(static_cast<std::size_t>(p.b.size()))) {
    const solve::ContactSolution s = solve::solve_contact(p, solve::ContactSettings{}, start);
    ASSERT_EQ(s.status, solve::ContactStatus::solved);
    iterations = std::max(iterations, s.block_iterations);
    pivots = std::max(pivots, s.pivots);
    if (!first) {
      first = s;
      continue;
    }
    const base::Vector opened = p.W * first->lambda + p.B * first->alpha;
    EXPECT_LT((p.W * s.lambda + p.B * s.alpha - opened).norm(), 1e-10 * opened.norm());
    EXPECT_LE((s.alpha - first->alpha).norm(), 1e-10 * first->alpha.norm());
    if (unique) {
      EXPECT_EQ(s.closed, first->closed);
      EXPECT_LT((s.lambda - first->lambda).norm(), 1e-10 * first->lambda.norm());
    }
  }
  std::printf("%ld rows, %ld modes: at most %d iterations, %d pivots\n",
              static_cast<long>(p.b.size()), static_cast<long>(p.h.size()), iterations, pivots);
  EXPECT_LE(iterations, 12);
  EXPECT_EQ(pivots, 0);
}

TEST(ContactStarts, SphereOfHertz) {
  for (const char* n : {"n  = 4", "n  = 6"}) {
    expect_one_solution(first_problem(deck_with("hertz_sphere_solid.deck", {{"n  = 6", n}})), true);
  }
}

TEST(ContactStarts, NetFit) {
  expect_one_solution(first_problem(deck_with("net_fit_solid.deck", {})), true);
}

// The foot is finer and stiffer than the one face it stands on: what its nodes press by themselves
// the face does not feel.
TEST(ContactStarts, RankDeficientPair) {
  expect_one_solution(
      first_problem(deck_with("small_foot_solid.deck",
                              {{"SOFT E=1e5", "SOFT E=1e9"}, {"HARD E=1e9", "HARD E=1e5"}})),
      false);
}

} // namespace
} // namespace spricka::test_contact_starts
