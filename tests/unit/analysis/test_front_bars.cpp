// SPDX-License-Identifier: GPL-3.0-or-later
// Error bars of K along fronts against closed forms: do they hold, and are they tight?
#include "tests/places.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_front_bars {
namespace {

constexpr double nu = 0.3;
constexpr double counts_from = 1e-3; // errors of this part of the largest K count for the width

using Exact = std::function<std::array<double, 3>(const std::string& step, double phi)>;

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

struct Tally {
  int all = 0, inside = 0, large = 0, tight = 0;
  double error = 0.0, best = 0.0; ///< squares, of the largest K

  Tally& operator+=(const Tally& t) {
    all += t.all;
    inside += t.inside;
    large += t.large;
    tight += t.tight;
    error += t.error;
    best += t.best;
    return *this;
  }
};

Tally tally_of(const results::StepResult& step, const Exact& exact) {
  Tally tally;
  const results::FrontResult& front = step.fronts.front();
  EXPECT_EQ(front.no_bar, "");
  double size = 0.0;
  for (const results::FrontPointResult& place : front.points) {
    size = std::max(size, std::hypot(place.K1, place.K2, place.K3));
  }
  for (const results::FrontPointResult& place : front.points) {
    if (place.at_surface) {
      continue;
    }
    const std::array<double, 3> truth = exact(step.step, place.phi);
    const std::array<double, 3> K{place.K1, place.K2, place.K3};
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = std::abs(truth[k] - K[k]);
      const double bar = place.bar[k].size();
      tally.all += 1;
      tally.inside += error <= bar ? 1 : 0;
      if (error > counts_from * size) {
        tally.large += 1;
        tally.tight += error <= bar && bar <= 3.0 * error ? 1 : 0;
      }
      tally.error += std::pow(error / size, 2);
      tally.best += std::pow((truth[k] - place.bar[k].best) / size, 2);
    }
  }
  return tally;
}

Tally tally_of(const test::Solved& solved, const Exact& exact) {
  Tally tally;
  for (const results::StepResult& step : solved.run.increments.front().steps) {
    tally += tally_of(step, exact);
  }
  return tally;
}

void expect_good(const Tally& t) {
  std::printf("%d of %d inside, %d of %d within 1 to 3, rms error %.3f %%, of best %.3f %%\n",
              t.inside, t.all, t.tight, t.large, 100.0 * std::sqrt(t.error / t.all),
              100.0 * std::sqrt(t.best / t.all));
  EXPECT_GE(t.inside, 0.95 * t.all);
  EXPECT_GE(t.tight, 0.8 * t.large);
  EXPECT_LT(t.best, t.error / 4.0);
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
  EXPECT_LT(t.best, t.error / 16.0); // what is left is the mesh's: its estimate knows it
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

// A block between walls all round with a penny, and a hot spot of width w at x, y, z. With the body
// force beta grad T nothing moves and the stress is -beta T: K is that of this pressure on the
// faces.
std::string hot_spot(double w, const base::Vec3& x, const std::string& type) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  beta = 1000*1e-3/(1-2*0.3)
  w = {0}
  x0 = {1}
  y0 = {2}
  z0 = {3}
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE={4} X0=-2 Y0=-2 Z0=-2 LX=4 LY=4 LZ=4 NX=4 NY=4 NZ=4
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3 ALPHA=1e-3
$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=X
  B.XMIN B.XMAX
$FREEDOM CLASS=SUPPRESSED DOF=Y
  B.YMIN B.YMAX
$FREEDOM CLASS=SUPPRESSED DOF=Z
  B.ZMIN B.ZMAX
$CRACK NAME=C NET=B A=0.8 C=0.8 X0=0 Y0=0 Z0=0 NORMAL=Z FACES=FREE
$LOAD CASE=HEAT TYPE=TEMPERATURE
  B.BODY (-exp(-((x-x0)^2+(y-y0)^2+(z-z0)^2)/w^2))
$LOAD CASE=HEAT TYPE=BODY
  B.BODY (2*beta*(x-x0)/w^2*exp(-((x-x0)^2+(y-y0)^2+(z-z0)^2)/w^2))
       & (2*beta*(y-y0)/w^2*exp(-((x-x0)^2+(y-y0)^2+(z-z0)^2)/w^2))
       & (2*beta*(z-z0)/w^2*exp(-((x-x0)^2+(y-y0)^2+(z-z0)^2)/w^2))
$LOAD CASE=FACES TYPE=FACES
  C (beta*exp(-((x-x0)^2+(y-y0)^2+(z-z0)^2)/w^2))
$STEP NAME=HEAT
  LOAD HEAT 1
$STEP NAME=FACES
  LOAD HEAT 0
  LOAD FACES 1
$END
)",
                     w, x.x(), x.y(), x.z(), type);
}

// The best value of the pressed faces is the truth.
Tally tally_of_hot_spot(const std::string& deck) {
  const auto solved = test::solve_text(deck);
  EXPECT_TRUE(solved);
  const auto& steps = solved->run.increments.front().steps;
  const std::vector<results::FrontPointResult>& pressed = steps.back().fronts.front().points;
  return tally_of(steps.front(), [&](const std::string&, double phi) {
    const auto same = std::ranges::find_if(
        pressed, [&](const results::FrontPointResult& place) { return place.phi == phi; });
    return std::array{same->bar[0].best, same->bar[1].best, same->bar[2].best};
  });
}

// A strip with an edge crack of 0.3 of its width, in the plane or as a slice of it between planes
// that hold it; `loads`: TRACTION and TEMPERATURE with {} for a third component.
std::string strip(double thickness, const std::string& loads) {
  const bool space = thickness > 0.0;
  std::string deck = fmt::format(
      R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=P
  $MESH SHAPE=BLOCK TYPE={} X0=0 Y0=-2 LX=1 LY=4 {} NX=12 NY=32
  $NSET NAME=P1 WHERE=(abs(x-1) < 1e-9 and abs(y+2) < 1e-9)
  $NSET NAME=P2 WHERE=(abs(x-1) < 1e-9 and abs(y-2) < 1e-9)
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3 ALPHA=1e-5
$PROPERTY ESET=P.BODY MATERIAL=M STATE={}
$FREEDOM CLASS=SUPPRESSED DOF=XY
  P.P1
$FREEDOM CLASS=SUPPRESSED DOF=X
  P.P2
)",
      space ? "HEXEC20" : "QUAMC8", space ? fmt::format("LZ={} NZ=1", thickness) : "",
      space ? "SOLID" : "STRAIN");
  if (space) {
    deck += fmt::format("$FREEDOM CLASS=SUPPRESSED DOF=Z\n  P.ZMIN P.ZMAX\n"
                        "$CRACK NAME=C NET=P X0=0.15 Y0=0 Z0={}\n  0.3 0 2\n  0.3 0 -1\n",
                        0.5 * thickness);
  } else {
    deck += "$CRACK NAME=C NET=P\n  0 0\n  0.3 0\n$TIPNET CRACK=C TOL=0.0005\n";
  }
  return deck + fmt::format(fmt::runtime(loads), space ? "0" : "") +
         "$STEP NAME=S\n  LOAD T 1\n$END\n";
}

// K1 of a slice against the best of the plane.
Tally tally_of_slice(double thickness, const std::string& loads) {
  const auto plane = test::solve_text(strip(0.0, loads));
  const auto slice = test::solve_text(strip(thickness, loads));
  EXPECT_TRUE(plane && slice);
  const results::FrontPointResult& tip = plane->step().fronts.front().tip();
  const double sign =
      tip.bar[1].best * slice->step().fronts.front().points[1].K2 < 0.0 ? -1.0 : 1.0;
  return tally_of(*slice, [&](const std::string&, double) {
    return std::array{tip.bar[0].best, sign * tip.bar[1].best, 0.0};
  });
}

constexpr const char* hot_strip =
    "$LOAD CASE=T TYPE=TEMPERATURE\n"
    "  P.BODY (1000*exp(-((x-0.35)^2+y^2)/0.2^2))\n"
    "$LOAD CASE=T TYPE=TRACTION\n  P.YMAX 0 1 {0}\n  P.YMIN 0 -1 {0}\n";
constexpr const char* sheared_strip =
    "$LOAD CASE=T TYPE=TRACTION\n  P.YMAX 0.5 2 {0}\n  P.YMIN -0.5 -2 {0}\n"
    "  P.XMAX 0 0.5 {0}\n  P.XMIN 0 -0.5 {0}\n";

TEST(FrontErrorBars, HotSpotAheadOfAFrontInASlice) {
  const Tally t = tally_of_slice(0.25, hot_strip);
  EXPECT_GE(t.inside, 0.95 * t.all);
  EXPECT_LT(std::sqrt(t.best / t.all), 1e-3);
}

TEST(FrontErrorBars, ThinSlicesByChance) {
  if (!test::full_size()) {
    GTEST_SKIP() << "at full size; a slice: HotSpotAheadOfAFrontInASlice";
  }
  Tally all;
  for (const double thickness : {0.02, 0.03, 0.05, 0.08, 0.12, 0.2, 0.3}) {
    const Tally t = tally_of_slice(thickness, sheared_strip);
    std::printf("%g thick: %d of %d inside, rms error %.3f %%\n", thickness, t.inside, t.all,
                100.0 * std::sqrt(t.error / t.all));
    all += t;
  }
  EXPECT_GE(all.inside, 0.95 * all.all);
}

TEST(FrontErrorBars, HotSpotsByChance) {
  if (!test::full_size()) {
    GTEST_SKIP() << "at full size; one of them: HotSpotAheadOfAFrontInASlice";
  }
  std::mt19937 dice(3);
  const auto chance = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(dice);
  };
  Tally all;
  for (int i = 0; i < 8; ++i) {
    const double w = 0.15 * std::pow(6.0, i / 7.0);
    const double phi = chance(0.0, 6.28);
    const double r = chance(0.3, 0.8);
    const base::Vec3 x(r * std::cos(phi), r * std::sin(phi), chance(-0.2, 0.2));
    const Tally t = tally_of_hot_spot(hot_spot(w, x, i % 2 == 0 ? "TET10" : "HEXEC20"));
    std::printf("w = %.3g: %d of %d inside, rms error %.3f %%\n", w, t.inside, t.all,
                100.0 * std::sqrt(t.error / t.all));
    all += t;
  }
  EXPECT_GE(all.inside, 0.95 * all.all);
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
