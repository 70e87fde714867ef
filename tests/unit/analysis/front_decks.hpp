// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include <fmt/format.h>

/// Small decks with cracks in space.
namespace spricka::test {

/// A block with a surface crack in the plane x = 0, whose mouth lies in the contact with a block
/// that is pressed onto it, the more to one side the larger TILT; `more` stands behind the loads.
inline std::string pressed_mouth(const std::string& more, double E = 1000.0) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=A
  $MESH SHAPE=BLOCK TYPE=TET10 X0=-4 Y0=-4 Z0=-6 LX=8 LY=8 LZ=6 NX=4 NY=4 NZ=3
$ENDNET
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE=HEXEC20 X0=-2 Y0=-2 Z0=0 LX=4 LY=4 LZ=2 NX=4 NY=4 NZ=2
$ENDNET
$MATERIAL NAME=M E={} NU=0.3
$MATERIAL NAME=N E=3000 NU=0.3
$PROPERTY ESET=A.BODY MATERIAL=M STATE=SOLID
$PROPERTY ESET=B.BODY MATERIAL=N STATE=SOLID
$NSET NAME=P1 WHERE=(x < -4 + 1e-6 and y < -4 + 1e-6 and z < -6 + 1e-6)
$NSET NAME=P2 WHERE=(x > 4 - 1e-6 and y < -4 + 1e-6 and z < -6 + 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=Z
  A.ZMIN
$FREEDOM CLASS=SUPPRESSED DOF=XY
  P1
$FREEDOM CLASS=SUPPRESSED DOF=Y
  P2
$NSET NAME=Q1 WHERE=(abs(x) < 1e-6 and abs(y) < 1e-6 and z > 2 - 1e-6)
$NSET NAME=Q2 WHERE=(x > 2 - 1e-6 and abs(y) < 1e-6 and z > 2 - 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  Q1
$FREEDOM CLASS=SUPPRESSED DOF=Y
  Q2
$CRACK NAME=C NET=A A=1 X0=0 Y0=0 Z0=0 NORMAL=X X2=0 Y2=1 Z2=0
$CONTACT NAME=ON SLAVE=A.ZMAX MASTER=B.ZMIN INTERFERENCE=0.0002
$LOAD CASE=PULL TYPE=TRACTION
  A.XMAX  3 0 0
  A.XMIN  -3 0 0
$LOAD CASE=PRESS TYPE=TRACTION
  B.ZMAX  0 0 -1
$LOAD CASE=TILT TYPE=TRACTION
  B.ZMAX  0 0 (x + y/3)
{}$END
)",
                     E, more);
}

} // namespace spricka::test
