// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_tip_loads {
namespace {

using test::Folder;
using test::run_text;
using test::solve_text;
using test::Solved;

const results::FrontPointResult& tip(const Solved& solved, const std::string& step,
                                     const std::string& name) {
  const results::LoadStepResult* s = results::find_step(solved.run.increments.front(), step);
  const results::FrontResult* found = s == nullptr ? nullptr : results::find_front(*s, name);
  if (found == nullptr) {
    throw std::runtime_error("no tip " + name);
  }
  return found->single_point();
}

// A round plate with an oblique crack in it, turned by an angle, in other units; l and f are the
// sizes of mm and N. Expressions in the plate's own axes X, Y.
std::string plate(double turn, const std::string& units, double l, double f,
                  const std::string& loads) {
  return fmt::format(R"($DECK VERSION=1 {}
$PARAMETER
  turn = {:.17g}
  l = {:.17g}
  f = {:.17g}
  c = cos(turn)
  s = sin(turn)
  p = f/l^2
$MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=(10*l) NR=6 NT=32 T0=(turn) T1=(turn+2*pi)
$MATERIAL NAME=M E=(70000*p) NU=0.3 ALPHA=2e-5
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN THICK=(3*l)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  OUTER
$CRACK NAME=C FACES=FREE
  (l*(-2*c-1*s))  (l*(-2*s+1*c))
  (l*(3*c-0.5*s)) (l*(3*s+0.5*c))
{}$END
)",
                     units, turn, l, f, loads);
}

const std::string every_load = R"(
$LOAD CASE=FACES TYPE=FACES
  C  (p*(100+5*(x*c+y*s)/l))
$LOAD CASE=LIP TYPE=TRACTION
  C.LEFT   (p*20*c) (p*20*s)
  C.RIGHT  (-p*20*c) (-p*20*s)
$LOAD CASE=BULK TYPE=BODY
  BODY  (p/l*(5+3*(y*c-x*s)/l)*c)  (p/l*(5+3*(y*c-x*s)/l)*s)
$LOAD CASE=HEAT TYPE=TEMPERATURE
  BODY  (-50+2*(x*c+y*s)/l-0.5*(x^2+y^2)/l^2)
$STEP NAME=A
  LOAD FACES 1
$STEP NAME=B
  LOAD LIP 1
$STEP NAME=C
  LOAD BULK 1
$STEP NAME=D
  LOAD HEAT 1
)";

TEST(TipLoads, KAndTDoNotDependOnUnitsAndTurns) {
  const auto plain = solve_text(plate(0.0, "LENGTH=mm FORCE=N", 1.0, 1.0, every_load));
  const auto turned = solve_text(plate(0.7, "LENGTH=m FORCE=kN", 1e-3, 1e-3, every_load));
  ASSERT_TRUE(plain && turned);
  const double p = 1e3; // MPa in kN/m^2
  for (const char* step : {"A", "B", "C", "D"}) {
    for (const char* name : {"C.1", "C.2"}) {
      const results::FrontPointResult& one = tip(*plain, step, name);
      const results::FrontPointResult& other = tip(*turned, step, name);
      const double K = std::hypot(one.K1, one.K2);
      EXPECT_NEAR(other.K1 / (p * std::sqrt(1e-3)), one.K1, 1e-9 * K);
      EXPECT_NEAR(other.K2 / (p * std::sqrt(1e-3)), one.K2, 1e-9 * K);
      EXPECT_NEAR(other.T / p, one.T, 1e-8 * K);
      EXPECT_NEAR(other.G / (p * 1e-3), one.G, 1e-9 * one.G);
      EXPECT_LT(one.spread, 2e-3);
      EXPECT_NEAR(one.G_from_K, one.G, 5e-3 * one.G);
    }
  }
}

// A uniform stress s and the same crack with tractions -s n on its crack faces instead differ by a
// field that every element holds exactly: K is the same, T differs by the stress along the crack.
TEST(TipLoads, LoadedCrackFacesHaveTheKOfTheStressAround) {
  for (const char* state : {"STRESS", "STRAIN"}) {
    const auto solved = solve_text(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=10 NX=8 NY=8
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE={} THICK=2
$NSET NAME=O WHERE=(x < 1e-9 and y < 1e-9)
$NSET NAME=A WHERE=(x > 10-1e-9 and y < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  O
$FREEDOM CLASS=SUPPRESSED DOF=Y
  A
$CRACK NAME=C FACES=FREE
  4 4
  7 6
$LOAD CASE=ROUND TYPE=TRACTION
  XMAX  100  30
  XMIN  -100 -30
  YMAX  30   60
  YMIN  -30  -60
$PARAMETER
  r  = sqrt(13)
  nx = -2/r
  ny = 3/r
  tx = 100*nx + 30*ny
  ty = 30*nx + 60*ny
$LOAD CASE=LIPS TYPE=TRACTION
  C.LEFT   (tx)   (ty)
  C.RIGHT  (-tx)  (-ty)
$STEP NAME=ROUND
  LOAD ROUND 1
$STEP NAME=LIPS
  LOAD ROUND 0
  LOAD LIPS 1
$END
)",
                                               state));
    ASSERT_TRUE(solved);
    const double cx = 3.0 / std::sqrt(13.0);
    const double cy = 2.0 / std::sqrt(13.0);
    const double along = 100.0 * cx * cx + 60.0 * cy * cy + 60.0 * cx * cy;
    for (const char* name : {"C.1", "C.2"}) {
      const results::FrontPointResult& round = tip(*solved, "ROUND", name);
      const results::FrontPointResult& crack_faces = tip(*solved, "LIPS", name);
      EXPECT_GT(round.K1, 50.0);
      EXPECT_NEAR(crack_faces.K1, round.K1, 1e-7 * round.K1); // quadrature of the near-tip fields
      EXPECT_NEAR(crack_faces.K2, round.K2, 1e-7 * round.K1);
      EXPECT_NEAR(crack_faces.G, round.G, 1e-7 * round.G);
      EXPECT_NEAR(round.T - crack_faces.T, along, 1e-6 * along);
    }
  }
}

// A crack in a hub with a pin pressed in: K on the path between two sets of all loads is that of
// the points in between, solved one by one.
TEST(TipLoads, LoadPathsHoldThem) {
  std::string steps;
  for (int k = 0; k <= 4; ++k) {
    const double t = 0.25 * k;
    steps += fmt::format("$STEP NAME=S{}\n  LOAD FACES ({})\n  LOAD BULK ({})\n  LOAD HEAT ({})\n"
                         "  LOAD PULL ({})\n  FIT FIT ({})\n",
                         k, 1.0 + t, 2.0 * t, 1.0 - 0.5 * t, t, 1.0 - 0.3 * t);
  }
  const auto solved = test::solve_text_with_raw_K(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=HUB
  $MESH SHAPE=RING TYPE=QUAMC8 RI=20 RO=50 NR=6 NT=48
$ENDNET
$NET NAME=PIN
  $MESH SHAPE=RING TYPE=QUAMC8 RI=5 RO=20 NR=4 NT=40
$ENDNET
$MATERIAL NAME=S E=210000 NU=0.3 ALPHA=1.2e-5
$PROPERTY ESET=HUB.BODY MATERIAL=S STATE=STRESS THICK=10
$PROPERTY ESET=PIN.BODY MATERIAL=S STATE=STRESS THICK=10
$NSET NAME=HELD WHERE=(x < -44)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  HELD
$CRACK NAME=C NET=HUB A0=6 ANGLE=70[deg]
  (20*cos(70[deg])) (20*sin(70[deg]))
$CONTACT NAME=FIT SLAVE=PIN.OUTER MASTER=HUB.INNER INTERFERENCE=0.01
$LOAD CASE=FACES TYPE=FACES
  C  (10+x)
$LOAD CASE=BULK TYPE=BODY
  HUB.BODY  (0.02*y)  (0.01*x-0.3)
$LOAD CASE=HEAT TYPE=TEMPERATURE
  HUB.BODY  (20-0.01*(x^2+y^2))
$LOAD CASE=PULL TYPE=RESULTANT
  PIN.BODY  20000 3000
)" + steps + "$LOADPATH NAME=UP FROM=S0 TO=S4\n$END\n");
  ASSERT_TRUE(solved);
  const results::LoadPathResult* path = results::find_path(solved->run.increments.front(), "UP");
  ASSERT_NE(path, nullptr);
  ASSERT_TRUE(path->stopped.empty());
  const double largest = std::max(path->fronts[0].single_point().K[0].largest_value(),
                                  -path->fronts[0].single_point().K[0].smallest_value());
  for (int k = 0; k <= 4; ++k) {
    const results::FrontPointResult& point = tip(*solved, fmt::format("S{}", k), "C");
    EXPECT_NEAR(path->fronts[0].single_point().K[0](0.25 * k), point.K1, 1e-11 * largest) << k;
    EXPECT_NEAR(path->fronts[0].single_point().K[1](0.25 * k), point.K2, 1e-11 * largest) << k;
  }
}

std::string half(const std::string& cards) {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=20 NX=10 NY=20
$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)
$MATERIAL NAME=M E=1000 NU=0.3 ALPHA=1e-5
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=Y
  LINE
$FREEDOM CLASS=SUPPRESSED DOF=X
  XMIN
$CRACK NAME=C PATH=LINE A0=5
$LOAD CASE=L TYPE=TRACTION
  YMAX 0 1
)" + cards +
         "$STEP NAME=S\n  LOAD L 1\n$END\n";
}

// The deck's own set along the symmetry line loads the crack face as its name does.
TEST(TipLoads, ASetOfTheSymmetryLineLoadsTheCrackFace) {
  double K[2];
  int i = 0;
  for (const char* name : {"LINE", "C.LEFT"}) {
    const auto solved = solve_text(half(fmt::format("$LOAD CASE=L TYPE=PRESSURE\n  {} 1\n", name)));
    ASSERT_TRUE(solved);
    K[i++] = tip(*solved, "S", "C").K1;
  }
  const auto tension = solve_text(half(""));
  ASSERT_TRUE(tension);
  EXPECT_NEAR(K[0], K[1], 1e-10 * K[0]);
  EXPECT_NEAR(K[0], 2.0 * tip(*tension, "S", "C").K1, 1e-7 * K[0]);
}

TEST(TipLoads, TotalsOnCrackFacesAndUnknownCrackFacesAreRefused) {
  const Folder folder;
  const auto total = run_text(folder, half("$LOAD CASE=L TYPE=RESULTANT\n  LINE 0 1\n"));
  EXPECT_EQ(total.exit_code, 3);
  EXPECT_NE(total.messages.find("E417"), std::string::npos) << total.messages;
  const auto unknown = run_text(folder, half("$LOAD CASE=L TYPE=PRESSURE\n  D.LEFT 1\n"));
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_NE(unknown.messages.find("E301"), std::string::npos) << unknown.messages;
  const auto both = run_text(folder, half("$NET NAME=C\n  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=20 LX=1 "
                                          "LY=1\n  $NSET NAME=LEFT WHERE=(x<21)\n$ENDNET\n"
                                          "$PROPERTY ESET=C.BODY MATERIAL=M STATE=STRESS\n"
                                          "$LOAD CASE=L TYPE=PRESSURE\n  C.LEFT 1\n"));
  EXPECT_EQ(both.exit_code, 3);
  EXPECT_NE(both.messages.find("E302"), std::string::npos) << both.messages;
}

// A force on a node that a domain would carry along: domains that reach it are left out. The rim of
// what is heated may cross them; all find the same K, and the same G.
TEST(TipLoads, DomainsKeepClearOfForcesButNotOfRimsOfHeat) {
  const std::string own = "$TIPNET CRACK=C PATCH=NO\n$VCE CRACK=C DOMAINS=1,2,3\n";
  const auto forced = solve_text(half(own + "$NSET NAME=F WHERE=(abs(x-7) < 1e-9 and abs(y-1) < "
                                            "1e-9)\n$LOAD CASE=L TYPE=FORCE\n  F 0 0.1\n"));
  ASSERT_TRUE(forced);
  EXPECT_EQ(tip(*forced, "S", "C").K1_domain.size(), 1U);
  const auto heated =
      solve_text(half(own + "$ESET NAME=HOT WHERE=(x > 7)\n$LOAD CASE=L TYPE=TEMPERATURE\n"
                            "  HOT 10\n"));
  ASSERT_TRUE(heated);
  const results::FrontPointResult& warm = tip(*heated, "S", "C");
  ASSERT_EQ(warm.K1_domain.size(), 3U);
  EXPECT_LT(warm.spread, 2e-3);
  EXPECT_NEAR(warm.G, warm.G_from_K, 0.01 * warm.G_from_K);
  const auto free = solve_text(half(own));
  ASSERT_TRUE(free);
  EXPECT_EQ(tip(*free, "S", "C").K1_domain.size(), 3U);
}

// K of the opening is a coarse look at the same thing.
TEST(TipLoads, OpeningComesNearK) {
  const auto solved = solve_text(half("$VCE CRACK=C CHECK=OPENING\n"));
  ASSERT_TRUE(solved);
  const results::FrontPointResult& found = tip(*solved, "S", "C");
  ASSERT_TRUE(found.opening.has_value());
  EXPECT_NEAR((*found.opening)[0], found.K1, 0.02 * found.K1);
  EXPECT_NE((*found.opening)[0], found.K1);
}

} // namespace
} // namespace spricka::test_tip_loads
