// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "tests/unit/support/solved_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

/// Plates with cracks whose faces may touch.
namespace spricka::test {

inline const double root_pi = std::sqrt(std::numbers::pi);

// A plate |x|, |y| < 20 with loads on its rim and cracks in it; supports only keep it in place.
inline std::string plate(const std::string& cracks, const std::string& loads, int n = 16) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-20 Y0=-20 LX=40 LY=40 NX={0} NY={0}
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=3
$NSET NAME=LEFT  WHERE=(abs(x+20) < 1e-9 and abs(y+20) < 1e-9)
$NSET NAME=RIGHT WHERE=(abs(x-20) < 1e-9 and abs(y+20) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LEFT
$FREEDOM CLASS=SUPPRESSED DOF=Y
  RIGHT
{1}{2}$END
)",
                     n, cracks, loads);
}

// Stresses (sx, sy, txy) on the rim, and one step.
inline std::string stressed(double sx, double sy, double txy) {
  return fmt::format(R"($LOAD CASE=F TYPE=TRACTION
  XMAX {0} {2}
  XMIN {3} {5}
  YMAX {2} {1}
  YMIN {5} {4}
$STEP NAME=S
  LOAD F 1
)",
                     sx, sy, txy, -sx, -sy, -txy);
}

inline std::string slant(double angle, const std::string& keys) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return fmt::format("$CRACK NAME=C {}\n  {} {}\n  {} {}\n", keys, -c, -s, c, s);
}

// Bending x + r, as in benchmark F11.
inline std::string bent(double r, const std::string& keys = "") {
  return plate("$CRACK NAME=C " + keys + "\n  -1 0\n  1 0\n",
               fmt::format(R"($LOAD CASE=BEND TYPE=TRACTION
  YMAX 0 (x+{0})
  YMIN 0 (-x-{0})
$STEP NAME=S
  LOAD BEND 1
)",
                           r));
}

inline const results::ContactResult& faces(const Solved& solved,
                                           const std::string& name = "C.FACES") {
  const results::ContactResult* found = results::find_contact(solved.step(), name);
  EXPECT_NE(found, nullptr);
  return *found;
}

inline bool was_closed(const Solved& solved) {
  return std::ranges::any_of(solved.run.log, [](const results::LogLine& line) {
    return line.text.find("meet") != std::string::npos;
  });
}

} // namespace spricka::test
