// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include <fmt/format.h>

namespace spricka::test {

/// Elements along the radii and round them, and where the crack starts [deg].
struct PinnedRing {
  int hub_rings = 2, pin_rings = 1, sectors = 16;
  double crack_at = 90.0;
};

/// A ring with a crack, held on its left, and a floating pin pressed into it (contact FIT, 0.01)
/// that the load case PULL pulls; `steps`: the cards that follow.
inline std::string pinned_ring(const PinnedRing& of, const std::string& steps) {
  const std::string mesh = fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=HUB
  $MESH SHAPE=RING TYPE=QUAMC8 RI=20 RO=50 NR={} NT={}
$ENDNET
$NET NAME=PIN
  $MESH SHAPE=RING TYPE=QUAMC8 RI=5 RO=20 NR={} NT={}
$ENDNET
)",
                                       of.hub_rings, of.sectors, of.pin_rings, of.sectors);
  const std::string crack = fmt::format(R"($CRACK NAME=C NET=HUB ANGLE={0}[deg] A0=8
  (20*cos({0}[deg])) (20*sin({0}[deg]))
)",
                                        of.crack_at);
  return mesh + R"($MATERIAL NAME=S E=210000 NU=0.3
$MATERIAL NAME=A E=70000 NU=0.33
$PROPERTY ESET=HUB.BODY MATERIAL=A STATE=STRESS THICK=10
$PROPERTY ESET=PIN.BODY MATERIAL=S STATE=STRESS THICK=10
$NSET NAME=HELD WHERE=(x < -44)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  HELD
$NSET NAME=KEY WHERE=(abs(x - 5) + abs(y) < 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  KEY
$LOAD CASE=PULL TYPE=RESULTANT
  PIN.BODY 20000 0
$CONTACT NAME=FIT SLAVE=PIN.OUTER MASTER=HUB.INNER INTERFERENCE=0.01
)" + crack +
         steps + "$END\n";
}

} // namespace spricka::test
