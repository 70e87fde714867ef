// SPDX-License-Identifier: GPL-3.0-or-later
// K along fronts of tetrahedra without a tube, by wish and where no tube fits.
#include "tests/unit/support/run_text.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

namespace spricka {
namespace {

constexpr double pi = std::numbers::pi;

/// A block of half width 10 under tension, or shear, along z, with a circle of radius 1 in a plane
/// z = const; `what`: its place and $TIPNET.
std::string circle(const std::string& place, const std::string& tipnet) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE=TET10 X0=-10 Y0=-10 Z0=-10 LX=20 LY=20 LZ=20 NX=4 NY=4 NZ=4
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID
$NSET NAME=P1 WHERE=(x < -10 + 1e-6 and y < -10 + 1e-6 and z < -10 + 1e-6)
$NSET NAME=P2 WHERE=(x > 10 - 1e-6 and y < -10 + 1e-6 and z < -10 + 1e-6)
$NSET NAME=P3 WHERE=(x < -10 + 1e-6 and y > 10 - 1e-6 and z < -10 + 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  P1
$FREEDOM CLASS=SUPPRESSED DOF=YZ
  P2
$FREEDOM CLASS=SUPPRESSED DOF=Z
  P3
$CRACK NAME=C NET=B A=1 {} NORMAL=Z
{}$LOAD CASE=PULL TYPE=TRACTION
  B.ZMAX  0 0 1
  B.ZMIN  0 0 -1
$LOAD CASE=SHEAR TYPE=TRACTION
  B.ZMAX  1 0 0
  B.ZMIN  -1 0 0
  B.XMAX  0 0 1
  B.XMIN  0 0 -1
$STEP NAME=PULL
  LOAD PULL 1
$STEP NAME=BOTH
  LOAD SHEAR 1
$END
)",
                     place, tipnet);
}

constexpr const char* inside = "X0=0 Y0=0 Z0=0.1";

// Sneddon 1946, Segedin 1951.
TEST(FreeFronts, HaveTheKOfAPenny) {
  const auto solved = test::solve_text(circle(inside, "$TIPNET CRACK=C TUBE=NO\n"));
  ASSERT_TRUE(solved);
  const double K1 = 2.0 * std::sqrt(1.0 / pi);
  const double k = 4.0 / (pi * (2.0 - 0.3)) * std::sqrt(pi);
  for (const std::size_t step : {0U, 1U}) {
    const results::FrontResult& front = solved->step(step).fronts.at(0);
    EXPECT_GT(front.points.size(), 50U);
    double worst = 0.0;
    double worst2 = 0.0;
    double worst3 = 0.0;
    double mean = 0.0;
    for (const results::FrontPlace& place : front.points) {
      const double phi = std::atan2(place.x.y(), place.x.x());
      worst = std::max(worst, std::abs(place.K1 / K1 - 1.0));
      mean += (place.K1 / K1 - 1.0) / static_cast<double>(front.points.size());
      worst2 = std::max(worst2, std::abs(place.K2 - (step == 0 ? 0.0 : k * std::cos(phi))));
      worst3 = std::max(worst3, std::abs(place.K3 - (step == 0 ? 0.0 : 0.7 * k * std::sin(phi))));
    }
    GTEST_LOG_(INFO) << "K1 " << worst << " mean " << mean << ", K2 " << worst2 << ", K3 "
                     << worst3;
    EXPECT_LT(worst, 0.01);
    EXPECT_LT(std::abs(mean), 0.003);
    EXPECT_LT(worst2, 0.02 * k);
    EXPECT_LT(worst3, 0.02 * k);
  }
}

} // namespace
} // namespace spricka
