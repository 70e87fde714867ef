// SPDX-License-Identifier: GPL-3.0-or-later
// Error bars of K about an axis against closed forms and against finer meshes: do they hold, and
// are they tight?
#include "tests/unit/support/solved_text.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_axial_bars {
namespace {

using test::solve_text;
using test::Solved;

/// Bars beside errors of K, in parts of the size of K.
struct Tally {
  int all = 0, inside = 0, large = 0, tight = 0;

  void add(const results::FrontPointResult& tip, std::size_t mode, double truth, double size) {
    constexpr double counts_from = 1e-4; // smaller ones are as small as what is known of K
    const double error = std::abs(tip.K()[mode] - truth);
    const double raw = std::abs(tip.raw_K()[mode] - truth);
    const double bar = tip.bar[mode].size();
    all += 1;
    inside += error <= bar ? 1 : 0;
    if (raw > counts_from * size) {
      large += 1;
      tight += error <= bar && bar <= 2.0 * raw ? 1 : 0;
    }
  }
};

// decks/penny_axi.deck, coarser: a penny of radius 1 in a shaft of radius 30.
std::string penny(const std::string& type, int n, const std::string& net) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE={0} Y0=-150 LX=30 LY=300 NX={1} NY=(4*{1})
$NSET NAME=FOOT WHERE=(x < 1e-9 and y < 1e-9-150)
$MATERIAL NAME=M E=210e3 NU=0.3 ALPHA=1.2e-5
$PROPERTY ESET=BODY MATERIAL=M STATE=AXI
$FREEDOM CLASS=SUPPRESSED DOF=Y
  FOOT
$CRACK NAME=C
  0  0
  1  0
{2}
$LOAD CASE=PULL TYPE=TRACTION
  YMAX  0  100
  YMIN  0  -100
$LOAD CASE=CONE TYPE=FACES
  C  (100*(1-x))
$LOAD CASE=SHEAR TYPE=TRACTION
  C.LEFT   (100*x)   0
  C.RIGHT  (-100*x)  0
$LOAD CASE=SPIN TYPE=BODY
  BODY  (0.1*x)  0
$LOAD CASE=HEAT TYPE=TEMPERATURE
  BODY  (100*x^2/900)
$STEP NAME=PULL
  LOAD PULL 1
$STEP NAME=CONE
  LOAD PULL 0
  LOAD CONE 1
$STEP NAME=SHEAR
  LOAD CONE 0
  LOAD PULL 1
  LOAD SHEAR 1
$STEP NAME=SPIN
  LOAD PULL 0
  LOAD SHEAR 0
  LOAD SPIN 1
$STEP NAME=HEAT
  LOAD SPIN 0
  LOAD HEAT 1
$END
)",
                     type, n, net);
}

// References of decks/penny_axi.deck, by step.
std::vector<std::array<double, 2>> penny_K() {
  using std::numbers::pi;
  const double K0 = 200.0 / std::sqrt(pi);
  const double k = 2.0 / std::sqrt(pi) * (0.5 - 2.0 / 2700.0);
  const double spin = 0.1 * 0.3 * 900.0 / 1.4;
  const double heat = 210e3 * 1.2e-5 * 100.0 / 0.7;
  return {{K0, 0.0},
          {K0 * (1.0 - pi / 4.0), 0.0},
          {K0, 400.0 / 3.0 / std::sqrt(pi)},
          {k * spin, 0.0},
          {k * heat, 0.0}};
}

TEST(AxialBars, HoldTheClosedFormsOfPennies) {
  Tally tally;
  const std::string coarse = "$TIPNET CRACK=C SIZE=0.3";
  struct Case {
    std::string type;
    int n;
    std::string net;
  };
  for (const auto& [type, n, net] : std::vector<Case>{{"QUAMC8", 20, ""},
                                                      {"QUAMC8", 20, coarse},
                                                      {"QUAMC9", 15, coarse},
                                                      {"TRIMC6", 20, ""},
                                                      {"TRIMC6", 15, coarse}}) {
    const auto solved = solve_text(penny(type, n, net));
    ASSERT_TRUE(solved);
    const auto& steps = solved->run.increments.front().steps;
    const auto exact = penny_K();
    ASSERT_EQ(steps.size(), exact.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const results::FrontResult& front = steps[i].fronts.at(0);
      ASSERT_EQ(front.missing_bar_reason, "");
      const double size = std::hypot(exact[i][0], exact[i][1]);
      tally.add(front.single_point(), 0, exact[i][0], size);
      tally.add(front.single_point(), 1, exact[i][1], size);
    }
  }
  std::printf("%d of %d inside, %d of %d tight\n", tally.inside, tally.all, tally.tight,
              tally.large);
  EXPECT_GE(tally.inside, 0.95 * tally.all);
  EXPECT_GT(tally.large, 10);
  EXPECT_GE(tally.tight, 0.8 * tally.large);
}

// A press-fitted ring on a hollow shaft with a crack from the bore, on a slope: contact, both
// modes.
std::string shaft(int n, double size, double rise) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=SHAFT
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=4 Y0=-20 LX=6 LY=40 NX=(3*{0}) NY=(20*{0})
$ENDNET
$NET NAME=RING
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=10 Y0=-6 LX=6 LY=12 NX=(3*{0}) NY=(6*{0})
$ENDNET
$NSET NAME=FOOT WHERE=(x < 4+1e-9 and y < 1e-9-20)
$NSET NAME=HELD WHERE=(x > 16-1e-9 and y < 1e-9-6)
$MATERIAL NAME=M E=210e3 NU=0.3
$PROPERTY ESET=SHAFT.BODY MATERIAL=M STATE=AXI
$PROPERTY ESET=RING.BODY MATERIAL=M STATE=AXI
$FREEDOM CLASS=SUPPRESSED DOF=Y
  FOOT HELD
$CONTACT NAME=FIT SLAVE=SHAFT.XMAX MASTER=RING.XMIN INTERFERENCE=0.01
$CRACK NAME=C NET=SHAFT A0=2.5 ANGLE={2}[deg]
  4  3
$TIPNET CRACK=C SIZE={1}
$LOAD CASE=PULL TYPE=TRACTION
  SHAFT.YMAX  0  100
  SHAFT.YMIN  0  -100
$STEP NAME=PRESS
  MOUNT FIT
$STEP NAME=PULL
  LOAD PULL 1
$END
)",
                     n, size, rise);
}

TEST(AxialBars, HoldTheTruthOfAPressedShaft) {
  Tally tally;
  for (const double rise : {0.0, 30.0}) {
    const auto fine = solve_text(shaft(6, 0.05, rise));
    ASSERT_TRUE(fine);
    for (const auto& [n, size] : {std::pair{1, 0.5}, {2, 0.5}, {2, 0.25}}) {
      const auto solved = solve_text(shaft(n, size, rise));
      ASSERT_TRUE(solved);
      const results::FrontResult& front = solved->step(1).fronts.at(0);
      const results::FrontPointResult& truth = fine->step(1).fronts.at(0).single_point();
      ASSERT_EQ(front.missing_bar_reason, "");
      const double scale = std::hypot(truth.K1, truth.K2);
      tally.add(front.single_point(), 0, truth.K1, scale);
      tally.add(front.single_point(), 1, truth.K2, scale);
    }
  }
  EXPECT_EQ(tally.inside, tally.all);
}

} // namespace
} // namespace spricka::test_axial_bars
