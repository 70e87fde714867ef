// SPDX-License-Identifier: GPL-3.0-or-later
// Error bars of K along fronts against closed forms: do they hold, and are they tight?
#include "bar_tally.hpp"
#include "tests/places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_front_bars {
namespace {

using test::Exact;
using test::expect_good;
using test::Tally;
using test::tally_of;

constexpr double nu = 0.3;
// An ellipse in a large block under tension, shear and bending (decks/penny_solid.deck,
// decks/ellipse_solid.deck).
std::string buried(double a, double c, double half, const std::string& tip) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  L = {2}
  c = {1}
$NET NAME=BODY
  $MESH SHAPE=BLOCK TYPE=TET10 X0=(-L) Y0=(-L) Z0=(-L) LX=(2*L) LY=(2*L) LZ=(2*L) NX=4 NY=4 NZ=4
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY.BODY MATERIAL=M STATE=SOLID
$NSET NAME=P1 WHERE=(x < -L + 1e-6 and y < -L + 1e-6 and z < -L + 1e-6)
$NSET NAME=P2 WHERE=(x > L - 1e-6 and y < -L + 1e-6 and z < -L + 1e-6)
$NSET NAME=P3 WHERE=(x < -L + 1e-6 and y > L - 1e-6 and z < -L + 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  P1
$FREEDOM CLASS=SUPPRESSED DOF=YZ
  P2
$FREEDOM CLASS=SUPPRESSED DOF=Z
  P3
$CRACK NAME=C1 NET=BODY A={0} C={1} X0=0 Y0=0 Z0=0 NORMAL=Z
{3}
$LOAD CASE=PULL TYPE=TRACTION
  BODY.ZMAX  0 0 1
  BODY.ZMIN  0 0 -1
$LOAD CASE=SHEAR TYPE=TRACTION
  BODY.ZMAX  1 0 0
  BODY.ZMIN  -1 0 0
  BODY.XMAX  0 0 1
  BODY.XMIN  0 0 -1
$LOAD CASE=BEND TYPE=TRACTION
  BODY.ZMAX  0 0 (x/c)
  BODY.ZMIN  0 0 (-x/c)
$STEP NAME=PULL
  LOAD PULL 1
$STEP NAME=BOTH
  LOAD {4} 1
$END
)",
                     a, c, half, tip, a == c ? "SHEAR" : "BEND");
}

// Sneddon 1946, Segedin 1951.
std::array<double, 3> penny(const std::string& step, double phi) {
  const double shear = step == "BOTH" ? 4.0 / (2.0 - nu) / std::sqrt(std::numbers::pi) : 0.0;
  return {2.0 / std::sqrt(std::numbers::pi), shear * std::cos(phi),
          (1.0 - nu) * shear * std::sin(phi)};
}

// Irwin 1962, and under a linear stress (references of decks/ellipse_solid.deck): semi-axes a and
// 1, the second along x.
Exact ellipse(double a) {
  const auto D = [a](double f) { return std::hypot(std::cos(f), std::sin(f) / a); };
  double I0 = 0.0;
  double Ic = 0.0;
  constexpr int n = 2000;
  for (int i = 0; i < n; ++i) {
    const double f = 2.0 * std::numbers::pi * i / n;
    I0 += D(f) * 2.0 * std::numbers::pi / n;
    Ic += D(f) * std::pow(std::cos(f), 2) * 2.0 * std::numbers::pi / n;
  }
  return [=](const std::string& step, double phi) -> std::array<double, 3> {
    const double bend = step == "BOTH" ? 4.0 * std::cos(phi) / (3.0 * Ic) : 0.0;
    return {std::sqrt(std::numbers::pi * D(phi)) * (4.0 / I0 + bend), 0.0, 0.0};
  };
}

void put(std::string& deck, const std::string& from, const std::string& to) {
  deck.replace(deck.find(from), from.size(), to);
}

// An ellipse with semi-axes a and 1 under tension and bending in a host of hexahedra, by chance
// where in it and how many these are. A linear stress passes where tetrahedra meet them.
std::string in_hexahedra(double a, const std::string& tip, std::mt19937& dice) {
  const auto chance = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(dice);
  };
  std::string deck = buried(a, 1.0, 20.0, tip);
  const double x0 = chance(-3.0, 3.0);
  put(deck, "TYPE=TET10", "TYPE=HEXEC20");
  put(deck, "NX=4 NY=4 NZ=4",
      fmt::format("NX={:.0f} NY={:.0f} NZ={:.0f}", chance(2.6, 5.4), chance(2.6, 5.4),
                  chance(2.6, 5.4)));
  put(deck, "X0=0 Y0=0 Z0=0",
      fmt::format("X0={} Y0={} Z0={}", x0, chance(-3.0, 3.0), chance(-3.0, 3.0)));
  put(deck, "(x/c)", fmt::format("(x-({}))", x0));
  put(deck, "(-x/c)", fmt::format("({}-x)", x0));
  if (a == 1.0) {
    put(deck, "LOAD SHEAR 1", "LOAD BEND 1");
  }
  return deck;
}

void judge(const std::string& deck, const Exact& exact) {
  const auto solved = test::solve_text(deck);
  ASSERT_TRUE(solved);
  expect_good(tally_of(*solved, exact));
}

TEST(FrontErrorBars, PennyUnderTensionAndShear) {
  judge(buried(1.0, 1.0, 20.0, ""), penny);
}

TEST(FrontErrorBars, PennyWithASmallTube) {
  if (!test::full_size()) {
    GTEST_SKIP() << "at full size; bars of a penny: PennyUnderTensionAndShear";
  }
  judge(buried(1.0, 1.0, 20.0, "$TIPNET CRACK=C1 RADIUS=0.12"), penny);
}

TEST(FrontErrorBars, PennyWithFewSectors) {
  if (!test::full_size()) {
    GTEST_SKIP() << "at full size; bars of a penny: PennyUnderTensionAndShear";
  }
  judge(buried(1.0, 1.0, 20.0, "$TIPNET CRACK=C1 SECTORS=6"), penny);
}

TEST(FrontErrorBars, EllipseUnderTensionAndBending) {
  judge(buried(0.5, 1.0, 20.0, ""), ellipse(0.5));
}

TEST(FrontErrorBars, PennyInHexahedraUnderALinearStress) {
  std::mt19937 dice(1);
  const auto solved = test::solve_text(in_hexahedra(1.0, "$TIPNET CRACK=C1 FINER=0.9", dice));
  ASSERT_TRUE(solved);
  const Tally t = tally_of(*solved, ellipse(1.0));
  EXPECT_GE(t.inside, 0.95 * t.all);
  EXPECT_LT(t.error, t.raw / 16.0); // what is left is the mesh's: its estimate knows it
}

TEST(FrontErrorBars, CracksInHexahedraUnderALinearStress) {
  if (!test::full_size()) {
    GTEST_SKIP() << "at full size; one of them: PennyInHexahedraUnderALinearStress";
  }
  std::mt19937 dice(2);
  Tally all;
  for (int i = 0; i < 12; ++i) {
    const double a = i % 2 == 0 ? 1.0 : 0.5;
    const std::string tip = fmt::format("$TIPNET CRACK=C1 FINER={:.2f}", 0.8 + 0.03 * i);
    const auto solved = test::solve_text(in_hexahedra(a, tip, dice));
    ASSERT_TRUE(solved);
    all += tally_of(*solved, ellipse(a));
  }
  expect_good(all);
}

// A block between walls that becomes colder, the more so the larger x is: the walls pull by
// E alpha (1 + x) = 1 + x, and the sides are free.
TEST(FrontErrorBars, PennyInABlockThatCoolsBetweenWalls) {
  std::string deck = buried(1.0, 1.0, 20.0, "");
  const auto replace = [&](const std::string& from, const std::string& to) { put(deck, from, to); };
  replace("E=1000 NU=0.3", "E=1000 NU=0.3 ALPHA=1e-3");
  replace("DOF=XYZ\n  P1", "DOF=XY\n  P1");
  replace("DOF=YZ\n  P2", "DOF=Y\n  P2");
  replace("DOF=Z\n  P3", "DOF=Z\n  BODY.ZMIN BODY.ZMAX");
  const std::size_t loads = deck.find("$LOAD");
  deck.replace(loads, std::string::npos,
               "$LOAD CASE=COLD TYPE=TEMPERATURE\n  BODY.BODY  (-1-x)\n"
               "$STEP NAME=COLD\n  LOAD COLD 1\n$END\n");
  judge(deck, [](const std::string&, double phi) -> std::array<double, 3> {
    return {(2.0 + 4.0 / 3.0 * std::cos(phi)) / std::sqrt(std::numbers::pi), 0.0, 0.0};
  });
}

// Half a penny under shear: x = 0 is held along y and z, where the whole one is antisymmetric.
TEST(FrontErrorBars, HalfAPennyThatEndsOnAPlaneOfAntisymmetry) {
  std::string deck = buried(1.0, 1.0, 12.0, "$TIPNET CRACK=C1 FINER=0.8");
  put(deck, "X0=(-L)", "X0=0");
  put(deck, "LX=(2*L)", "LX=(L)");
  put(deck, "NX=4", "NX=2");
  put(deck, "P1 WHERE=(x < -L + 1e-6", "P1 WHERE=(x < 1e-6");
  put(deck, "DOF=XYZ\n  P1", "DOF=X\n  P1");
  put(deck, "DOF=YZ\n  P2", "DOF=YZ\n  BODY.XMIN");
  put(deck, "$FREEDOM CLASS=SUPPRESSED DOF=Z\n  P3\n", "");
  put(deck, "$NSET NAME=P3 WHERE=(x < -L + 1e-6", "$NSET NAME=P3 WHERE=(x < 1e-6");
  put(deck, "  BODY.XMIN  0 0 -1\n", "");
  put(deck, "$STEP NAME=PULL\n  LOAD PULL 1\n", "");
  const auto solved = test::solve_text(deck);
  ASSERT_TRUE(solved);
  const results::FrontResult& front = solved->step().fronts.front();
  const double k = penny("BOTH", 0.0)[1];
  ASSERT_TRUE(front.points.front().at_surface && front.points.back().at_surface);
  for (const results::FrontPointResult& place : front.points) {
    const std::array<double, 3> truth = penny("BOTH", place.phi);
    EXPECT_NEAR(place.K3, truth[2], 0.02 * k);
    if (!place.at_surface) {
      EXPECT_NEAR(place.K1, 0.0, 0.01 * k);
      EXPECT_NEAR(place.K2, truth[1], 0.02 * k);
    }
  }
}

} // namespace
} // namespace spricka::test_front_bars
