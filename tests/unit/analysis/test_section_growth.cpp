// SPDX-License-Identifier: GPL-3.0-or-later
// Growth in space that ends at the plastic limit of the section, against statics.
#include "growth/section_limit.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace spricka::test_section_growth {
namespace {

constexpr double width = 8.0, thickness = 2.0, flow = 125.0;

// A plate under a tension of 100 with a surface crack on y = 0, supported without reactions.
// `half`: beside its plane of symmetry x = 0.
std::string plate(const std::string& type, const std::string& grow, bool half = false) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=PLATE
  $MESH SHAPE=BLOCK TYPE={0} X0={2} Y0=0 Z0=-8 LX={3} LY=2 LZ=16 NX={4} NY=2 NZ=10
$ENDNET
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=PLATE.BODY MATERIAL=M STATE=SOLID
$NSET NAME=P1 WHERE=(x < {2} + 0.01 and y < 0.01 and z < -7.99)
$NSET NAME=P2 WHERE=(x > 3.99 and y < 0.01 and z < -7.99)
$NSET NAME=P3 WHERE=(x < {2} + 0.01 and y > 1.99 and z < -7.99)
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  P1
$FREEDOM CLASS=SUPPRESSED DOF=YZ
  P2
$FREEDOM CLASS=SUPPRESSED DOF=Z
  P3
{5}$CRACK NAME=C1 NET=PLATE A=0.8 C=1.2 X0=0 Y0=0 Z0=0 NORMAL=Z
$LOAD CASE=PULL TYPE=TRACTION
  PLATE.ZMAX  0 0 100
  PLATE.ZMIN  0 0 -100
$STEP NAME=FULL
  LOAD PULL 1
$STEP NAME=ZERO
  LOAD PULL 0
$GROW LAW=PARIS SHAPE=ELLIPSE KMAX=FULL KMIN=ZERO C=1e-12 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' {1}
$END
)",
                     type, grow, half ? 0 : -4, half ? 4 : 8, half ? 3 : 6,
                     half ? "$FREEDOM CLASS=SUPPRESSED DOF=X\n  PLATE.XMIN\n" : "");
}

// What is left beside half an ellipse carries the whole force, through the middle of the plate.
double by_statics(double a, double c) {
  constexpr int nx = 800;
  constexpr int ny = 200;
  std::vector<growth::SectionPiece> section;
  for (int i = 0; i < nx; ++i) {
    for (int k = 0; k < ny; ++k) {
      const double x = (i + 0.5) / nx * width - 0.5 * width;
      const double y = (k + 0.5) / ny * thickness;
      if (std::hypot(x / c, y / a) > 1.0) {
        section.push_back({{x, y}, width * thickness / (nx * ny)});
      }
    }
  }
  const double N = 100.0 * width * thickness;
  return growth::plastic_load_ratio(section, {N, {0.0, 0.5 * thickness * N}}, flow);
}

TEST(SectionGrowth, EndsAtThePlasticLimitOfTheSection) {
  ASSERT_LT(by_statics(0.8, 1.2), 0.96);
  for (const char* type : {"TET10", "HEXEC20"}) {
    const auto solved = test::solve_text(plate(type, fmt::format("SFLOW={}", flow)));
    ASSERT_TRUE(solved && solved->run.growth) << type;
    EXPECT_EQ(solved->run.growth->ended, "NET SECTION") << type;
    const std::vector<double>& arms = solved->run.growth->curve.back().a; // C1.A, C1.C1, C1.C2
    ASSERT_EQ(arms.size(), 3U);
    EXPECT_NEAR(by_statics(arms[0], arms[1]), 1.0, 3e-3) << type << ": " << arms[0];
  }
}

// Half of the plate has the limit of the whole one.
TEST(SectionGrowth, KnowsPlanesOfSymmetry) {
  const auto solved = test::solve_text(plate("TET10", fmt::format("SFLOW={}", flow), true));
  ASSERT_TRUE(solved && solved->run.growth);
  EXPECT_EQ(solved->run.growth->ended, "NET SECTION");
  const std::vector<double>& arms = solved->run.growth->curve.back().a; // C1.A, C1.C
  ASSERT_EQ(arms.size(), 2U);
  EXPECT_NEAR(by_statics(arms[0], arms[1]), 1.0, 3e-3) << arms[0];
}

TEST(SectionGrowth, MayBeAtItsLimitFromTheStart) {
  const auto solved = test::solve_text(plate("TET10", "SFLOW=100"));
  ASSERT_TRUE(solved && solved->run.growth);
  EXPECT_EQ(solved->run.growth->ended, "NET SECTION");
  EXPECT_EQ(solved->run.growth->final_cycles(), 0.0);
}

} // namespace
} // namespace spricka::test_section_growth
