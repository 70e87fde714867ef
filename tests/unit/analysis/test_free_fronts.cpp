// SPDX-License-Identifier: GPL-3.0-or-later
// K along fronts of tetrahedra without a tube, by wish and where no tube fits.
#include "tests/unit/support/run_text.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

namespace spricka::test_free_fronts {
namespace {

constexpr double pi = std::numbers::pi;

/// A block of half width 10 under tension, then shear, too, with a circle of radius 1 in a plane
/// z = const.
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

// Sneddon 1946, Segedin 1951. K of a point scatters about them, the more regular the less: what is
// asked is what was measured, K1 to 2.1 % (under shear, too, 3 %), its mean to 0.1 %.
TEST(FreeFronts, HaveTheKOfAPenny) {
  const auto solved = test::solve_text(circle(inside, "$TIPNET CRACK=C TUBE=NO\n"));
  ASSERT_TRUE(solved);
  const double K1 = 2.0 * std::sqrt(1.0 / pi);
  const double k = 4.0 / (pi * (2.0 - 0.3)) * std::sqrt(pi);
  for (const std::size_t step : {0U, 1U}) {
    const results::FrontResult& front = solved->step(step).fronts.at(0);
    const double shear = step == 0 ? 0.0 : k;
    EXPECT_GT(front.points.size(), 50U);
    double mean = 0.0;
    for (const results::FrontPointResult& place : front.points) {
      const double phi = std::atan2(place.x.y(), place.x.x());
      EXPECT_NEAR(place.K1, K1, (step == 0 ? 0.03 : 0.04) * K1);
      EXPECT_NEAR(place.smooth[0], K1, 0.02 * K1);
      EXPECT_NEAR(place.K2, shear * std::cos(phi), 0.03 * k);
      EXPECT_NEAR(place.K3, 0.7 * shear * std::sin(phi), 0.03 * k);
      EXPECT_NEAR(place.G, place.G_from_K, 0.05 * place.G);
      mean += (place.K1 / K1 - 1.0) / static_cast<double>(front.points.size());
    }
    EXPECT_NEAR(mean, 0.0, 0.003);
  }
}

// A circle that leaves the body at 18 degrees, where no tube fits: solved, and told. Deep inside it
// is nearly a penny, the more loaded for the ligament that it lacks.
TEST(FreeFronts, AreToldWhereNoTubeFits) {
  const test::Folder folder;
  std::string deck = circle("X0=0 Y0=-9.05 Z0=0.1", "");
  deck.replace(deck.find("$STEP NAME=BOTH"), std::string::npos,
               "$CHECK\n  K1.AT(C,0,-8.05,0.1,PULL) = (1.05*2/sqrt(pi)) REL 5e-2\n$END\n");
  const test::Outcome outcome = test::run_text(folder, deck);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_NE(outcome.messages.find("W423"), std::string::npos) << outcome.messages;
  EXPECT_NE(outcome.messages.find("at 18 degrees only"), std::string::npos) << outcome.messages;
  const std::string listing = test::slurp(folder.path() / "out" / "listing.txt");
  EXPECT_NE(listing.find("no tube (K1 scatters by 2 to 4 %)"), std::string::npos);
}

// Domains that reach past the centre of curvature: no K of a part of the front, so none at all.
TEST(FreeFronts, AreRefusedWhereDomainsHaveNoRoom) {
  const test::Folder folder;
  const test::Outcome outcome =
      test::run_text(folder, circle(inside, "$TIPNET CRACK=C TUBE=NO\n$VCE CRACK=C DOMAINS=5\n"));
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_NE(outcome.messages.find("E412"), std::string::npos) << outcome.messages;
}

} // namespace
} // namespace spricka::test_free_fronts
