// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

namespace spricka::test_load_history {
namespace {

// The strip of decks/friction_life.deck behind a clamped block: it feels the load behind a play of
// 0.4 (a rigid block on a floor that drags a spring: Prandtl's and Ishlinskii's play).
std::string strip(const std::string& loads, const std::string& mu = "0.2") {
  return "$DECK VERSION=1 LENGTH=mm FORCE=N\n"
         "$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=50 LY=10 NX=20 NY=4\n"
         "$ESET NAME=STRIP WHERE=(x < 40)\n"
         "$ESET NAME=BLOCKS WHERE=(x > 40)\n"
         "$NSET NAME=LINE WHERE=(abs(x) < 1e-9) ORDER=(y)\n"
         "$NSET NAME=MIDDLE WHERE=(abs(y) < 1e-9)\n"
         "$NSET NAME=CLAMPED WHERE=(abs(y-10) < 1e-9 and x > 39.999)\n"
         "$MATERIAL NAME=SOFT  E=2000 NU=0\n"
         "$MATERIAL NAME=STIFF E=2e8 NU=0\n"
         "$PROPERTY ESET=STRIP  MATERIAL=SOFT  STATE=STRAIN\n"
         "$PROPERTY ESET=BLOCKS MATERIAL=STIFF STATE=STRAIN\n"
         "$FREEDOM CLASS=SUPPRESSED DOF=X\n  LINE\n"
         "$FREEDOM CLASS=SUPPRESSED DOF=Y\n  MIDDLE\n"
         "$RIGID NAME=CLAMP SHAPE=LINE X0=60 Y0=10 X1=0 Y1=10\n"
         "$CONTACT NAME=GRIP SLAVE=CLAMPED MASTER=CLAMP INTERFERENCE=2.5e-6 MU=" +
         mu +
         "\n"
         "$CRACK NAME=C1 PATH=LINE A0=2\n"
         "$LOAD CASE=PULL TYPE=TRACTION\n  XMAX 50 0\n"
         "$STEP NAME=REST\n  LOAD PULL 0\n"
         "$STEP NAME=FULL SUBSTEPS=5\n  LOAD PULL 1\n" +
         loads + "$END\n";
}

// K of loads that are followed is that of the mesh: so is that of the map they are compared with.
std::string spectrum(const std::string& lines, const std::string& more = "") {
  return "$LOADPATH NAME=UP FROM=REST TO=FULL\n$SPECTRUM NAME=S PATH=UP " + lines +
         "$GROW LAW=PARIS SPECTRUM=S C=1e-11 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' AMAX=4 CORRECT=NO " +
         more + "\n";
}

const std::string pass = "TYPE=SEQUENCE\n  1 0.7 0.9 0.3 1 0\n";

double life(const std::string& deck) {
  const auto solved = test::solve_text(deck);
  if (!solved || !solved->run.growth) {
    return 0.0;
  }
  EXPECT_EQ(solved->run.growth->ended, "AMAX") << solved->run.growth->reason;
  EXPECT_TRUE(solved->run.warnings.empty()) << solved->run.warnings.front().text;
  return solved->run.growth->final_cycles();
}

// Without friction the strip feels 1, 0.7, 0.6 and 0.2 of the load; behind the play 0.6 and 0.3.
TEST(CyclicLoadHistorySolver, FrictionShutsSmallCyclesOut) {
  const double mapped = life(strip(spectrum(pass), "0"));
  const double followed = life(strip(spectrum(pass)));
  const double of_loads = 1.0 + std::pow(0.7, 3) + std::pow(0.2, 3);
  const double of_play = std::pow(0.6, 3) + std::pow(0.3, 3);
  EXPECT_NEAR(followed * of_play / (mapped * of_loads), 1.0, 1e-4);
}

TEST(CyclicLoadHistorySolver, NextToNoFrictionIsTheMap) {
  for (const std::string& loads : {pass, std::string("TYPE=BLOCKS\n  0.2 0.9 100.5\n  0 1 1\n"),
                                   std::string("TYPE=SEQUENCE\n 1 0.5 1 0.5 1 0.5 1 0\n")}) {
    const double mapped = life(strip(spectrum(loads), "0"));
    const double followed = life(strip(spectrum(loads), "1e-9"));
    EXPECT_NEAR(followed / mapped, 1.0, 1e-6) << loads;
  }
}

TEST(CyclicLoadHistorySolver, WhereAPassBeginsDoesNotMatter) {
  const double one = life(strip(spectrum(pass)));
  for (const char* turned : {"0.7 0.9 0.3 1 0 1", "0.3 1 0 1 0.7 0.9", "0 1 0.7 0.9 0.3 1"}) {
    const double other = life(strip(spectrum(fmt::format("TYPE=SEQUENCE\n  {}\n", turned))));
    EXPECT_NEAR(other / one, 1.0, 1e-6) << turned;
  }
}

// The same two turning points again and again are solved until they repeat, and then counted. The
// first cycle from 0.3 begins at what 0 has left behind: the strip feels 0.6 twice, 0.3 otherwise.
TEST(CyclicLoadHistorySolver, RunsOfASequenceAreBlocks) {
  std::string sequence = "TYPE=SEQUENCE\n";
  for (int k = 0; k < 500; ++k) {
    sequence += "  0.3 1\n";
  }
  const double one = life(strip(spectrum(sequence + "  0 1 0\n")));
  const double blocks = life(strip(spectrum("TYPE=BLOCKS\n  0.3 1 500\n  0 1 1\n")));
  EXPECT_NEAR(blocks / one, 1.0, 1e-6);
  const double mapped = life(strip(spectrum("TYPE=BLOCKS\n  0 1 1\n"), "0"));
  EXPECT_NEAR(blocks * (2.0 * std::pow(0.6, 3) + 499.0 * std::pow(0.3, 3)) / mapped, 1.0, 1e-4);
}

// From rest to full load the strip feels 0 to 0.8, from then on 0.2 to 0.8: the law must be given
// the second.
TEST(CyclicLoadHistorySolver, LawIsGivenTheCycleThatRepeats) {
  const auto solved = test::solve_text(strip(
      "$GROW LAW=PARIS KMAX=FULL KMIN=REST C=1e-11 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' AMAX=4\n"));
  ASSERT_TRUE(solved && solved->run.growth);
  const results::GrowthResult& growth = *solved->run.growth;
  EXPECT_TRUE(growth.followed);
  for (const results::GrowthStation& station : growth.stations) {
    const results::GrownPointResult& tip = station.points.front();
    EXPECT_NEAR(tip.first_min / tip.K_max, 0.0, 1e-4);
    EXPECT_NEAR(tip.first_max / tip.K_max, 1.0, 1e-9);
    EXPECT_NEAR(tip.K_min / tip.K_max, 0.25, 1e-3);
    EXPECT_NEAR(tip.rate / (1e-11 * std::pow(tip.K_max - tip.K_min, 3)), 1.0, 1e-9);
    EXPECT_EQ(station.passes, 2);
    EXPECT_LE(station.change, 1e-6);
  }
}

// A block that is stuck holds what it has stretched the strip by. As the crack grows the strip
// gives way, and its force falls with its compliance c,
//   s(a) c(a) = const,  dc/da = G / P^2,
// of a half model with two lines of symmetry; each length by itself would be pulled anew to 0.8.
TEST(CyclicLoadHistorySolver, HeldStretchFallsAsTheCrackGrows) {
  const std::string loads = "$STEP NAME=BACK SUBSTEPS=5\n  LOAD PULL 0.7\n"
                            "$LOAD CASE=INSIDE TYPE=FACES\n  C1 10\n"
                            "$STEP NAME=OPEN SUBSTEPS=2\n  LOAD INSIDE 1\n"
                            "$STEP NAME=SHUT SUBSTEPS=2\n  LOAD INSIDE 0\n"
                            "$GROW LAW=PARIS KMAX=OPEN KMIN=SHUT C=1e-11 M=3 KUNIT='MPa*mm^0.5' "
                            "AUNIT='mm' AMAX=4 HISTORY=";
  const auto carried = test::solve_text(strip(loads + "CONTINUE\n"));
  const auto anew = test::solve_text(strip(loads + "RESTART\n"));
  ASSERT_TRUE(carried && anew && carried->run.growth && anew->run.growth);
  const auto& stations = carried->run.growth->stations;
  ASSERT_GE(stations.size(), 4U);
  const double P = 0.8 * 50.0 * 10.0;
  const test::Solved& first = *carried;
  const base::NodeId end = first.node_at({50.0, 0.0, 0.0});
  const double stretch = first.vector(first.step(1).u, end).x();
  double c = stretch / P; // at the first length
  const double c0 = c;
  double before_G = 0.0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    // K under 0.8, pulled anew: KMIN of the steps of this length
    const results::LoadStepResult& shut = carried->run.increments[i].steps[4];
    const double K = shut.fronts.front().single_point().K1;
    const double G = K * K / 2000.0; // plane strain, nu = 0
    if (i > 0) {
      const double da = stations[i].points[0].a - stations[i - 1].points[0].a;
      c += 0.5 * da * (G + before_G) / (P * P);
    }
    before_G = G;
    EXPECT_NEAR(stations[i].points[0].K_min / K / (c0 / c), 1.0, 2e-3) << stations[i].points[0].a;
  }
  EXPECT_LT(c0 / c, 0.99); // there is something to see
  for (const results::GrowthStation& station : anew->run.growth->stations) {
    EXPECT_NEAR(station.points[0].K_min / station.points[0].first_min, 1.0, 1e-6);
  }
}

TEST(CyclicLoadHistorySolver, TooManyTurningPointsAreRefused) {
  std::string sequence = "TYPE=SEQUENCE\n";
  for (int k = 0; k < 1500; ++k) {
    sequence += fmt::format("  {} {}\n", 0.5 + 1e-4 * k, 0.1 + 1e-4 * k);
  }
  const test::Folder folder;
  const std::string refused = test::run_text(folder, strip(spectrum(sequence))).messages;
  EXPECT_NE(refused.find("E327"), std::string::npos) << refused;
  EXPECT_NE(refused.find("3000 turning points"), std::string::npos) << refused;
}

} // namespace
} // namespace spricka::test_load_history
