// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/integrated_life.hpp"
#include "tests/unit/support/pinned_ring.hpp"
#include "tests/unit/support/solved_text.hpp"
#include "tests/unit/support/strip_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

/// Lives under loads that close the crack: the law is given the K_min that its authors mean.
namespace spricka::test_negative_ratio {
namespace {

constexpr double pi = std::numbers::pi;

const std::string nasgro = "LAW=NASGRO C=1e-10 M=2.7 P=0.5 Q=0.3 KC=1500 DKTH=60 ALPHA=1.8 "
                           "SMAX=0.35 AMAX=8 TOL=1e-2 ";

// Forman and Mettu 1992 with Newman's opening function (1984) at R < 0, written out once more.
double forman_mettu(double K, double R) {
  const double alpha = 1.8;
  const double S = 0.35;
  const double A0 =
      (0.825 - 0.34 * alpha + 0.05 * alpha * alpha) * std::pow(std::cos(0.5 * pi * S), 1.0 / alpha);
  const double A1 = (0.415 - 0.071 * alpha) * S;
  const double f = A0 + A1 * std::max(R, -2.0);
  return 1e-10 * std::pow((1.0 - f) / (1.0 - R) * (1.0 - R) * K, 2.7) *
         std::pow(1.0 - 60.0 / K, 0.5) / std::pow(1.0 - K / 1500.0, 0.3);
}

std::string strip(const std::string& grow, double r, const std::string& more = "") {
  return test::strip_text(grow, fmt::format("$STEP NAME=LOW\n  LOAD PULL {}\n", r) + more);
}

std::string with_free_faces(std::string deck) {
  const std::string own = "A0=4";
  return deck.replace(deck.find(own), own.size(), own + " FACES=FREE");
}

// Under its one load all faces close at once: K goes through 0 with the load.
TEST(NegativeRatio, NasgroIsGivenTheKThatGoesOnBelowClosing) {
  for (const double R : {-0.5, -1.0, -2.0, -3.0}) {
    const std::string deck = strip(nasgro + "KMAX=FULL KMIN=LOW", R);
    const auto solved = test::solve_text(deck);
    const auto free = test::solve_text(with_free_faces(deck));
    ASSERT_TRUE(solved && free && solved->run.growth && free->run.growth);
    const results::GrowthResult& growth = *solved->run.growth;
    ASSERT_EQ(growth.ended, "AMAX");
    for (const results::GrowthStation& station : growth.stations) {
      EXPECT_NEAR(station.points[0].K_min / station.points[0].K_max, R, 1e-6 * std::abs(R));
    }
    EXPECT_NEAR(growth.final_cycles() / test::integrated_life(growth, forman_mettu), 1.0, 1e-5)
        << R;
    EXPECT_NEAR(growth.final_cycles() / free->run.growth->final_cycles(), 1.0, 1e-6) << R;
    EXPECT_TRUE(solved->run.increments.front().steps.back().fronts[0].single_point().closed);
    EXPECT_TRUE(solved->run.warnings.empty()) << solved->run.warnings.front().text;
    EXPECT_TRUE(free->run.warnings.empty()) << free->run.warnings.front().text;
  }
}

// By their own rule these take R < 0 for R = 0.
TEST(NegativeRatio, OtherLawsCountItAsZero) {
  for (const std::string law : {"LAW=WALKER C=1e-11 M=3 P=0.5", "LAW=FORMAN C=1e-9 M=3 KC=1500",
                                "LAW=PARIS C=1e-11 M=3", "LAW=TABLE DKTH=30"}) {
    const std::string grow = law + " TOL=1e-2 AMAX=8 KMAX=FULL KMIN=LOW" +
                             (law.starts_with("LAW=TABLE") ? "\n  60 1e-7\n  150 4e-6" : "");
    const auto below = test::solve_text(strip(grow, -1.0));
    const auto zero = test::solve_text(strip(grow, 0.0));
    ASSERT_TRUE(below && zero && below->run.growth && zero->run.growth) << law;
    EXPECT_NEAR(below->run.growth->final_cycles() / zero->run.growth->final_cycles(), 1.0, 1e-6)
        << law;
    const double K_min = below->run.growth->stations.front().points[0].K_min;
    const double K_max = below->run.growth->stations.front().points[0].K_max;
    EXPECT_NEAR(K_min / K_max, law.starts_with("LAW=WALKER") ? -1.0 : 0.0, 1e-6) << law;
  }
}

// A pass of cycles that close the crack, from an exact map, against the sum of their rates.
TEST(NegativeRatio, SpectrumWithCompression) {
  const std::string path = "$LOADPATH NAME=UP FROM=LOW TO=FULL\n";
  const std::string blocks = path + "$SPECTRUM NAME=S PATH=UP TYPE=BLOCKS\n"
                                    "  0 1 3\n  0.25 0.75 10\n  0.6 1 5\n  0 0.5 7\n";
  const std::string sequence =
      path + "$SPECTRUM NAME=S PATH=UP TYPE=SEQUENCE\n  0 1 0.25 0.75 0.1 0.9\n";
  // t = 0: -1, t = 1: 1
  const auto rate = [](double low, double high) {
    return [=](double K, double) {
      const double top = (2.0 * high - 1.0) * K;
      const double R = (2.0 * low - 1.0) / (2.0 * high - 1.0);
      if (!(top > 0.0)) {
        return 0.0;
      }
      if (R < 0.0) {
        return top > 60.0 ? forman_mettu(top, R) : 0.0;
      }
      const double alpha = 1.8;
      const double S = 0.35;
      const double A0 = (0.825 - 0.34 * alpha + 0.05 * alpha * alpha) *
                        std::pow(std::cos(0.5 * pi * S), 1.0 / alpha);
      const double A1 = (0.415 - 0.071 * alpha) * S;
      const double A3 = 2.0 * A0 + A1 - 1.0;
      const double f = std::max(R, A0 + R * (A1 + R * (1.0 - A0 - A1 - A3 + R * A3)));
      const double range = (1.0 - R) * top;
      return range > 60.0
                 ? 1e-10 * std::pow((1.0 - f) * top, 2.7) * std::pow(1.0 - 60.0 / range, 0.5) /
                       std::pow(1.0 - top / 1500.0, 0.3)
                 : 0.0;
    };
  };
  const std::string grow = nasgro + "SPECTRUM=S";
  const auto counted = test::solve_text(strip(grow, -1.0, blocks));
  const auto followed = test::solve_text(strip(grow, -1.0, sequence));
  ASSERT_TRUE(counted && followed && counted->run.growth && followed->run.growth);
  for (const results::GrowthStation& station : counted->run.growth->stations) {
    const results::GrownPointResult& tip = station.points[0];
    const double K = tip.K_max;
    EXPECT_NEAR(tip.K_min / K, -1.0, 1e-6);
    EXPECT_NEAR(tip.rate / (3.0 * rate(0, 1)(K, 0) + 10.0 * rate(0.25, 0.75)(K, 0) +
                            5.0 * rate(0.6, 1)(K, 0)),
                1.0, 1e-6);
  }
  for (const results::GrowthStation& station : followed->run.growth->stations) {
    const double K = station.points[0].K_max; // 0-1, and 0.25-0.75 within 0.1-0.9
    EXPECT_NEAR(station.points[0].rate /
                    (rate(0, 1)(K, 0) + rate(0.25, 0.75)(K, 0) + rate(0.1, 0.9)(K, 0)),
                1.0, 1e-6);
  }
}

// A ring that a loose pin pulls to one side and pushes to the other, where it closes the crack.
TEST(NegativeRatio, CrackThatAPinCloses) {
  const auto ring = [](const std::string& faces) {
    std::string deck =
        test::pinned_ring({.hub_rings = 3, .sectors = 24, .crack_at = 115.0},
                          "$STEP NAME=UP\n  LOAD PULL 1\n"
                          "$STEP NAME=DOWN\n  LOAD PULL -2\n"
                          "$GROW KMAX=UP KMIN=DOWN LAW=NASGRO C=1e-10 M=2.7 P=0.5 "
                          "Q=0.3 KC=1500 DKTH=60 ALPHA=1.8 SMAX=0.35 AMAX=12 TOL=1e-2 "
                          "KUNIT='MPa*mm^0.5' AUNIT='mm'\n");
    deck.replace(deck.find("INTERFERENCE=0.01"), 17, "GAP=0");
    return deck.insert(deck.find(" A0=8"), faces);
  };
  const auto touching = test::solve_text(ring(""));
  const auto free = test::solve_text(ring(" FACES=FREE"));
  ASSERT_TRUE(touching && free && touching->run.growth && free->run.growth);
  const results::GrowthResult& growth = *touching->run.growth;
  EXPECT_LT(growth.stations.back().points[0].K_min, -0.03 * growth.stations.back().points[0].K_max);
  EXPECT_NEAR(growth.final_cycles() / free->run.growth->final_cycles(), 1.0, 1e-6);
  EXPECT_NEAR(growth.final_cycles() / test::integrated_life(growth, forman_mettu), 1.0, 1e-4);
}

// Next to no friction elsewhere, so that loads are followed one after another: the same lives.
TEST(NegativeRatio, LoadsThatAreFollowed) {
  const std::string rigid = "$NSET NAME=SIDE WHERE=(abs(x-20) < 1e-9 and y > 30)\n"
                            "$RIGID NAME=WALL SHAPE=LINE X0=20 Y0=20 X1=20 Y1=60\n"
                            "$CONTACT NAME=RUB SLAVE=SIDE MASTER=WALL GAP=1 MU=1e-6\n";
  // K of followed loads is that of the mesh.
  const std::string raw = nasgro + "CORRECT=NO ";
  const std::string steps = raw + "KMAX=FULL KMIN=LOW";
  const std::string pass = "$LOADPATH NAME=UP FROM=LOW TO=FULL\n"
                           "$SPECTRUM NAME=S PATH=UP TYPE=BLOCKS\n  0 1 3\n  0.25 0.75 10\n";
  for (const auto& [grow, more] :
       {std::pair(steps, std::string()), std::pair(raw + "SPECTRUM=S", pass)}) {
    const auto map = test::solve_text(strip(grow, -1.0, more));
    const auto followed = test::solve_text(strip(grow, -1.0, rigid + more));
    ASSERT_TRUE(map && followed && map->run.growth && followed->run.growth);
    EXPECT_NEAR(followed->run.growth->final_cycles() / map->run.growth->final_cycles(), 1.0, 2e-4);
    EXPECT_NEAR(followed->run.growth->stations[0].points[0].K_min /
                    map->run.growth->stations[0].points[0].K_min,
                1.0, 1e-6);
  }
}

} // namespace
} // namespace spricka::test_negative_ratio
