// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

// Patches that meet their host edge to edge and by a transition, cracks that share a patch: fields
// that the joins must let through, and K that must not depend on them.
namespace spricka::test_patch_joins {
namespace {

using test::solve_text;

/// A plate 10 by 8 with cracks, pulled along x and y, scaled and on elements of any size.
std::string plate(const std::string& cracks, double sx, double sy, double unit = 1.0, int n = 10) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  u = {}
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=(10*u) LY=(8*u) NX={} NY={}
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$NSET NAME=PIN   WHERE=(x + y < 1e-6*u)
$NSET NAME=SLIDE WHERE=(x > 10*u - 1e-6*u and y < 1e-6*u)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  PIN
$FREEDOM CLASS=SUPPRESSED DOF=Y
  SLIDE
$LOAD CASE=T TYPE=TRACTION
  XMAX  ({})  0
  XMIN  (-({}))  0
  YMAX  0  ({})
  YMIN  0  (-({}))
{}
$STEP NAME=S
  LOAD T 1
$END
)",
                     unit, n, n, sx, sx, sy, sy, cracks);
}

const std::string middle = "$CRACK NAME=C\n  (3.3*u) (4.1*u)\n  (5.9*u) (4.1*u)\n";
const std::string transition = "$TIPNET CRACK=C JOIN=TRANSITION\n";

// Tension along the crack: the displacements are linear, whatever elements and ties lie there.
TEST(PatchJoins, LinearFieldsPassATiedRim) {
  for (const std::string& join : {std::string(), transition}) {
    const auto solved = solve_text(plate(middle + join, 2.0, 0.0));
    ASSERT_TRUE(solved);
    const model::Mesh& mesh = solved->mesh();
    double worst = 0.0;
    for (const base::NodeId n : mesh.nodes) {
      const base::Vec3& x = mesh.x[n.index()];
      const base::Vec3 exact(2e-3 * x.x(), -0.6e-3 * x.y(), 0.0);
      worst = std::max(worst, (solved->u(n) - exact).norm());
    }
    EXPECT_LT(worst, 1e-12 * 2e-2);
    for (const auto& front : solved->step().fronts) {
      EXPECT_LT(std::hypot(front.single_point().K1, front.single_point().K2), 1e-9);
    }
  }
}

TEST(PatchJoins, KDoesNotDependOnTheJoin) {
  for (const int n : {5, 10, 23}) {
    const auto edge = solve_text(plate(middle, 0.0, 1.0, 1.0, n));
    const auto tied = solve_text(plate(middle + transition, 0.0, 1.0, 1.0, n));
    ASSERT_TRUE(edge && tied);
    for (std::size_t t = 0; t < 2; ++t) {
      const double K = edge->step().fronts.at(t).single_point().K1;
      EXPECT_GT(K, std::sqrt(std::numbers::pi * 1.3));
      EXPECT_NEAR(tied->step().fronts.at(t).single_point().K1, K, 1e-3 * K);
    }
  }
}

TEST(PatchJoins, KOfATiedPatchGoesWithTheRootOfTheUnit) {
  const auto one = solve_text(plate(middle + transition, 0.3, 1.0));
  const auto thousand = solve_text(plate(middle + transition, 0.3, 1.0, 1000.0));
  ASSERT_TRUE(one && thousand);
  for (std::size_t t = 0; t < 2; ++t) {
    const double K = one->step().fronts.at(t).single_point().K1;
    EXPECT_NEAR(thousand->step().fronts.at(t).single_point().K1, K * std::sqrt(1000.0),
                1e-9 * K * std::sqrt(1000.0));
  }
}

// Two cracks far from each other have one K; a crack and its mirror image have, in one patch too.
TEST(PatchJoins, MirroredCracksInOnePatchHaveOneK) {
  const std::string cracks = "$CRACK NAME=C\n  0 (3.7*u)\n  (2*u) (3.5*u)\n"
                             "$CRACK NAME=D\n  0 (4.3*u)\n  (2*u) (4.5*u)\n";
  const auto solved = solve_text(plate(cracks, 0.0, 1.0));
  ASSERT_TRUE(solved);
  const auto& fronts = solved->step().fronts;
  ASSERT_EQ(fronts.size(), 2U);
  EXPECT_GT(fronts[0].single_point().K1, 1.0);
  EXPECT_NEAR(fronts[0].single_point().K1, fronts[1].single_point().K1,
              5e-4 * fronts[0].single_point().K1);
  EXPECT_NEAR(fronts[0].single_point().K2, -fronts[1].single_point().K2,
              5e-4 * fronts[0].single_point().K1);
}

// Any number of threads, the same bits.
TEST(PatchJoins, ThreadsChangeNothing) {
  const std::string deck = plate(middle + transition, 0.0, 1.0);
  const auto one = solve_text(deck, 1);
  const auto four = solve_text(deck, 4);
  ASSERT_TRUE(one && four);
  EXPECT_EQ(one->step().fronts.at(0).single_point().K1,
            four->step().fronts.at(0).single_point().K1);
  EXPECT_EQ(one->step().u, four->step().u);
}

} // namespace
} // namespace spricka::test_patch_joins
