// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/crack_face_overlap.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace spricka::test_crack_face_overlap {
namespace {

// A crack |x| < 1 in a large plate whose stress across it is x + r.
std::string bent(double r, const std::string& faces) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-20 Y0=-20 LX=40 LY=40 NX=16 NY=16
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$NSET NAME=LEFT  WHERE=(abs(x+20) < 1e-9 and abs(y) < 1e-9)
$NSET NAME=RIGHT WHERE=(abs(x-20) < 1e-9 and abs(y) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LEFT
$FREEDOM CLASS=SUPPRESSED DOF=Y
  RIGHT
$CRACK NAME=C FACES={}
  -1 0
  1 0
$LOAD CASE=BEND TYPE=TRACTION
  YMAX 0 (x+{})
  YMIN 0 (-x-{})
$STEP NAME=S
  LOAD BEND 1
$END
)",
                     faces, r, r);
}

// Fully open for r >= 1/2: K = (r +- 1/2) sqrt(pi).
TEST(RelativeCrackFaceOverlap, LeavesAnOpenCrackAlone) {
  const std::optional<test::Solved> solved = test::solve_text(bent(0.6, "CONTACT"));
  ASSERT_TRUE(solved);
  EXPECT_TRUE(solved->step().fronts[0].invalid_reason.empty());
  EXPECT_TRUE(solved->step().fronts[1].invalid_reason.empty());
  for (const std::string& note : results::text_with_code(solved->step().notes)) {
    EXPECT_EQ(note.find("overlap"), std::string::npos) << note;
  }
  EXPECT_NEAR(solved->step().fronts[0].single_point().K1, 0.1 * std::sqrt(std::numbers::pi), 0.01);
  EXPECT_NEAR(solved->step().fronts[1].single_point().K1, 1.1 * std::sqrt(std::numbers::pi), 0.01);
}

TEST(RelativeCrackFaceOverlap, OfFacesThatMayNotTouchIsOnlyTold) {
  const std::optional<test::Solved> solved = test::solve_text(bent(0.0, "FREE"));
  ASSERT_TRUE(solved);
  EXPECT_TRUE(solved->step().fronts[1].invalid_reason.empty());
  EXPECT_FALSE(solved->step().notes.empty());
}

// Two neighbours, or one of the last two at either end; a lone node inside is its mesh's error.
TEST(RelativeCrackFaceOverlap, IsResolvedByTwoNeighboursOrAtTheEnds) {
  const auto of = [](std::vector<double> overlap) {
    return analysis::find_shared_neighbour_overlap(overlap);
  };
  EXPECT_EQ(of({}), 0.0);
  EXPECT_EQ(of({3.0}), 3.0);
  EXPECT_EQ(of({0, 2.0, 0, 0, 0, 0}), 2.0);
  EXPECT_EQ(of({0, 0, 0, 0, 2.0, 0}), 2.0);
  EXPECT_EQ(of({0, 0, 2.0, 0, 0, 0}), 0.0);
  EXPECT_EQ(of({0, 0, 2.0, 1.0, 0, 0}), 1.0);
  EXPECT_EQ(of({0.5, 0, 9.0, 0, 9.0, 0, 0}), 0.5);
}

} // namespace
} // namespace spricka::test_crack_face_overlap
