// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

namespace spricka::test_round_bodies {
namespace {

// A bush pressed into a hub and a pin that is moved in it, all round and without friction. The hub,
// coarser, gives the normals; its bore is drawn `off` beside the axis of the others.
std::string bushed_hub(double off) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=HUB
  $MESH SHAPE=RING TYPE=QUAMC8 Y0={} RI=20 RO=50 NR=3 NT=16
$ENDNET
$NET NAME=BUSH
  $MESH SHAPE=RING TYPE=QUAMC8 RI=15 RO=20 NR=1 NT=32
$ENDNET
$NET NAME=PIN
  $MESH SHAPE=RING TYPE=QUAMC8 RI=5 RO=15 NR=2 NT=24
$ENDNET
$MATERIAL NAME=S E=210000 NU=0.3
$MATERIAL NAME=A E=70000 NU=0.33
$PROPERTY ESET=HUB.BODY  MATERIAL=A STATE=STRESS THICK=10
$PROPERTY ESET=BUSH.BODY MATERIAL=S STATE=STRESS THICK=10
$PROPERTY ESET=PIN.BODY  MATERIAL=S STATE=STRESS THICK=10
$NSET NAME=HELD WHERE=(x < -44)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  HELD
$FREEDOM CLASS=PRESCRIBED DOF=XY
  PIN.INNER
$LOAD CASE=MOVE TYPE=DISP
  PIN.INNER 0.05 0
$CONTACT NAME=FIT SLAVE=BUSH.OUTER MASTER=HUB.INNER INTERFERENCE=0.01
$CONTACT NAME=PIN SLAVE=PIN.OUTER MASTER=BUSH.INNER GAP=0.005
$STEP NAME=PRESS
  FIT FIT 1
$STEP NAME=LOAD
  LOAD MOVE 1
$END
)",
                     off);
}

double largest_displacement(const results::LoadStepResult& step) {
  return step.u.cwiseAbs().maxCoeff();
}

double largest_pressure(const results::LoadStepResult& step, std::size_t contact) {
  double most = 0.0;
  for (const results::ContactPoint& p : step.contacts.at(contact).points) {
    most = std::max(most, p.p_lumped);
  }
  return most;
}

class OffAxis : public testing::TestWithParam<double> {};

// The bush can turn by any angle, whoever's axis the normals know: it rests, and nothing moves that
// does not move when all axes are one. Else the pressure of one fit turns it until the other gives.
TEST_P(OffAxis, RoundBodiesRest) {
  const auto centred = test::solve_text(bushed_hub(0.0));
  const auto off = test::solve_text(bushed_hub(GetParam()));
  ASSERT_TRUE(centred && off);
  for (std::size_t step = 0; step < 2; ++step) {
    EXPECT_NEAR(largest_displacement(off->step(step)), largest_displacement(centred->step(step)),
                1e-3 * largest_displacement(centred->step(step)));
    for (std::size_t contact = 0; contact <= step; ++contact) {
      EXPECT_NEAR(largest_pressure(off->step(step), contact),
                  largest_pressure(centred->step(step), contact),
                  0.02 * largest_pressure(centred->step(step), contact));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(By, OffAxis, testing::Values(1e-7, 2e-6, 3e-5, 1e-3));

// A ring of linear elements, all of its circles flattened alike: r = R (1 + flat cos 2 theta).
std::string flattened_ring(double inner, double outer, int sectors, double flat) {
  std::string text = "$COOR SYSTEM=CYL DIM=2 NSET=ALL\n";
  for (int k = 0; k < 2 * sectors; ++k) {
    const int sector = k / 2;
    const double theta = 2.0 * std::numbers::pi * sector / sectors;
    const double r = (k % 2 == 0 ? inner : outer) * (1.0 + flat * std::cos(2.0 * theta));
    text += fmt::format("  {} {:.17g} {:.17g}\n", k + 1, r, theta);
  }
  text += "$ELEMENT TYPE=QUAM4 ESET=BODY\n";
  for (int k = 0; k < sectors; ++k) {
    const int next = (k + 1) % sectors;
    text +=
        fmt::format("  {} {} {} {} {}\n", k + 1, 2 * k + 1, 2 * k + 2, 2 * next + 2, 2 * next + 1);
  }
  return text;
}

// A pin that is not quite round, in a bore that is flattened as it is, turned by a moment: only its
// being flat resists, so it would turn far before it does. The closest answer is none.
TEST(FarMotion, IsNoAnswer) {
  const test::Folder folder;
  const std::string deck =
      fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=HUB
{}$ENDNET
$NET NAME=PIN
{}$ENDNET
$MATERIAL NAME=S E=210000 NU=0.3
$PROPERTY ESET=HUB.BODY MATERIAL=S STATE=STRESS THICK=10
$PROPERTY ESET=PIN.BODY MATERIAL=S STATE=STRESS THICK=10
$NSET NAME=RIM   FROM=HUB.ALL WHERE=(x*x + y*y > 30*30)
$FSET NAME=BORE  FROM=HUB.ALL WHERE=(x*x + y*y < 25*25)
$FSET NAME=ROUND FROM=PIN.ALL WHERE=(x*x + y*y > 15*15)
$NSET NAME=EAST  FROM=PIN.ALL WHERE=(x > 9 and abs(y) < 1e-6 and x < 12)
$NSET NAME=WEST  FROM=PIN.ALL WHERE=(x < -9 and abs(y) < 1e-6 and x > -12)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  RIM
$LOAD CASE=TURN TYPE=FORCE
  EAST 0  500
  WEST 0 -500
$CONTACT NAME=FIT SLAVE=ROUND MASTER=BORE INTERFERENCE=0.05
$STEP NAME=LOAD
  FIT FIT 1
  LOAD TURN 1
$END
)",
                  flattened_ring(20, 40, 48, 4e-4), flattened_ring(10, 20, 48, 4e-4));
  const test::Outcome outcome = test::run_text(folder, deck);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.messages;
  EXPECT_NE(outcome.messages.find("body PIN would move as a rigid body"), std::string::npos)
      << outcome.messages;
  EXPECT_NE(outcome.messages.find("rotation"), std::string::npos) << outcome.messages;
}

} // namespace
} // namespace spricka::test_round_bodies
