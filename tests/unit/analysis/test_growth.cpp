// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/integrated_life.hpp"
#include "tests/unit/support/solved_text.hpp"
#include "tests/unit/support/strip_text.hpp"

#include "analysis/lengths/path_correction.hpp"
#include "growth/trajectory.hpp"
#include "results/growth.hpp"
#include "tests/places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

namespace spricka::test_growth {
namespace {

constexpr double pi = std::numbers::pi;

// F of benchmark F01 at a/W = 0.3 and 0.4 (Kaya and Erdogan 1987).
double K_strip(double F, double a) {
  return F * 50.0 * std::sqrt(pi * a);
}

// With given lengths the two steps only name delta K: taken the wrong way round it is said.
TEST(Growth, ExchangedStepsOfGivenLengths) {
  for (const bool exchanged : {false, true}) {
    std::string deck = test::strip_text(exchanged ? "LAW=INCREMENT KMAX=HALF KMIN=FULL\n  4 6"
                                                  : "LAW=INCREMENT KMAX=FULL KMIN=HALF\n  4 6");
    const std::string units = "KUNIT='MPa*mm^0.5' AUNIT='mm' ";
    deck.erase(deck.find(units), units.size());
    const auto solved = test::solve_text(deck);
    ASSERT_TRUE(solved);
    std::string all;
    for (const results::LoadStepResult& step : solved->run.increments.back().steps) {
      for (const std::string& note : results::text_with_code(step.notes)) {
        all += note + "\n";
      }
    }
    EXPECT_EQ(all.find("exchanged") != std::string::npos, exchanged) << all;
  }
}

TEST(Growth, RatesAndEndOfALaw) {
  const auto solved =
      test::solve_text(test::strip_text("LAW=WALKER KMAX=FULL KMIN=HALF C=1e-11 M=3 P=0.5 AMAX=8"));
  ASSERT_TRUE(solved && solved->run.growth);
  const results::GrowthResult& growth = *solved->run.growth;
  EXPECT_EQ(growth.ended, "AMAX");
  EXPECT_EQ(growth.unit, "cycle");
  ASSERT_GE(growth.stations.size(), 3U);
  EXPECT_EQ(growth.stations.size(), solved->run.increments.size());
  const results::GrownPointResult& last = growth.stations.back().points[0];
  EXPECT_NEAR(last.a, 8.0, 1e-9);
  EXPECT_NEAR(last.K_max / K_strip(2.111413, 8.0), 1.0, 2e-3);
  EXPECT_NEAR(last.K_min / last.K_max, 0.5, 1e-9);
  // Walker: C (dK / (1 - R)^(1 - gamma))^m
  EXPECT_NEAR(last.rate / (1e-11 * std::pow(0.5 * last.K_max / std::sqrt(0.5), 3)), 1.0, 1e-9);
  EXPECT_DOUBLE_EQ(results::cycles_at_length(growth, 0, 8.0), growth.final_cycles());
  EXPECT_TRUE(std::isnan(results::cycles_at_length(growth, 0, 9.0)));
  EXPECT_LT(growth.error, 5e-3);
}

// Blocks of one cycle are constant amplitude; a spectrum of many levels is the sum of their rates.
TEST(Growth, SpectrumOfOneCycleIsConstantAmplitude) {
  const std::string law = "LAW=PARIS C=1e-11 M=3 AMAX=8 ";
  const auto steps = test::solve_text(test::strip_text(law + "KMAX=FULL KMIN=HALF"));
  const std::string path = "$LOADPATH NAME=UP FROM=ZERO TO=FULL\n";
  const auto blocks = test::solve_text(test::strip_text(
      law + "SPECTRUM=S", path + "$SPECTRUM NAME=S PATH=UP TYPE=BLOCKS\n  0.5 1 10\n"));
  const auto sequence = test::solve_text(test::strip_text(
      law + "SPECTRUM=S",
      path + "$SPECTRUM NAME=S PATH=UP TYPE=SEQUENCE FACTOR=0.1\n  5 10 5 7 6 10\n"));
  ASSERT_TRUE(steps && blocks && sequence);
  EXPECT_NEAR(10.0 * blocks->run.growth->final_cycles() / steps->run.growth->final_cycles(), 1.0,
              2e-3);
  EXPECT_EQ(blocks->run.growth->unit, "pass");
  EXPECT_DOUBLE_EQ(blocks->run.growth->cycles_per_pass, 10.0);
  // two cycles of half range, one of a tenth: 2 * 0.5^3 + 0.1^3
  EXPECT_NEAR(sequence->run.growth->final_cycles() * (2.0 * 0.125 + 0.001) /
                  (steps->run.growth->final_cycles() * 0.125),
              1.0, 2e-3);
}

// K of a load path has the errors taken out as K of steps has: bars of both ends of the path, and
// in a linear model a line between them.
TEST(Growth, CorrectedSpectrumOfOneCycleIsConstantAmplitude) {
  const std::string law = "LAW=PARIS C=1e-11 M=3 AMAX=8 ";
  const std::string path = "$LOADPATH NAME=UP FROM=ZERO TO=FULL\n";
  const auto rates = [&](const std::string& grow, const std::string& cards) {
    const auto solved = test::solve_text(test::strip_text(law + grow, cards));
    std::vector<double> found;
    for (const results::GrowthStation& station : solved->run.growth->stations) {
      found.push_back(station.points[0].K_max);
    }
    return found;
  };
  const std::vector<double> steps = rates("KMAX=FULL KMIN=HALF", "");
  const std::vector<double> plain = rates("KMAX=FULL KMIN=HALF CORRECT=NO", "");
  const std::vector<double> spectrum =
      rates("SPECTRUM=S", path + "$SPECTRUM NAME=S PATH=UP TYPE=BLOCKS\n  0.5 1 10\n");
  ASSERT_FALSE(steps.empty());
  EXPECT_GT(std::abs(plain[0] / steps[0] - 1.0), 1e-6); // there is something to correct
  EXPECT_NEAR(spectrum[0] / steps[0], 1.0, 1e-9);
}

// The error goes with K, and with t where K turns back; faces that touch have none.
TEST(Growth, ErrorOfKBetweenTheEndsOfAPath) {
  using base::PiecewiseLinear;
  const auto line =
      analysis::correct_K(PiecewiseLinear({0.0, 2.0}, {10.0}, {30.0}), {{0.0, 1.0}, {1.0, 4.0}});
  for (const double t : {0.0, 0.5, 1.0, 2.0}) {
    EXPECT_NEAR(line(t), 10.0 + 30.0 * t + 1.0 + 3.0 * t, 1e-12);
  }
  // Open from t = 0.5 on.
  const auto opens = analysis::correct_K(PiecewiseLinear({0.0, 0.5, 1.0}, {0.0, 0.0}, {0.0, 20.0}),
                                         {{0.0, 0.0}, {1.0, 1.0}});
  EXPECT_EQ(opens(0.25), 0.0);
  EXPECT_NEAR(opens(0.75), 5.0 + 0.5, 1e-12);
  EXPECT_NEAR(opens(1.0), 10.0 + 1.0, 1e-12);
  const auto turns = analysis::correct_K(PiecewiseLinear({0.0, 0.5, 1.0}, {10.0, 6.0}, {-8.0, 8.2}),
                                         {{0.0, 1.0}, {1.0, 2.0}});
  EXPECT_NEAR(turns(0.5), 6.0 + 1.5, 1e-12);
  EXPECT_NEAR(turns(1.0), 10.1 + 2.0, 1e-12);
  // Next to level between the ends, steep beyond: by K the error would be 1e4 times K.
  const auto level = analysis::correct_K(
      PiecewiseLinear({0.0, 1.0, 2.0}, {10.0, 10.00001}, {1e-5, 5.0}), {{0.0, 0.0}, {1.0, 1.0}});
  EXPECT_NEAR(level(2.0), 15.00001 + 2.0, 1e-9);
  // From t = 0.5 on another error than that which goes with K from the beginning.
  const auto bears =
      analysis::correct_K(PiecewiseLinear({0.0, 0.5, 1.0}, {10.0, 4.0}, {-12.0, -4.0}),
                          {{0.0, 1.0}, {0.5, 0.4}, {1.0, -0.2}});
  EXPECT_NEAR(bears(0.25), 7.0 + 0.7, 1e-12);
  EXPECT_NEAR(bears(0.75), 3.0 + 0.1, 1e-12);
  EXPECT_NEAR(bears(1.0), 2.0 - 0.2, 1e-12);
}

TEST(Growth, EndsWhereKReachesTheToughness) {
  const double K_c = K_strip(1.659866, 6.0); // at a/W = 0.3
  const auto solved = test::solve_text(
      test::strip_text(fmt::format("LAW=FORMAN KMAX=FULL KMIN=ZERO C=1e-9 M=3 KC={}", K_c)));
  ASSERT_TRUE(solved && solved->run.growth);
  EXPECT_EQ(solved->run.growth->ended, "KC");
  EXPECT_NEAR(solved->run.growth->curve.back().a[0], 6.0, 0.02);
}

// By statics the ligament carries s W across it and s W a/2 about its middle.
TEST(Growth, EndsAtThePlasticLimitOfTheLigament) {
  const double flow = 300.0;
  const auto part = [&](double a) {
    const double c = 20.0 - a;
    const double n = 50.0 * 20.0 / (flow * c);
    const double m = 4.0 * 50.0 * 20.0 * 0.5 * a / (flow * c * c);
    return 0.5 * (m + std::sqrt(m * m + 4.0 * n * n));
  };
  double low = 4.0;
  double high = 20.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (part(middle) < 1.0 ? low : high) = middle;
  }
  const auto solved = test::solve_text(
      test::strip_text(fmt::format("LAW=PARIS KMAX=FULL KMIN=ZERO C=1e-11 M=3 SFLOW={}", flow)));
  ASSERT_TRUE(solved && solved->run.growth);
  EXPECT_EQ(solved->run.growth->ended, "NET SECTION");
  EXPECT_NEAR(solved->run.growth->curve.back().a[0] / low, 1.0, 1e-3);
}

TEST(Growth, BelowTheThresholdNothingGrows) {
  const auto solved =
      test::solve_text(test::strip_text("LAW=PARIS KMAX=FULL KMIN=ZERO C=1e-11 M=3 DKTH=10000"));
  ASSERT_TRUE(solved && solved->run.growth);
  EXPECT_EQ(solved->run.growth->ended, "THRESHOLD");
  EXPECT_EQ(solved->run.growth->final_cycles(), 0.0);
}

// Through the whole strip, along the nodes of its path.
TEST(Growth, ReachesTheFarEdge) {
  const auto solved =
      test::solve_text(test::strip_text("LAW=PARIS KMAX=FULL KMIN=ZERO C=1e-11 M=3"));
  ASSERT_TRUE(solved && solved->run.growth);
  EXPECT_EQ(solved->run.growth->ended, "EDGE");
  EXPECT_NE(solved->run.growth->reason.find("XMAX"), std::string::npos)
      << solved->run.growth->reason;
  EXPECT_GT(solved->run.growth->curve.back().a[0], 19.5);
}

// A slant crack inside a plate under tension along y turns across the tension; both arms alike.
std::string slant(double da, const std::string& direction) {
  return fmt::format(
      "$DECK VERSION=1 LENGTH=mm FORCE=N\n"
      "$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-40 Y0=-40 LX=80 LY=80 NX=20 NY=20\n"
      "$MATERIAL NAME=M E=70000 NU=0.3\n"
      "$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS\n"
      "$NSET NAME=A WHERE=(abs(x+40) < 1e-9 and abs(y) < 1e-9)\n"
      "$NSET NAME=B WHERE=(abs(x-40) < 1e-9 and abs(y) < 1e-9)\n"
      "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  A\n"
      "$FREEDOM CLASS=SUPPRESSED DOF=Y\n  B\n"
      "$LOAD CASE=PULL TYPE=TRACTION\n  YMAX 0 50\n  YMIN 0 -50\n"
      "$STEP NAME=ZERO\n  LOAD PULL 0\n$STEP NAME=FULL\n  LOAD PULL 1\n"
      "$CRACK NAME=C\n  -4 -3\n  4 3\n"
      "$GROW LAW=PARIS DIRECTION={} KMAX=FULL KMIN=ZERO C=1e-11 M=3 KUNIT='MPa*mm^0.5' "
      "AUNIT='mm' AMAX=12 DA={}\n"
      "$END\n",
      direction, da);
}

TEST(Growth, PathDoesNotDependOnTheAdvance) {
  for (const std::string direction : {"HOOP", "K2ZERO"}) {
    std::vector<base::Vec3> end;
    for (const double da : {1.5, 0.75}) {
      const auto solved = test::solve_text(slant(da, direction));
      ASSERT_TRUE(solved && solved->run.growth);
      ASSERT_EQ(solved->run.growth->ended, "AMAX") << solved->run.growth->reason;
      const results::GrowthStation& last = solved->run.growth->stations.back();
      end.push_back(last.points[1].x);
      EXPECT_NEAR((last.points[0].x + last.points[1].x).norm(), 0.0, 0.05); // point symmetry
      EXPECT_LT(std::abs(last.points[1].K2_max), 0.03 * last.points[1].K_max);
    }
    EXPECT_LT((end[1] - end[0]).norm(), 0.005 * 7.0) << direction; // 7: what each arm has grown
  }
}

// The deck's crack is drawn into its hole; half the advance moves the path by less than 0.5 %.
TEST(Growth, PathIntoAHole) {
  std::vector<std::vector<base::Vec3>> path;
  for (const std::string da : {"3", "1.5"}) {
    std::string deck = test::slurp(test::decks_folder() + "/hole_path.deck");
    const auto put = [&](const std::string& old, const std::string& now) {
      const std::size_t at = deck.find(old);
      ASSERT_NE(at, std::string::npos) << old;
      deck.replace(at, old.size(), now);
    };
    put("plate_hole.geo", test::decks_folder() + "/plate_hole.geo");
    put("da = 3", "da = " + da);
    const auto solved = test::solve_text(deck);
    ASSERT_TRUE(solved && solved->run.growth);
    EXPECT_EQ(solved->run.growth->ended, "EDGE");
    EXPECT_NE(solved->run.growth->reason.find("HOLE"), std::string::npos);
    const double life = test::integrated_life(
        *solved->run.growth, [](double K, double R) { return 1e-11 * std::pow((1.0 - R) * K, 3); });
    EXPECT_NEAR(solved->run.growth->final_cycles() / life, 1.0, 1e-5);
    std::vector<base::Vec3>& x = path.emplace_back();
    for (const results::GrowthStation& station : solved->run.growth->stations) {
      x.push_back(station.points.front().x);
    }
  }
  double apart = 0.0;
  for (const base::Vec3& x : path[0]) {
    double least = 1e300;
    for (std::size_t i = 1; i < path[1].size(); ++i) {
      const base::Vec3 way = path[1][i] - path[1][i - 1];
      const double t = std::clamp((x - path[1][i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (x - path[1][i - 1] - t * way).norm());
    }
    apart = std::max(apart, least);
  }
  EXPECT_LT(apart, 0.005 * 36.0); // what the crack grows
}

// Six tips on a line: the long crack meets a short one; left and right are alike.
TEST(Growth, CracksOnALineLinkUp) {
  const auto solved = test::solve_text(test::slurp(test::decks_folder() + "/link_up.deck"));
  ASSERT_TRUE(solved && solved->run.growth);
  const results::GrowthResult& growth = *solved->run.growth;
  EXPECT_EQ(growth.ended, "LINK-UP");
  ASSERT_EQ(growth.point_names.size(), 6U);
  const std::vector<double>& a = growth.curve.back().a; // LONG.1 .2, EAST.1 .2, WEST.1 .2
  EXPECT_NEAR(a[0] / a[1], 1.0, 1e-3);
  EXPECT_NEAR(a[2] / a[5], 1.0, 1e-3);
  EXPECT_NEAR(a[3] / a[4], 1.0, 1e-3);
  EXPECT_GT(a[2], a[3]);                      // the inner tips see the long crack
  EXPECT_LT(10.0 - (a[2] - 2.0) - a[1], 0.2); // what is left between
}

// The life on the lug when K of every load is known, and when one K is scaled with the load or laid
// through press fit and full load (ratios: prototype with node pairs, reduced model of the lug).
TEST(Growth, OneScaledKIsWrongOnTheLug) {
  const std::string deck = "$DECK VERSION=1 LENGTH=mm FORCE=N\n"
                           "$INCLUDE FILE='" +
                           test::decks_folder() +
                           "/lug_model.inc'\n"
                           "$CONTACT NAME=BUSH SLAVE=SLEEVE.OUTER MASTER=LUG.BORE DIAMETRAL=0.084\n"
                           "$CONTACT NAME=PIN  SLAVE=SHAFT.OUTER  MASTER=SLEEVE.INNER GAP=0\n"
                           "$STEP NAME=PRESS\n  FIT BUSH 1\n"
                           "$STEP NAME=LOAD\n  LOAD SHAFTLOAD 1\n"
                           "$LOADPATH NAME=UP FROM=PRESS TO=LOAD\n"
                           "$SPECTRUM NAME=S PATH=UP TYPE=BLOCKS\n  0 1 1\n"
                           "$CRACK NAME=TOP NET=LUG A0=(0.05*R) ANGLE=90[deg] STATE=STRESS\n"
                           "  0 (R)\n"
                           "$GROW LAW=PARIS SPECTRUM=S C=1e-13 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' "
                           "AMAX=(0.8*R)\n$END\n";
  const auto solved = test::solve_text(deck);
  ASSERT_TRUE(solved && solved->run.growth);
  ASSERT_EQ(solved->run.growth->ended, "AMAX") << solved->run.growth->reason;
  using Range = std::function<double(const base::PiecewiseLinear&)>;
  const auto life = [&](const Range& range) {
    std::vector<growth::SolvedStation> stations;
    for (const results::CrackLengthResult& increment : solved->run.increments) {
      growth::TipStation tip;
      tip.a = increment.a;
      tip.K_max = range(increment.paths.front().fronts.front().single_point().K[0]);
      stations.push_back({increment.a, {tip}});
    }
    const growth::GrowthTrajectory between(
        stations, [](double K, double, const model::PlaceOnCrack&) { return 1e-13 * K * K * K; },
        4);
    return between.cycles(stations.front().s, stations.back().s);
  };
  const double exact = life([](const auto& K) { return K(1.0) - K(0.0); });
  EXPECT_NEAR(solved->run.growth->final_cycles() / exact, 1.0, 2e-3);
  const double scaled = life([](const auto& K) { return K(1.0); });
  EXPECT_NEAR(exact / scaled / 4.03, 1.0, 0.02);
  const double exact_half = life([](const auto& K) { return K(1.0) - K(0.5); });
  const double secant = life([](const auto& K) { return 0.5 * (K(1.0) - K(0.0)); });
  EXPECT_NEAR(secant / exact_half / 3.70, 1.0, 0.02);
}

} // namespace
} // namespace spricka::test_growth
