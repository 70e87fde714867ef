// SPDX-License-Identifier: GPL-3.0-or-later
// The lug of solids on straight ways between random pairs of loads and fits: what the path says of
// every contact force, and where rows close and open, is what direct solutions say.
#include "solve/contact_qp.hpp"
#include "solve/parametric.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/solved_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace spricka::test_load_maps_solid {
namespace {

class MapDice {
public:
  double real(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }

private:
  std::mt19937 engine_{1};
};

// decks/lug_solid.deck up to its loads, then two steps and a path for each pair.
std::string lug_deck(int pairs, bool full, MapDice& dice) {
  std::ifstream file(test::decks_folder() + "/lug_solid.deck");
  std::string deck(std::istreambuf_iterator<char>(file), {});
  deck.resize(deck.find("$LOAD "));
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = deck.find(from); at != std::string::npos;
         at = deck.find(from, at + to.size())) {
      deck.replace(at, from.size(), to);
    }
  };
  replace("$IMPORT FILE='", std::string("$IMPORT FILE='") + test::decks_folder() + "/");
  if (!full) {
    replace("fine = 0.7", "fine = 0.3");
    replace("nz   = 2", "nz   = 1");
  }
  deck += "$LOAD CASE=FX TYPE=RESULTANT\n  SHAFT.BODY  (F)  0  0\n"
          "$LOAD CASE=FY TYPE=RESULTANT\n  SHAFT.BODY  0  (F)  0\n";
  for (int k = 0; k < pairs; ++k) {
    for (const char end : {'A', 'B'}) {
      const double force = dice.real(0.05, 1.6);
      const double angle = dice.real(-std::numbers::pi, std::numbers::pi);
      deck += fmt::format("$STEP NAME={}{}\n  FIT BUSH {}\n  LOAD FX ({})\n  LOAD FY ({})\n", end,
                          k, dice.real(0.2, 1.2), force * std::cos(angle), force * std::sin(angle));
    }
  }
  for (int k = 0; k < pairs; ++k) {
    deck += fmt::format("$LOADPATH NAME=P{0} FROM=A{0} TO=B{0}\n", k);
  }
  return deck + "$END\n";
}

struct MapError {
  double force = 0.0;      // of the path at random places, over the largest
  double breakpoint = 0.0; // force or gap of rows where they change, over the largest
  std::size_t breakpoints = 0;
  std::size_t looked_at = 0;

  void add(const MapError& other) {
    force = std::max(force, other.force);
    breakpoint = std::max(breakpoint, other.breakpoint);
    breakpoints += other.breakpoints;
    looked_at += other.looked_at;
  }
};

solve::ContactSolution direct(const solve::ParametricProblem& problem, double t) {
  solve::ContactProblem at = problem.at_zero;
  at.b += t * problem.db;
  at.h += t * problem.dh;
  solve::ContactSolution s = solve::solve_contact(at, solve::ContactSettings{}, {});
  EXPECT_EQ(s.status, solve::ContactStatus::solved);
  return s;
}

MapError compare_with_direct(solve::ParametricProblem problem, MapDice& dice) {
  const Eigen::Index n = problem.db.size();
  problem.of_force = base::Matrix::Identity(n, n); // every force
  problem.of_mode = base::Matrix::Zero(n, problem.dh.size());
  problem.f0 = problem.df = base::Vector::Zero(n);
  const solve::SolutionPath path = solve::follow_solution_path(problem, 0.0, 1.0, {}, {});
  EXPECT_EQ(path.status, solve::PathStatus::complete);
  MapError error;
  error.breakpoints = path.segments.size() - 1;
  for (int k = 0; k < 6; ++k) {
    const double t = dice.real(0.0, 1.0);
    const auto segment =
        std::ranges::find_if(path.segments, [&](const auto& s) { return t <= s.to; });
    const solve::ContactSolution s = direct(problem, t);
    const base::Vector wrong = segment->value + (t - segment->from) * segment->slope - s.lambda;
    error.force = std::max(error.force, wrong.cwiseAbs().maxCoeff() / s.lambda.maxCoeff());
  }
  for (int k = 0; k < 6 && !path.changes.empty(); ++k) {
    const auto last = static_cast<int>(path.changes.size()) - 1;
    const solve::ActiveRowChange& change =
        path.changes[static_cast<std::size_t>(dice.whole(0, last))];
    const solve::ContactSolution s = direct(problem, path.segments[change.segment].from);
    error.breakpoint = std::max({error.breakpoint, s.lambda[change.row] / s.lambda.maxCoeff(),
                                 s.gap[change.row] / s.gap.maxCoeff()});
    ++error.looked_at;
  }
  return error;
}

TEST(LoadMaps, LugOfSolidsAgreesWithDirectSolutions) {
  const bool full = test::full_size();
  const int pairs = full ? 100 : 10;
  MapDice dice;
  test::SolvedScene scene(lug_deck(pairs, full, dice));
  for (std::size_t s = 0; s < scene.model().steps.size(); ++s) {
    const std::optional<analysis::StepState> state = scene.solve(s);
    ASSERT_TRUE(state);
    scene.length->load_paths().store_step_end_state(
        s, *scene.solver, scene.length->recover_step(scene.model().steps[s], *state));
  }
  MapError worst;
  for (const model::LoadPathDefinition& card : scene.model().load_paths) {
    const MapError error = compare_with_direct(
        scene.length->load_paths().parametric_path_problem(card, *scene.solver), dice);
    EXPECT_LT(error.force, 1e-9) << card.name;
    EXPECT_LT(error.breakpoint, 1e-9) << card.name;
    worst.add(error);
  }
  std::printf("%d pairs, %zu breakpoints: forces to %.1e, %zu breakpoints to %.1e\n", pairs,
              worst.breakpoints, worst.force, worst.looked_at, worst.breakpoint);
  EXPECT_GT(worst.breakpoints, 20U * static_cast<std::size_t>(pairs));
}

} // namespace
} // namespace spricka::test_load_maps_solid
