// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/integrated_life.hpp"
#include "tests/unit/support/solved_text.hpp"
#include "tests/unit/support/strip_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

/// Lives of decks against an integration of their own K(a) that shares no code with the program,
/// and ends of a growth that no other test comes to.
namespace spricka::test_growth_laws {
namespace {

constexpr double pi = std::numbers::pi;

std::string strip(const std::string& grow, const std::string& path = "LINE") {
  return test::strip_text("KMAX=FULL KMIN=HALF " + grow, "", path);
}

// Forman and Mettu 1992 with Newman's opening function (1984), R >= 0.
TEST(GrowthLaws, NasgroInADeck) {
  const double C = 1e-10;
  const double m = 2.7;
  const double p = 0.5;
  const double q = 0.3;
  const double Kc = 1500.0;
  const double threshold = 60.0;
  const double alpha = 1.8;
  const double S = 0.35;
  const auto solved = test::solve_text(
      strip(fmt::format("LAW=NASGRO C={} M={} P={} Q={} KC={} DKTH={} ALPHA={} SMAX={} AMAX=8", C,
                        m, p, q, Kc, threshold, alpha, S)));
  ASSERT_TRUE(solved && solved->run.growth);
  ASSERT_EQ(solved->run.growth->ended, "AMAX");
  const auto rate = [&](double K, double R) {
    const double A0 = (0.825 - 0.34 * alpha + 0.05 * alpha * alpha) *
                      std::pow(std::cos(0.5 * pi * S), 1.0 / alpha);
    const double A1 = (0.415 - 0.071 * alpha) * S;
    const double A3 = 2.0 * A0 + A1 - 1.0;
    const double A2 = 1.0 - A0 - A1 - A3;
    const double f = std::max(R, A0 + A1 * R + A2 * R * R + A3 * R * R * R);
    const double range = (1.0 - R) * K;
    return C * std::pow((1.0 - f) / (1.0 - R) * range, m) * std::pow(1.0 - threshold / range, p) /
           std::pow(1.0 - K / Kc, q);
  };
  EXPECT_NEAR(solved->run.growth->final_cycles() / test::integrated_life(*solved->run.growth, rate),
              1.0, 1e-5);
}

// KC and DKTH count in KUNIT, as C does; with a unit of their own they are what they say, in an
// expression too.
TEST(GrowthLaws, AllConstantsAreInTheUnitsOfTheLaw) {
  const auto life = [](const std::string& constants, const std::string& more) {
    std::string deck =
        test::strip_text("KMAX=FULL KMIN=HALF LAW=FORMAN AMAX=8 TOL=1e-2 M=3 " + constants, more);
    const std::string own = "KUNIT='MPa*mm^0.5' AUNIT='mm' ";
    deck.erase(deck.find(own), own.size());
    const auto solved = test::solve_text(deck);
    return solved && solved->run.growth ? solved->run.growth->final_cycles() : 0.0;
  };
  const double metre = std::sqrt(1000.0);
  const std::string in_mm =
      fmt::format("C={:.17g} KC={:.17g} DKTH={:.17g} KUNIT='MPa*mm^0.5' AUNIT='mm'",
                  2e-9 * 1e3 / (metre * metre), 40.0 * metre, 2.0 * metre);
  const double wanted = life(in_mm, "");
  ASSERT_GT(wanted, 0.0);
  const std::string units = " KUNIT='MPa*sqrt(m)' AUNIT='m'";
  EXPECT_NEAR(life("C=2e-9 KC=40 DKTH=2" + units, "") / wanted, 1.0, 1e-9);
  EXPECT_NEAR(life("C=2e-9 KC=40[MPa*m^0.5] DKTH=2000[kPa*m^0.5]" + units, "") / wanted, 1.0, 1e-9);
  const std::string parameters = "$PARAMETER\n  k = 20[MPa*m^0.5]\n  two = 2*k\n  bare = 40\n";
  EXPECT_NEAR(life("C=2e-9 KC=(two) DKTH=(k/10)" + units, parameters) / wanted, 1.0, 1e-9);
  EXPECT_NEAR(life("C=2e-9 KC=(bare) DKTH=(bare/20)" + units, parameters) / wanted, 1.0, 1e-9);
}

// Rows with a bend within the ranges that occur; the last is straight on beyond its end.
TEST(GrowthLaws, TableInADeck) {
  const auto solved =
      test::solve_text(strip("LAW=TABLE AMAX=8\n  60 1e-7\n  150 4e-6\n  260 1e-5"));
  ASSERT_TRUE(solved && solved->run.growth);
  const auto rate = [](double K, double R) {
    const double range = (1.0 - R) * K;
    const bool first = range < 150.0;
    const double slope =
        first ? std::log(40.0) / std::log(2.5) : std::log(2.5) / std::log(26.0 / 15.0);
    return 4e-6 * std::pow(range / 150.0, slope);
  };
  const results::GrowthResult& growth = *solved->run.growth;
  const auto& first = growth.stations.front().points[0];
  const auto& last = growth.stations.back().points[0];
  EXPECT_LT(first.K_max - first.K_min, 150.0);
  EXPECT_GT(last.K_max - last.K_min, 150.0);
  EXPECT_NEAR(growth.final_cycles() / test::integrated_life(growth, rate), 1.0, 1e-5);
}

// The same life by name; cycles outside the data of the law are counted.
TEST(GrowthLaws, ByNameWithTheCyclesOutsideItsData) {
  const auto run = [](const std::string& data) {
    std::string deck = test::strip_text(
        "KMAX=FULL KMIN=HALF AMAX=8 MATERIAL=SHEET",
        "$LAW NAME=SHEET TYPE=PARIS C=1e-11 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' " + data + "\n");
    const std::string on_grow = "KUNIT='MPa*mm^0.5' AUNIT='mm' ";
    deck.erase(deck.rfind(on_grow), on_grow.size());
    return test::solve_text(deck);
  };
  const auto warning = [](const results::RunResult& result) {
    const auto found = std::ranges::find(result.warnings, "W576", &results::Warning::code);
    return found == result.warnings.end() ? std::string() : found->text;
  };
  const auto within = run("DKMIN=100 DKMAX=400 RMIN=0 RMAX=0.5");
  const auto beyond = run("DKMAX=170");
  const auto ratio = run("RMAX=0.4");
  const auto plain = test::solve_text(strip("LAW=PARIS C=1e-11 M=3 AMAX=8"));
  ASSERT_TRUE(within && beyond && ratio && plain && within->run.growth && beyond->run.growth);
  const results::GrowthResult& growth = *beyond->run.growth;
  EXPECT_EQ(growth.final_cycles(), plain->run.growth->final_cycles());
  EXPECT_EQ(within->run.growth->law_use.outside, 0.0);
  EXPECT_EQ(warning(within->run), "");
  EXPECT_EQ(warning(plain->run), "");
  EXPECT_DOUBLE_EQ(ratio->run.growth->law_use.outside, 1.0);
  EXPECT_NE(warning(ratio->run).find("100 % at R above 0.4 (up to 0.5)"), std::string::npos)
      << warning(ratio->run);
  // the cycles from the length on whose delta K is 170
  const auto next = std::ranges::find_if(growth.stations, [](const results::GrowthStation& at) {
    return at.points[0].K_max - at.points[0].K_min > 170.0;
  });
  ASSERT_TRUE(next != growth.stations.begin() && next != growth.stations.end());
  const double whole = growth.final_cycles();
  EXPECT_GE(growth.law_use.outside, 1.0 - next->cycles / whole);
  EXPECT_LE(growth.law_use.outside, 1.0 - std::prev(next)->cycles / whole);
  EXPECT_GT(growth.law_use.growth_outside, growth.law_use.outside); // these are the fast ones
  EXPECT_NE(warning(beyond->run).find("delta K above 170 (up to "), std::string::npos)
      << warning(beyond->run);
}

// Between two columns of R = 0 and 0.6 the program integrates what they lead to at R = 0.5.
TEST(GrowthLaws, TableOverRatiosInADeck) {
  const auto solved = test::solve_text(
      strip("LAW=TABLE AMAX=8\n  RATIO 0 0.6\n  1e-7 60 40\n  4e-6 150 110\n  1e-4 400 250"));
  ASSERT_TRUE(solved && solved->run.growth);
  const double part = std::log(0.5) / std::log(0.4);
  const auto column = [&](double left, double right) {
    return std::log(left) + part * std::log(right / left);
  };
  const std::array k{column(60.0, 40.0), column(150.0, 110.0), column(400.0, 250.0)};
  const std::array r{std::log(1e-7), std::log(4e-6), std::log(1e-4)};
  const auto rate = [&](double K, double R) {
    const double x = std::log((1.0 - R) * K);
    const std::size_t i = x < k[1] ? 0 : 1;
    return std::exp(r[i] + (x - k[i]) / (k[i + 1] - k[i]) * (r[i + 1] - r[i]));
  };
  const results::GrowthResult& growth = *solved->run.growth;
  EXPECT_NEAR(growth.final_cycles() / test::integrated_life(growth, rate), 1.0, 1e-5);
}

// The crack goes along the edges of the deck's elements as far as its PATH does.
TEST(GrowthLaws, PathThatRunsOutEndsTheGrowth) {
  const auto solved = test::solve_text(strip("LAW=PARIS C=1e-11 M=3", "PART"));
  const auto whole = test::solve_text(strip("LAW=PARIS C=1e-11 M=3 AMAX=8"));
  ASSERT_TRUE(solved && whole && solved->run.growth && whole->run.growth);
  const results::GrowthResult& growth = *solved->run.growth;
  EXPECT_EQ(growth.ended, "PATH END") << growth.reason;
  EXPECT_NEAR(growth.curve.back().a[0], 8.0, 0.02 * 8.0);
  EXPECT_LE(growth.curve.back().a[0], 8.0 + 1e-9);
  const double a = std::min(growth.curve.back().a[0], whole->run.growth->curve.back().a[0]);
  EXPECT_NEAR(results::cycles_at_length(growth, 0, a) /
                  results::cycles_at_length(*whole->run.growth, 0, a),
              1.0, 2e-3);
}

// A plate under tension, cracked from below; when the load is on, a strap is bonded to its upper
// side. Kept from the first length on, it takes load as the crack grows.
std::string strapped(const std::string& grow, const std::string& y = "0",
                     const std::string& angle = "90[deg]") {
  return "$DECK VERSION=1 LENGTH=mm FORCE=N\n"
         "$NET NAME=PLATE\n  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=4 NX=20 NY=8\n$ENDNET\n"
         "$NET NAME=STRAP\n  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=3 Y0=4 LX=4 LY=1 NX=7 NY=2\n$ENDNET\n"
         "$MATERIAL NAME=M E=1000 NU=0.3\n"
         "$PROPERTY ESET=PLATE.BODY MATERIAL=M STATE=STRESS\n"
         "$PROPERTY ESET=STRAP.BODY MATERIAL=M STATE=STRESS\n"
         "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  PLATE.XMIN\n"
         "$CONTACT NAME=GLUE SLAVE=STRAP.YMIN MASTER=PLATE.YMAX TYPE=BONDED GAP=0\n"
         "$CRACK NAME=C NET=PLATE A0=1 ANGLE=" +
         angle + "\n  5  " + y +
         "\n$LOAD CASE=PULL TYPE=TRACTION\n  PLATE.XMAX 1 0\n"
         "$STEP NAME=LOAD\n  LOAD PULL 1\n"
         "$STEP NAME=FIX\n  MOUNT GLUE\n"
         "$STEP NAME=LESS\n  LOAD PULL 0.5\n"
         "$GROW " +
         grow + "\n$END\n";
}

// What a law is given is K of the strap that was bonded before the crack grew: that of the same
// lengths given one by one, below that of a strap bonded at each.
TEST(GrowthLaws, MountedAtTheFirstLength) {
  const std::string law = "LAW=WALKER KUNIT='MPa*mm^0.5' AUNIT='mm' P=0.5 KMAX=FIX KMIN=LESS "
                          "C=1e-4 M=3 AMAX=1.8 MOUNTED=";
  const auto first = test::solve_text(strapped(law + "FIRST"));
  const auto each = test::solve_text(strapped(law + "EACH"));
  ASSERT_TRUE(first && each && first->run.growth && each->run.growth);
  const results::GrowthResult& growth = *first->run.growth;
  std::string lengths = "LAW=INCREMENT KMAX=FIX MOUNTED=FIRST\n ";
  for (const results::GrowthStation& station : growth.stations) {
    lengths += fmt::format(" {:.17g}", station.points[0].a);
  }
  const auto listed = test::solve_text(strapped(lengths));
  ASSERT_TRUE(listed);
  ASSERT_EQ(listed->run.increments.size(), growth.stations.size());
  for (std::size_t i = 0; i < growth.stations.size(); ++i) {
    const results::GrownPointResult& tip = growth.stations[i].points[0];
    const auto& steps = listed->run.increments[i].steps;
    EXPECT_NEAR(tip.K_max / steps[1].fronts[0].single_point().K1, 1.0, 1e-6) << tip.a;
    EXPECT_NEAR(tip.K_min / steps[2].fronts[0].single_point().K1, 1.0, 1e-6) << tip.a;
    if (i > 0) { // bonded anew the strap bears nothing of the full load
      EXPECT_LT(tip.K_max / steps[0].fronts[0].single_point().K1, 1.0 - 1e-3);
    }
  }
  const auto rate = [](double K, double R) {
    return 1e-4 * std::pow((1.0 - R) * K / std::pow(1.0 - R, 0.5), 3);
  };
  EXPECT_NEAR(growth.final_cycles() / test::integrated_life(growth, rate), 1.0, 1e-5);
  // the same strap in both: the range is the same, the mean is not
  EXPECT_GT(growth.final_cycles(), 1.003 * each->run.growth->final_cycles());
}

// Where the crack opens into the strap's own seat its rows are others at the next length: what was
// taken on at the first cannot be kept. The growth ends there, and the cycles are no life.
TEST(GrowthLaws, AdvanceThatCannotBeSolvedEndsTheGrowth) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(
      folder,
      strapped("LAW=PARIS KMAX=FIX KMIN=LESS C=1e-4 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' AMAX=1.8 "
               "MOUNTED=FIRST",
               "4", "-90[deg]"));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.messages.find("MOUNTED=FIRST"), std::string::npos) << outcome.messages;
  const std::string life = test::slurp(folder.path() / "out" / "life.csv");
  EXPECT_NE(life.find("ended: MESH"), std::string::npos) << life;
  EXPECT_EQ(test::column(folder.path() / "out" / "life.csv", "a").size(), 1U);
}

} // namespace
} // namespace spricka::test_growth_laws
