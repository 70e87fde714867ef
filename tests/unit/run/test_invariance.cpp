// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_text.hpp"

#include <cmath>

namespace spricka {
namespace {

using test::column;
using test::Folder;

// A cracked ring with a pin pressed in and loaded, with lengths and forces in any units: l and f
// are the sizes of mm and N in those.
std::string ring(const std::string& units, double l, double f) {
  const auto length = [&](double mm) { return std::to_string(mm) + "*l"; };
  std::string deck = "$DECK VERSION=1 " + units + "\n$PARAMETER\n";
  char number[64];
  std::snprintf(number, sizeof number, "  l = %.17g\n  f = %.17g\n", l, f);
  deck += number;
  deck += "$NET NAME=HUB\n  $MESH SHAPE=RING TYPE=QUAMC8 RI=(" + length(20) + ") RO=(" +
          length(50) + ") NR=8 NT=48\n$ENDNET\n";
  deck += "$NET NAME=PIN\n  $MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=(" + length(20) +
          ") NR=6 NT=44\n$ENDNET\n";
  deck += R"($MATERIAL NAME=S E=(210000*f/l^2) NU=0.3
$PROPERTY ESET=HUB.BODY MATERIAL=S STATE=STRESS THICK=(10*l)
$PROPERTY ESET=PIN.BODY MATERIAL=S STATE=STRESS THICK=(10*l)
$NSET NAME=HELD WHERE=(x < -44*l)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  HELD
$CONTACT NAME=FIT SLAVE=PIN.OUTER MASTER=HUB.INNER INTERFERENCE=(0.01*l)
$CRACK NAME=C NET=HUB ANGLE=90[deg] A0=(4*l)
  0 (20*l)
$LOAD CASE=PULL TYPE=RESULTANT
  PIN.BODY (20000*f) 0
$STEP NAME=PRESS
  FIT FIT 1
$STEP NAME=LOAD
  LOAD PULL 1
$GROW LAW=INCREMENT KMAX=LOAD
  (4*l) (7*l)
$END
)";
  return deck;
}

std::vector<double> k1(const Folder& folder) {
  return column(folder.path() / "out" / "k.csv", "K1");
}

TEST(Invariance, KDoesNotKnowTheUnits) {
  const Folder mm;
  const Folder metre;
  const Folder inch;
  ASSERT_EQ(run_text(mm, ring("LENGTH=mm FORCE=N", 1.0, 1.0)).exit_code, 0);
  ASSERT_EQ(run_text(metre, ring("LENGTH=m FORCE=N", 1e-3, 1.0)).exit_code, 0);
  const double pound = 4.4482216152605;
  ASSERT_EQ(run_text(inch, ring("LENGTH=in FORCE=lbf", 1.0 / 25.4, 1.0 / pound)).exit_code, 0);
  const std::vector<double> a = k1(mm);
  const std::vector<double> b = k1(metre);
  const std::vector<double> c = k1(inch);
  ASSERT_EQ(a.size(), 4U);
  ASSERT_EQ(b.size(), a.size());
  ASSERT_EQ(c.size(), a.size());
  const double metres = std::pow(1e-3, -1.5);
  const double inches = std::pow(1.0 / 25.4, -1.5) / pound;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(b[i] / (a[i] * metres), 1.0, 1e-10);
    EXPECT_NEAR(c[i] / (a[i] * inches), 1.0, 1e-10);
  }
}

TEST(Invariance, SameBitsForOneAndTwoThreads) {
  const Folder one;
  const Folder two;
  ASSERT_EQ(run_text(one, ring("LENGTH=mm FORCE=N", 1.0, 1.0), 1).exit_code, 0);
  ASSERT_EQ(run_text(two, ring("LENGTH=mm FORCE=N", 1.0, 1.0), 2).exit_code, 0);
  for (const char* file : {"k.csv", "pressure.csv"}) {
    EXPECT_EQ(test::slurp(one.path() / "out" / file), test::slurp(two.path() / "out" / file));
  }
}

} // namespace
} // namespace spricka
