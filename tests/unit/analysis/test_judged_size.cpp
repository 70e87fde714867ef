// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <string>

#include <fmt/format.h>

namespace spricka::test_judged_size {
namespace {

std::string notes_of(const std::string& deck) {
  const auto s = test::solve_text(deck);
  EXPECT_TRUE(s);
  std::string all;
  for (const std::string& note :
       s ? results::text_with_code(s->step().notes) : std::vector<std::string>{}) {
    all += note + "\n";
  }
  return all;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A strip of length 10 and height 1 that a stress pulls: its strain is the stress over E.
std::string pulled(const std::string& mesh, const std::string& state, double strain) {
  const bool solid = state == "SOLID";
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH {0}
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE={1}
$FREEDOM CLASS=SUPPRESSED DOF=X
  XMIN
$FREEDOM CLASS=SUPPRESSED DOF=Y
  YMIN
{2}
$LOAD CASE=P TYPE=TRACTION
  XMAX {3} 0 {4}
$STEP NAME=S
  LOAD P 1
$END
)",
                     mesh, solid ? state : state + " THICK=2",
                     solid ? "$FREEDOM CLASS=SUPPRESSED DOF=Z\n  ZMIN" : "", 1000.0 * strain,
                     solid ? "0" : "");
}

TEST(JudgedSize, StrainsAboveOnePerCentAreTold) {
  const std::string plane = "SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=1 NX=6 NY=2";
  const std::string solid = "SHAPE=BLOCK TYPE=HEXEC20 LX=10 LY=1 LZ=2 NX=4 NY=1 NZ=2";
  for (const auto& [mesh, state] : {std::pair(plane, "STRESS"), std::pair(solid, "SOLID")}) {
    EXPECT_TRUE(has(notes_of(pulled(mesh, state, 0.011)), "is strained by 1.1 % on the whole"))
        << state;
    EXPECT_EQ(notes_of(pulled(mesh, state, 0.009)), "") << state;
  }
}

// A rigid turn strains nothing: by 0.11 of its size it is told, by 0.09 not; a push as large is
// nobody's fault.
TEST(JudgedSize, TurnsAreToldAndPushesAreNot) {
  const auto moved = [](const std::string& x, const std::string& y) {
    return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-5 Y0=-5 LX=10 LY=10 NX=2 NY=2
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=PRESCRIBED DOF=XY
  XMIN
  XMAX
$LOAD CASE=T TYPE=DISP
  XMIN ({0}) ({1})
  XMAX ({0}) ({1})
$STEP NAME=S
  LOAD T 1
$END
)",
                       x, y);
  };
  EXPECT_TRUE(has(notes_of(moved("-0.11*y", "0.11*x")), "is bent or turned by 11 % of its size"));
  EXPECT_EQ(notes_of(moved("-0.09*y", "0.09*x")), "");
  EXPECT_EQ(notes_of(moved("50", "-50")), "");
}

} // namespace
} // namespace spricka::test_judged_size
