// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace spricka::test_round_gaps {
namespace {

// A ring in a ring that it fits without a gap, pressed from outside with 1: by Lame 0.8 comes
// through. `gap` as the contact card has it, `type` of the elements, `n` of them over the half of
// the inner ring, where the outer one has others.
std::string rings(const std::string& gap, const std::string& type, int n, double E) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=IN
$MESH SHAPE=RING TYPE={1} RI=0.5 RO=1 NR={5} NT={2} T1=180[deg]
$ENDNET
$NET NAME=OUT
$MESH SHAPE=RING TYPE={1} RI=1 RO=2 NR={6} NT={3} T1=180[deg]
$ENDNET
$MATERIAL NAME=M E={4} NU=0.3
$PROPERTY ESET=IN.BODY  MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=OUT.BODY MATERIAL=M STATE=STRESS THICK=1
$NSET NAME=SYMY WHERE=(abs(y) < 1e-9)
$NSET NAME=SYMX WHERE=(abs(x) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  SYMY
$FREEDOM CLASS=SUPPRESSED DOF=X
  SYMX
$CONTACT NAME=C SLAVE=IN.OUTER MASTER=OUT.INNER {0}
$LOAD CASE=P TYPE=PRESSURE
  OUT.OUTER 1
$STEP NAME=S
  LOAD P 1
$END
)",
                     gap, type, n, n + n / 2 + 1, E, std::max(3, n / 3), std::max(4, n / 2));
}

// "by up to X % of the largest"; zero where nothing is told.
double told_change(const test::Solved& s) {
  for (const std::string& note : results::text_with_code(s.step().notes)) {
    const std::size_t at = note.find("pressures differ by up to ");
    if (at != std::string::npos) {
      return std::strtod(note.c_str() + at + 26, nullptr) / 100.0;
    }
  }
  return 0.0;
}

// Largest difference of the pressure to 0.8, over the largest pressure.
double error_of(const test::Solved& s) {
  double worst = 0.0;
  double largest = 0.8;
  for (const results::ContactPoint& p : s.step().contacts.at(0).points) {
    worst = std::max(worst, std::abs(p.p_lumped - 0.8));
    largest = std::max(largest, p.p_lumped);
  }
  return worst / largest;
}

// Edges of coarse rings leave the circle by as much as the pressure moves stiff rings: what is told
// is what the pressure is off by.
TEST(RoundGaps, TellWhatStraightAndCurvedEdgesDoToThePressure) {
  for (const auto& [type, E] : {std::pair("QUAMC8", 10000.0), std::pair("QUAM4", 200.0)}) {
    const auto s = test::solve_text(rings("", type, 8, E));
    ASSERT_TRUE(s) << type;
    const double told = told_change(*s);
    EXPECT_GT(told, 0.05) << type;
    EXPECT_NEAR(told, error_of(*s), 0.25 * told) << type;
  }
}

TEST(RoundGaps, SayNothingOfDeclaredGapsFineMeshesAndSoftBodies) {
  for (const std::string& deck : {rings("GAP=0", "QUAMC8", 8, 5000.0),
                                  rings("", "QUAMC8", 40, 5000.0), rings("", "QUAMC8", 8, 100.0)}) {
    const auto s = test::solve_text(deck);
    ASSERT_TRUE(s);
    EXPECT_EQ(told_change(*s), 0.0);
    EXPECT_LT(error_of(*s), 0.03);
  }
}

} // namespace
} // namespace spricka::test_round_gaps
