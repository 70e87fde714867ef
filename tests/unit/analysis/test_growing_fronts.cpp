// SPDX-License-Identifier: GPL-3.0-or-later
// What laws are given along fronts in space.
#include "tests/places.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace spricka::test_growing_fronts {
namespace {

// A bar with a penny across it, whose right end, much stiffer, glides between a floor and a plane
// that presses on it; without `mu` it is free.
std::string clamped_bar(const std::string& mu, const std::string& more) {
  const std::string clamp =
      mu.empty() ? std::string()
                 : "$RIGID NAME=CLAMP SHAPE=PLANE X0=0 Y0=6 Z0=0 X1=0 Y1=0 Z1=0\n"
                   "$CONTACT NAME=GRIP SLAVE=CLAMPED MASTER=CLAMP INTERFERENCE=3e-4 MU=" +
                       mu + "\n";
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=BAR
  $MESH SHAPE=BLOCK TYPE=TET10 X0=-6 Y0=0 Z0=-3 LX=15 LY=6 LZ=6 NX=5 NY=2 NZ=2
$ENDNET
$ESET NAME=STRIP WHERE=(x < 6)
$ESET NAME=BLOCKS WHERE=(x > 6)
$NSET NAME=FLOOR WHERE=(abs(y) < 1e-9 and x > 6 - 1e-9)
$NSET NAME=CLAMPED WHERE=(abs(y-6) < 1e-9 and x > 6 - 1e-9)
$MATERIAL NAME=SOFT  E=2000 NU=0
$MATERIAL NAME=STIFF E=2e5 NU=0
$PROPERTY ESET=STRIP  MATERIAL=SOFT  STATE=SOLID
$PROPERTY ESET=BLOCKS MATERIAL=STIFF STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  BAR.XMIN
$FREEDOM CLASS=SUPPRESSED DOF=Y
  FLOOR
$CRACK NAME=C1 NET=BAR A=1 X0=0 Y0=3 Z0=0 NORMAL=X
$LOAD CASE=PULL TYPE=TRACTION
  BAR.XMAX  50 0 0
)" + clamp +
         "$STEP NAME=REST\n  LOAD PULL 0.1\n$STEP NAME=HALF\n  LOAD PULL 0.5\n"
         "$STEP NAME=FULL SUBSTEPS=2\n  LOAD PULL 1\n" +
         more + "$END\n";
}

// Over with the first front, which is all that is looked at.
std::string grow(const std::string& keys) {
  return "$GROW LAW=PARIS SHAPE=ELLIPSE C=1e-9 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' KC=10 " + keys +
         "\n";
}

std::string spectrum(const std::string& keys, const std::string& cycles) {
  return "$LOADPATH NAME=UP FROM=REST TO=FULL\n$SPECTRUM NAME=S PATH=UP TYPE=BLOCKS\n  " + cycles +
         "\n" + grow("SPECTRUM=S " + keys);
}

results::GrowthResult growth_of(const std::string& deck) {
  const auto solved = test::solve_text(deck);
  if (!solved || !solved->run.growth) {
    ADD_FAILURE() << "no growth";
    return {};
  }
  return *solved->run.growth;
}

// Loads followed one after another, friction next to none, are the map of K over the load.
TEST(GrowingFronts, NextToNoFrictionIsTheMap) {
  const results::GrowthResult mapped =
      growth_of(clamped_bar("0", spectrum("CORRECT=NO", "0.3 0.9 7")));
  const results::GrowthResult followed = growth_of(clamped_bar("1e-9", spectrum("", "0.3 0.9 7")));
  ASSERT_FALSE(mapped.stations.empty() || followed.stations.empty());
  EXPECT_GE(followed.stations[0].passes, 1);
  for (std::size_t i = 0; i < mapped.stations[0].points.size(); ++i) {
    const results::GrownPointResult& map = mapped.stations[0].points[i];
    const results::GrownPointResult& tip = followed.stations[0].points.at(i);
    EXPECT_NEAR(tip.K_max / map.K_max, 1.0, 1e-6);
    EXPECT_NEAR(tip.K_min / map.K_min, 1.0, 1e-6);
    EXPECT_NEAR(tip.rate / map.rate, 1.0, 3e-6);
    // Pulled by 0.1 where the path begins, and pressed together by what the fit widens the block.
    EXPECT_NEAR(tip.K_min / tip.K_max, (0.1 + 0.3 * 0.9) / (0.1 + 0.9 * 0.9), 2e-4);
  }
}

// What the clamp holds is missing at the largest load, and left behind at the smallest: KMAX and
// KMIN of a bar that was pulled by so much more than friction holds.
TEST(GrowingFronts, CyclesThatRepeatBehindAClamp) {
  const results::GrowthResult free =
      growth_of(clamped_bar("0", grow("KMAX=FULL KMIN=REST CORRECT=NO")));
  const results::GrowthResult held = growth_of(clamped_bar("0.1", grow("KMAX=FULL KMIN=REST")));
  ASSERT_FALSE(held.stations.empty());
  const results::GrownPointResult& at = held.stations[0].points.at(0);
  const double whole = free.stations.at(0).points.at(0).K_max;
  // Pressed by E e / h = 2e5 * 3e-4 / 6 = 10 on 3 x 6: 18 of the 1800 pull.
  EXPECT_NEAR(at.K_max / whole, 1.0 - 0.01, 1e-3);
  EXPECT_NEAR(at.K_min / whole, 0.1 + 0.01, 1e-3);
  EXPECT_NEAR(at.first_min / whole, 0.1 - 0.01, 1e-3); // pulled up to there
}

// K of a load path has the errors taken out as K of steps has.
TEST(GrowingFronts, CorrectedSpectrumOfOneCycleIsConstantAmplitude) {
  if (!test::full_size()) {
    GTEST_SKIP() << "at full size; in the plane: analysis.growth";
  }
  const results::GrowthResult plain =
      growth_of(clamped_bar("", grow("KMAX=FULL KMIN=HALF CORRECT=NO")));
  const results::GrowthResult steps = growth_of(clamped_bar("", grow("KMAX=FULL KMIN=HALF")));
  const results::GrowthResult spectra = growth_of(clamped_bar("", spectrum("", "0.5 1 10")));
  ASSERT_FALSE(steps.stations.empty() || spectra.stations.empty());
  for (std::size_t tip = 0; tip < steps.stations[0].points.size(); ++tip) {
    const double K = steps.stations[0].points[tip].K_max;
    EXPECT_GT(std::abs(plain.stations.at(0).points[tip].K_max / K - 1.0), 1e-5);
    EXPECT_NEAR(spectra.stations[0].points[tip].K_max / K, 1.0, 1e-6);
  }
}

// A crack inside the body ends at KIE, as one whose every toughness is that ends at KC.
TEST(GrowingFronts, KieEndsACrackThatIsNotThrough) {
  const auto grown = [](const std::string& toughness) {
    return growth_of(clamped_bar(
        "", "$GROW LAW=NASGRO SHAPE=ELLIPSE C=1e-9 M=3 P=0 Q=0.5 TOL=0.1 CORRECT=NO AMAX=1.5 "
            "KUNIT='MPa*mm^0.5' AUNIT='mm' KMAX=FULL KMIN=REST " +
                toughness + "\n"));
  };
  const results::GrowthResult tough = grown("KC=500 KIE=64");
  const results::GrowthResult all = grown("KC=64");
  EXPECT_EQ(tough.ended, "KC");
  EXPECT_NE(tough.reason.find("reaches KIE"), std::string::npos) << tough.reason;
  EXPECT_EQ(all.ended, "KC");
  EXPECT_GT(tough.final_cycles(), 0.0);
  EXPECT_EQ(tough.final_cycles(), all.final_cycles());
  // Sneddon 1946: K = 2 S (a / pi)^0.5 of an infinite body, 3 % less than that of this bar
  const double a = tough.curve.back().a[0];
  EXPECT_NEAR(2.0 * 50.0 * std::sqrt(a / std::numbers::pi) / 64.0, 0.97, 0.04);
}

// Tips stand on the circle, not on the chords between the mesh's points.
TEST(GrowingFronts, TipsStandOnTheFront) {
  std::string free = grow("KMAX=FULL KMIN=HALF");
  free.replace(free.find("ELLIPSE"), std::string("ELLIPSE").size(), "FREE");
  const results::GrowthResult growth = growth_of(clamped_bar("", free));
  ASSERT_FALSE(growth.stations.empty());
  for (const results::GrownPointResult& tip : growth.stations[0].points) {
    EXPECT_NEAR((tip.x - base::Vec3(0, 3, 0)).norm(), 1.0, 5e-4);
  }
}

// A plate with a surface crack; when the load is on, a pad is bonded to the other side.
std::string padded_plate(const std::string& mounted) {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=PLATE
  $MESH SHAPE=BLOCK TYPE=TET10 X0=-6 Y0=0 Z0=0 LX=12 LY=6 LZ=6 NX=6 NY=3 NZ=4
$ENDNET
$NET NAME=PAD
  $MESH SHAPE=BLOCK TYPE=TET10 X0=-3 Y0=1 Z0=6 LX=6 LY=4 LZ=1 NX=4 NY=3 NZ=1
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=PLATE.BODY MATERIAL=M STATE=SOLID
$PROPERTY ESET=PAD.BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  PLATE.XMIN
$CONTACT NAME=GLUE SLAVE=PAD.ZMIN MASTER=PLATE.ZMAX TYPE=BONDED GAP=0
$CRACK NAME=C1 NET=PLATE A=0.8 X0=0 Y0=3 Z0=0 NORMAL=X
$LOAD CASE=PULL TYPE=TRACTION
  PLATE.XMAX 1 0 0
$STEP NAME=LOAD
  LOAD PULL 1
$STEP NAME=FIX
  MOUNT GLUE
$STEP NAME=LESS
  LOAD PULL 0.5
$GROW LAW=PARIS SHAPE=ELLIPSE KMAX=FIX KMIN=LESS C=1e-4 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' AMAX=0.85 CORRECT=NO MOUNTED=)" +
         mounted + "\n$END\n";
}

// The pad that was bonded at the first front takes load as the front grows; one that is bonded at
// each takes none. Both take the same part of what comes and goes, by K of the mesh exactly.
TEST(GrowingFronts, MountedAtTheFirstFront) {
  const results::GrowthResult first = growth_of(padded_plate("FIRST"));
  const results::GrowthResult each = growth_of(padded_plate("EACH"));
  ASSERT_GE(std::min(first.stations.size(), each.stations.size()), 2U);
  const results::GrowthStation& later = first.stations[1];
  for (std::size_t i = 0; i < later.points.size(); ++i) {
    const auto range = [&](const results::GrowthStation& station) {
      return station.points.at(i).K_max - station.points[i].K_min;
    };
    EXPECT_DOUBLE_EQ(first.stations[0].points.at(i).K_max, each.stations[0].points.at(i).K_max);
    EXPECT_NEAR(range(later) / range(each.stations[1]), 1.0, 1e-6);
    EXPECT_LT(later.points[i].K_max / each.stations[1].points[i].K_max, 1.0 - 1e-4);
  }
}

// A front that K shapes has in all results the length that its station gives its first point.
TEST(GrowingFronts, HaveTheLengthOfTheirFirstPoint) {
  std::string deck = padded_plate("EACH");
  const std::string held = "SHAPE=ELLIPSE";
  deck.replace(deck.find(held), held.size(), "SHAPE=FREE");
  const std::optional<test::Solved> solved = test::solve_text(deck);
  ASSERT_TRUE(solved && solved->run.growth);
  const std::vector<results::GrowthStation>& stations = solved->run.growth->stations;
  ASSERT_GE(stations.size(), 2U);
  ASSERT_EQ(stations.size(), solved->run.increments.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const results::CrackLengthResult& increment = solved->run.increments[i];
    EXPECT_NEAR(increment.a, stations[i].points.at(0).a, 1e-12);
    for (const results::LoadStepResult& step : increment.steps) {
      EXPECT_EQ(step.fronts.at(0).a, increment.a) << step.step;
    }
  }
  EXPECT_NEAR(stations[0].points[0].a, 0.8, 1e-9);
  EXPECT_GT(stations[1].points[0].a, 0.8);
}

} // namespace
} // namespace spricka::test_growing_fronts
