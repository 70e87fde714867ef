// SPDX-License-Identifier: GPL-3.0-or-later
// Error bars of K where loads bend within elements near a front: hot spots and thin slices.
#include "bar_tally.hpp"
#include "tests/places.hpp"

#include <algorithm>
#include <random>

#include <fmt/format.h>

namespace spricka::test_local_load_bars {
namespace {

using test::Tally;
using test::tally_of;

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
  const results::FrontPointResult& tip = plane->step().fronts.front().single_point();
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

TEST(LocalLoadBars, HotSpotAheadOfAFrontInASlice) {
  const Tally t = tally_of_slice(0.25, hot_strip);
  EXPECT_GE(t.inside, 0.95 * t.all);
  EXPECT_LT(std::sqrt(t.error / t.all), 1e-3);
}

TEST(LocalLoadBars, ThinSlicesByChance) {
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

TEST(LocalLoadBars, HotSpotsByChance) {
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

} // namespace
} // namespace spricka::test_local_load_bars
