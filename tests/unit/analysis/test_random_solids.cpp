// SPDX-License-Identifier: GPL-3.0-or-later
// Random small contacts between solids: every one is solved and obeys its conditions, or the body
// that nothing holds is named.
#include "tests/places.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace spricka::test_random_solids {
namespace {

class Dice {
public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }
  double real(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  bool chance(double p) { return real(0.0, 1.0) < p; }

private:
  std::mt19937 engine_;
};

std::string block(Dice& dice, const char* name, const base::Vec3& low, const base::Vec3& size) {
  static constexpr std::array types{"TET10", "HEXE8", "HEXEC20", "HEXEC27"};
  return fmt::format(
      "$NET NAME={}\n  $MESH SHAPE=BLOCK TYPE={} X0={} Y0={} Z0={} LX={} LY={} LZ={} "
      "NX={} NY={} NZ=1\n$ENDNET\n$PROPERTY ESET={}.BODY MATERIAL={} STATE=SOLID\n",
      name, types[static_cast<std::size_t>(dice.whole(0, 3))], low.x(), low.y(), low.z(), size.x(),
      size.y(), size.z(), dice.whole(1, 4), dice.whole(1, 4), name,
      dice.chance(0.5) ? "HARD" : "SOFT");
}

// A block on a floor, over its edge or not, perhaps with a second one on top and with a wall beside
// both, of which nodes are in two pairs; pressed and pushed askew, with friction or without.
struct RandomStack {
  std::string deck;
  double weight = 0.0;
};

RandomStack random_stack(unsigned seed) {
  Dice dice(seed);
  const bool wall = dice.chance(0.4);
  const bool second = dice.chance(0.4);
  const double mu = dice.chance(0.4) ? dice.real(0.05, 0.7) : 0.0;
  const base::Vec3 size(dice.real(2.0, 8.0), dice.real(2.0, 8.0), dice.real(1.0, 3.0));
  const base::Vec3 low(wall ? 0.0 : dice.real(-0.3 * size.x(), 10.0 - 0.7 * size.x()),
                       dice.real(-0.3 * size.y(), 10.0 - 0.7 * size.y()), 0.0);
  std::string deck = "$DECK VERSION=1 LENGTH=mm FORCE=N\n$MATERIAL NAME=HARD E=200000 NU=0.3\n"
                     "$MATERIAL NAME=SOFT E=70000 NU=0.2\n";
  deck += block(dice, "FLOOR", {0.0, 0.0, -3.0}, {10.0, 10.0, 3.0});
  deck += block(dice, "LOWER", low, size);
  std::string held = "  FLOOR.ZMIN\n";
  const std::string friction = mu > 0.0 ? fmt::format(" MU={}", mu) : "";
  std::string contacts = fmt::format("$CONTACT NAME=FOOT SLAVE=LOWER.ZMIN MASTER=FLOOR.ZMAX{}{}\n",
                                     dice.chance(0.5) ? " GAP=0" : "", friction);
  std::string top = "LOWER";
  if (second) {
    const base::Vec3 smaller(size.x() * dice.real(0.5, 1.0), size.y() * dice.real(0.5, 1.0), 1.5);
    deck += block(dice, "UPPER", {low.x(), low.y(), size.z()}, smaller);
    contacts += "$CONTACT NAME=JOINT SLAVE=UPPER.ZMIN MASTER=LOWER.ZMAX" + friction + "\n";
    top = "UPPER";
  }
  if (wall) {
    deck += block(dice, "WALL", {-2.0, -3.0, -0.5}, {2.0, 16.0, 9.0});
    held += "  WALL.XMIN\n";
    contacts += "$CONTACT NAME=SIDE SLAVE=LOWER.XMIN MASTER=WALL.XMAX" + friction + "\n";
  }
  const double p = dice.real(1.0, 50.0);
  // without friction or wall nothing takes a push
  const double push = wall       ? -dice.real(0.0, 0.5) * p
                      : mu > 0.0 ? dice.real(0.0, 1.2) * mu * p
                                 : 0.0;
  deck += "$FREEDOM CLASS=SUPPRESSED DOF=XYZ\n" + held + contacts;
  deck += fmt::format("$LOAD CASE=P TYPE=TRACTION\n  {0}.ZMAX  ({1})  ({2})  ({3})\n"
                      "$STEP NAME=S SUBSTEPS=2\n  LOAD P 1\n$END\n",
                      top, push, mu > 0.0 ? dice.real(-0.3, 0.3) * mu * p : 0.0, -p);
  return {deck, p};
}

struct Attempt {
  std::optional<results::RunResult> run;
  base::OptionalFailure trouble;
};

Attempt attempt(const std::string& deck, int threads,
                analysis::CondensationMode condensing = analysis::CondensationMode::automatic) {
  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "test.deck";
  std::ofstream(file) << deck;
  program::CheckedDeck ready =
      program::read_and_check_deck(file, {}, program::Log(program::LogFormat::text));
  Attempt made;
  if (!ready.model) {
    ADD_FAILURE() << "refused:\n" << deck;
    return made;
  }
  analysis::SolveOptions options;
  options.threads = threads;
  options.condensing = condensing;
  base::Diagnostics diagnostics;
  made.run = analysis::solve_run(*ready.model, options, diagnostics, made.trouble);
  return made;
}

// Signorini's and Coulomb's conditions at all nodes, and forces that balance.
void expect_conditions(const results::LoadStepResult& step, double pressure) {
  for (const results::ContactResult& contact : step.contacts) {
    for (const results::ContactPoint& point : contact.points) {
      EXPECT_GE(point.p_consistent, 0.0);
      EXPECT_GE(point.gap, -1e-9);
    }
    EXPECT_LE(contact.shear_ratio, 1.0 + 1e-9);
  }
  // A hundred-thousandth of the loads may drive what nothing holds, and is told.
  const bool told = std::ranges::any_of(step.notes, [](const results::Note& note) {
    return note.text.find("is left over") != std::string::npos;
  });
  for (const results::ForceBalance& body : step.balance) {
    const base::Vec3 left = body.applied + body.contact + body.reaction;
    EXPECT_LT(left.norm(), (told ? 1e-2 : 1e-6) * pressure) << body.body;
  }
}

// The body that nothing holds, and no other reason.
void expect_named(const base::OptionalFailure& trouble) {
  ASSERT_TRUE(trouble.has_value());
  EXPECT_EQ(trouble->kind, base::ProgramOutcome::not_solvable) << trouble->why;
  EXPECT_NE(trouble->why.find("body "), std::string::npos) << trouble->why;
}

void expect_same(const Attempt& one, const Attempt& two) {
  ASSERT_EQ(one.run.has_value(), two.run.has_value());
  if (one.run) {
    EXPECT_EQ(one.run->increments.front().steps.front().u,
              two.run->increments.front().steps.front().u);
  } else {
    EXPECT_EQ(one.trouble->why, two.trouble->why);
  }
}

// Seeds: so many, and those that were hard once.
std::vector<unsigned> seeds() {
  std::vector<unsigned> all(test::full_size() ? 5000U : 60U);
  std::iota(all.begin(), all.end(), 1U);
  for (const unsigned hard : {741U, 1149U, 2022U, 2634U, 3008U, 4606U}) {
    if (hard > all.size()) {
      all.push_back(hard);
    }
  }
  return all;
}

TEST(RandomSolids, AreSolvedOrTheLooseBodyIsNamed) {
  unsigned solved = 0;
  unsigned named = 0;
  const testing::TestResult& found =
      *testing::UnitTest::GetInstance()->current_test_info()->result();
  for (const unsigned seed : seeds()) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const int before = found.total_part_count();
    const RandomStack stack = random_stack(seed);
    const Attempt one = attempt(stack.deck, 1);
    if (one.run) {
      ++solved;
      expect_conditions(one.run->increments.front().steps.front(), stack.weight);
    } else {
      ++named;
      expect_named(one.trouble);
    }
    if (seed % 10 == 0) { // the same, and the same bits, however many threads
      expect_same(one, attempt(stack.deck, 2));
    }
    if (found.total_part_count() > before) {
      std::printf("%s", stack.deck.c_str());
    }
  }
  std::printf("%u solved, %u with a loose body\n", solved, named);
  EXPECT_GT(solved, named);
}

// The largest difference of two answers: of displacements in parts of their norm, of pressures in
// parts of a hundred loads.
double difference_of(const results::LoadStepResult& a, const results::LoadStepResult& b,
                     double load) {
  double largest = (a.u - b.u).norm() / b.u.norm();
  for (std::size_t c = 0; c < a.contacts.size(); ++c) {
    const auto& one = a.contacts[c].points;
    const auto& two = b.contacts[c].points;
    for (std::size_t i = 0; i < one.size(); ++i) {
      largest =
          std::max(largest, std::abs(one[i].p_consistent - two[i].p_consistent) / (100.0 * load));
    }
  }
  return largest;
}

// Bodies that stay whole and bodies condensed to what rows weigh are the same bodies. With friction
// an answer may be one of several: nodes at the corner of floor and wall are in two pairs, which on
// coarse partners share their forces in many ways (manual, theory/solve.md). Then both are answers.
TEST(RandomSolids, AreTheSameWholeAndCondensed) {
  const unsigned tries = test::full_size() ? 1000U : 40U;
  unsigned compared = 0;
  unsigned several = 0;
  for (unsigned seed = 1; seed <= tries; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const RandomStack stack = random_stack(seed);
    const Attempt whole = attempt(stack.deck, 1);
    const Attempt small = attempt(stack.deck, 1, analysis::CondensationMode::to_freedoms);
    ASSERT_EQ(whole.run.has_value(), small.run.has_value());
    if (!whole.run) {
      const auto body = [](const Attempt& a) { // the direction has a sign of zero
        return a.trouble->why.substr(0, a.trouble->why.find(": direction"));
      };
      EXPECT_EQ(body(whole), body(small));
      continue;
    }
    ++compared;
    const results::LoadStepResult& a = whole.run->increments.front().steps.front();
    const results::LoadStepResult& b = small.run->increments.front().steps.front();
    const double difference = difference_of(a, b, stack.weight);
    if (difference > 1e-9 && stack.deck.find(" MU=") != std::string::npos &&
        stack.deck.find("NAME=SIDE") != std::string::npos) {
      ++several;
      expect_conditions(a, stack.weight);
      expect_conditions(b, stack.weight);
      EXPECT_LT((a.u - b.u).norm(), 1e-3 * b.u.norm());
    } else {
      EXPECT_LE(difference, 1e-9);
    }
  }
  std::printf("%u compared, %u with several answers\n", compared, several);
  EXPECT_GT(compared, tries / 2);
  EXPECT_LE(several, tries / 200);
}

} // namespace
} // namespace spricka::test_random_solids
