// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace spricka::test {

/// A deck: half a strip of width 20 with an edge crack of 4 along its line of symmetry, tension 50,
/// free ends. `grow`: what stands on $GROW; `more`: cards before it; `path`: of the crack.
inline std::string strip_text(const std::string& grow, const std::string& more = "",
                              const std::string& path = "LINE") {
  return "$DECK VERSION=1 LENGTH=mm FORCE=N\n"
         "$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=20 LY=40 NX=10 NY=20\n"
         "$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)\n"
         "$NSET NAME=PART WHERE=(abs(y) < 1e-9 and x < 8.1) ORDER=(x)\n"
         "$NSET NAME=CORNER WHERE=(abs(y) < 1e-9 and abs(x-20) < 1e-9)\n"
         "$MATERIAL NAME=M E=70000 NU=0.3\n"
         "$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=2\n"
         "$FREEDOM CLASS=SUPPRESSED DOF=Y\n  LINE\n"
         "$FREEDOM CLASS=SUPPRESSED DOF=X\n  CORNER\n"
         "$CRACK NAME=C1 PATH=" +
         path +
         " A0=4\n"
         "$LOAD CASE=PULL TYPE=TRACTION\n  YMAX 0 50\n"
         "$STEP NAME=ZERO\n  LOAD PULL 0\n"
         "$STEP NAME=HALF\n  LOAD PULL 0.5\n"
         "$STEP NAME=FULL\n  LOAD PULL 1\n" +
         more + "$GROW KUNIT='MPa*mm^0.5' AUNIT='mm' " + grow + "\n$END\n";
}

} // namespace spricka::test
