// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/place_on_front.hpp"
#include "tests/unit/support/integrated_life.hpp"
#include "tests/unit/support/solved_text.hpp"
#include "tests/unit/support/strip_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

/// Lives of decks by thresholds over R, and by laws at R < 0 as their names say.
namespace spricka::test_growth_thresholds {
namespace {

constexpr double pi = std::numbers::pi;

const std::string law = "LAW=NASGRO AMAX=8 C=1e-10 M=2.7 P=0.25 Q=1 KC=1500 ALPHA=2 SMAX=0.3 ";
const std::string over_ratio = "DK1=75 CTHP=1.21 CTHM=0.1 AINTRINSIC=0 ";

// Forman and Mettu 1992 with the threshold of NASGRO 4 for long cracks, R >= 0.
double nasgro_rate(double K, double R) {
  const double alpha = 2.0;
  const double S = 0.3;
  const double A0 =
      (0.825 - 0.34 * alpha + 0.05 * alpha * alpha) * std::pow(std::cos(0.5 * pi * S), 1.0 / alpha);
  const double A1 = (0.415 - 0.071 * alpha) * S;
  const double A3 = 2.0 * A0 + A1 - 1.0;
  const double A2 = 1.0 - A0 - A1 - A3;
  const double f = std::max(R, A0 + A1 * R + A2 * R * R + A3 * R * R * R);
  const double threshold =
      75.0 * std::pow((1.0 - R) / (1.0 - f), 1.0 + 1.21 * R) / std::pow(1.0 - A0, 1.21 * (1.0 - R));
  return 1e-10 * std::pow((1.0 - f) * K, 2.7) * std::pow(1.0 - threshold / ((1.0 - R) * K), 0.25) /
         (1.0 - K / 1500.0);
}

bool has_warning(const results::RunResult& run, const std::string& text) {
  return std::ranges::any_of(run.warnings, [&](const results::Warning& warning) {
    return warning.text.find(text) != std::string::npos;
  });
}

// At R = 0.5 the crack begins with a delta K of 121, above the threshold there, 112, and below that
// of R = 0, 179.
TEST(GrowthThresholds, ACrackGrowsByTheThresholdOfItsOwnR) {
  const auto solved = test::solve_text(test::strip_text("KMAX=FULL KMIN=HALF " + law + over_ratio));
  ASSERT_TRUE(solved && solved->run.growth);
  const results::GrowthResult& growth = *solved->run.growth;
  ASSERT_EQ(growth.ended, "AMAX") << growth.reason;
  EXPECT_NEAR(growth.final_cycles() / test::integrated_life(growth, nasgro_rate), 1.0, 1e-5);
  EXPECT_FALSE(has_warning(solved->run, "threshold"));

  // Short cracks have less of a threshold, and live shorter.
  const auto with_intrinsic = test::solve_text(
      test::strip_text("KMAX=FULL KMIN=HALF " + law + "DK1=75 CTHP=1.21 CTHM=0.1 AINTRINSIC=0.5"));
  ASSERT_TRUE(with_intrinsic && with_intrinsic->run.growth);
  EXPECT_LT(with_intrinsic->run.growth->final_cycles(), 0.99 * growth.final_cycles());
}

TEST(GrowthThresholds, AConstantOfAnotherRIsToldOf) {
  for (const std::string& rate : {law, std::string("LAW=PARIS AMAX=8 C=1e-11 M=3 ")}) {
    const auto solved =
        test::solve_text(test::strip_text("KMAX=FULL KMIN=HALF DKTH=179.2 " + rate));
    ASSERT_TRUE(solved && solved->run.growth);
    EXPECT_EQ(solved->run.growth->ended, "THRESHOLD");
    const std::string& reason = solved->run.growth->reason;
    EXPECT_NE(reason.find("R = 0.5, threshold 179.2 MPa*mm^0.5"), std::string::npos) << reason;
    EXPECT_TRUE(has_warning(solved->run, "DKTH is one threshold for all R: at a = 4 a cycle with "
                                         "R = 0.5"));
  }
  const auto at_zero = test::solve_text(
      test::strip_text("KMAX=FULL KMIN=ZERO LAW=PARIS AMAX=8 C=1e-11 M=3 DKTH=500"));
  ASSERT_TRUE(at_zero && at_zero->run.growth);
  EXPECT_EQ(at_zero->run.growth->ended, "THRESHOLD");
  EXPECT_FALSE(has_warning(at_zero->run, "threshold"));
}

// Every cycle of a spectrum has its own threshold: here all of them have R = 0.5.
TEST(GrowthThresholds, CyclesOfASpectrumHaveTheirOwn) {
  const std::string spectrum = "$LOADPATH NAME=UP FROM=ZERO TO=FULL\n"
                               "$SPECTRUM NAME=S PATH=UP TYPE=BLOCKS\n  0.5 1 1\n";
  const auto by_steps =
      test::solve_text(test::strip_text("KMAX=FULL KMIN=HALF " + law + over_ratio));
  const auto by_pass =
      test::solve_text(test::strip_text("SPECTRUM=S " + law + over_ratio, spectrum));
  const auto constant =
      test::solve_text(test::strip_text("SPECTRUM=S DKTH=179.2 " + law, spectrum));
  ASSERT_TRUE(by_steps && by_pass && constant && by_pass->run.growth && constant->run.growth);
  EXPECT_NEAR(by_pass->run.growth->final_cycles() / by_steps->run.growth->final_cycles(), 1.0,
              3e-3);
  EXPECT_EQ(constant->run.growth->ended, "THRESHOLD");
  EXPECT_TRUE(has_warning(constant->run, "DKTH is one threshold for all R"));
}

// Walker's law at R = -1, faces closed at the smallest load.
TEST(GrowthThresholds, WalkerAtNegativeRInADeck) {
  const std::string walker = "KMAX=FULL KMIN=LOW LAW=WALKER AMAX=8 C=1e-11 M=3 P=0.6 ";
  const auto life = [&](const std::string& more) {
    const auto solved =
        test::solve_text(test::strip_text(walker + more, "$STEP NAME=LOW\n  LOAD PULL -1\n"));
    return solved && solved->run.growth ? solved->run.growth->final_cycles() : 0.0;
  };
  const double as_zero = life("");
  ASSERT_GT(as_zero, 0.0);
  EXPECT_EQ(life("NEGATIVE=POSITIVE_PART"), as_zero);
  EXPECT_NEAR(life("NEGATIVE=WHOLE PM=0.2") / as_zero, std::pow(2.0, -0.6), 1e-3);
  EXPECT_NEAR(life("NEGATIVE=KMAX") / as_zero, std::pow(2.0, 1.2), 1e-3);
}

results::FrontResult front_of_arc(double a, double c, double from, double to) {
  results::FrontResult front;
  constexpr int points = 12;
  for (int i = 0; i <= points; ++i) {
    const double angle = from + (to - from) * i / points;
    results::FrontPointResult point;
    point.x = base::Vec3(c * std::cos(angle), a * std::sin(angle), 0.0);
    front.points.push_back(point);
  }
  return front;
}

TEST(PartThroughFronts, TurnBetweenTheirEnds) {
  EXPECT_TRUE(analysis::is_part_through(front_of_arc(1.0, 1.0, 0.0, pi)));        // surface
  EXPECT_TRUE(analysis::is_part_through(front_of_arc(1.0, 4.0, 0.0, pi)));        // shallow
  EXPECT_TRUE(analysis::is_part_through(front_of_arc(1.0, 1.5, 0.0, 0.5 * pi)));  // corner
  EXPECT_FALSE(analysis::is_part_through(front_of_arc(9.0, 9.0, 0.0, 0.1 * pi))); // through
  results::FrontResult loop = front_of_arc(9.0, 9.0, 0.0, 0.1 * pi);
  loop.is_loop = true;
  EXPECT_TRUE(analysis::is_part_through(loop));
}

} // namespace
} // namespace spricka::test_growth_thresholds
