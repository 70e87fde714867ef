// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/check_text.hpp"

#include <map>

#include <fmt/format.h>

namespace spricka::test_mirrors {
namespace {

// What stands against each plane that is offered, by "y 0"; empty: nothing does.
std::map<std::string, std::string> mirrors(const std::string& deck) {
  const test::Folder folder;
  const test::Checked checked = test::check_text(folder, deck);
  EXPECT_EQ(checked.outcome.exit_code, 0) << checked.outcome.messages;
  std::map<std::string, std::string> found;
  for (const auto& mirror : checked.found["symmetry"]) {
    found[fmt::format("{} {:g}", mirror["across"].get<std::string>(), mirror["at"].get<double>())] =
        mirror["against"];
  }
  return found;
}
using Found = std::map<std::string, std::string>;

// A pin in a ring, both round x = 3.
std::string joint(const std::string& force, const std::string& more = "",
                  const std::string& ring = "X0=3 NR=4 NT=40") {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=PIN
$MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=10 X0=3 NR=4 NT=48
$ENDNET
$NET NAME=RING
$MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=20 {2}
$ENDNET
$MATERIAL NAME=M E=200000 NU=0.3
$PROPERTY ESET=PIN.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=RING.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  RING.OUTER
$LOAD CASE=F TYPE=RESULTANT
  PIN.BODY {0}
{1}
$CONTACT NAME=C SLAVE=PIN.OUTER MASTER=RING.INNER DIAMETRAL=0.05
$STEP NAME=S
  FIT C 1
  LOAD F 1
$END
)",
                     force, more, ring);
}

TEST(Mirrors, ALoadAlongAPlaneLeavesIt) {
  EXPECT_EQ(mirrors(joint("500 0")), (Found{{"x 3", "load case F is not"}, {"y 0", ""}}));
  EXPECT_EQ(mirrors(joint("0 500")), (Found{{"x 3", ""}, {"y 0", "load case F is not"}}));
  EXPECT_EQ(mirrors(joint("500 300")),
            (Found{{"x 3", "load case F is not"}, {"y 0", "load case F is not"}}));
}

TEST(Mirrors, FieldsAreAskedWithinBodiesToo) {
  const std::string even = "$LOAD CASE=F TYPE=TEMPERATURE\n  RING.BODY (20 + y*y)\n";
  const std::string odd = "$LOAD CASE=F TYPE=TEMPERATURE\n  RING.BODY (20 + y)\n";
  EXPECT_EQ(mirrors(joint("500 0", even)).at("y 0"), "");
  // Zero but for round-off where y = 10 and where y = -10.
  const std::string zero = "$LOAD CASE=F TYPE=TEMPERATURE\n  RING.BODY (cos(pi*y/20))\n";
  EXPECT_EQ(mirrors(joint("500 0", zero)).at("y 0"), "");
  EXPECT_EQ(mirrors(joint("500 0", odd)).at("y 0"), "load case F is not");
}

TEST(Mirrors, NothingIsOfferedWhereBodiesAreNot) {
  // The pin lies 0.5 beside the middle of the ring: only the line through both centres is left.
  const Found found = mirrors(joint("500 0", "", "X0=3.5 NR=4 NT=40"));
  EXPECT_EQ(found, (Found{{"y 0", ""}}));
}

// A plate held at its right edge and pulled up and down; meshes of triangles are not mirrored.
std::string plate(const std::string& cracks, const std::string& down = "0 -1") {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=TRIMC6 LX=10 LY=20 NX=10 NY=21
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  XMAX
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 0 1
  YMIN {1}
{0}
$STEP NAME=PULL
  LOAD PULL 1
$END
)",
                     cracks, down);
}

TEST(Mirrors, CracksHaveImages) {
  const auto crack = [](char name, double y, double angle) {
    return fmt::format("$CRACK NAME={} A0=2 ANGLE=({:g}[deg])\n  0 {:g}\n", name, angle, y);
  };
  EXPECT_EQ(mirrors(plate("")), (Found{{"x 5", "the supports along x are not"}, {"y 10", ""}}));
  EXPECT_EQ(mirrors(plate("", "0 -1.001")).at("y 10"), "load case PULL is not");
  EXPECT_EQ(mirrors(plate(crack('C', 10, 0))).at("y 10"), "");
  EXPECT_EQ(mirrors(plate(crack('C', 12, 0))).at("y 10"), "crack C is not");
  EXPECT_EQ(mirrors(plate(crack('C', 7, 20) + crack('D', 13, -20))).at("y 10"), "");
  EXPECT_EQ(mirrors(plate(crack('C', 7, 20) + crack('D', 13, 20))).at("y 10"), "crack C is not");
}

// Strips that begin and end between the nodes of a side, and between those of a body.
TEST(Mirrors, LoadsAreAskedBetweenNodes) {
  const auto strip = [](double from) {
    return fmt::format("(y > {:g})*(y < {:g})", from, from + 0.31);
  };
  const auto with = [](const std::string& load) {
    return mirrors(plate("$LOAD CASE=PULL " + load)).at("y 10");
  };
  const std::string one = strip(12.51);
  const std::string both = one + " + " + strip(20.0 - 12.51 - 0.31);
  for (const char* load : {"TYPE=PRESSURE\n  XMIN (", "TYPE=TEMPERATURE\n  BODY (",
                           "TYPE=BODY\n  BODY 1 0\n  BODY ("}) {
    const std::string end = std::string(load).find(" 1 0") == std::string::npos ? ")" : ") 0";
    EXPECT_EQ(with(fmt::format("{}{}{}", load, one, end)), "load case PULL is not") << load;
    EXPECT_EQ(with(fmt::format("{}{}{}", load, both, end)), "") << load;
  }
}

// Two loads above the plane and one below: the one is the image of one of them.
TEST(Mirrors, ALoadIsTheImageOfOneLoad) {
  const std::string sets = "$FSET NAME=UP FROM=XMIN WHERE=(y > 10.4)\n"
                           "$FSET NAME=DOWN FROM=XMIN WHERE=(y < 9.6)\n";
  const std::string pair = sets + "$LOAD CASE=PULL TYPE=PRESSURE\n  UP 1\n  DOWN 1\n";
  EXPECT_EQ(mirrors(plate(pair)).at("y 10"), "");
  EXPECT_EQ(mirrors(plate(pair + "  UP 1\n")).at("y 10"), "load case PULL is not");
  EXPECT_EQ(mirrors(plate(pair + "  UP 1\n  DOWN 1\n")).at("y 10"), "");
  // The image of UP lies within the whole side, which is its own image.
  EXPECT_EQ(mirrors(plate(sets + "$LOAD CASE=PULL TYPE=PRESSURE\n  XMIN 1\n  UP 1\n")).at("y 10"),
            "load case PULL is not");
}

// Pressure on one side of a crack that lies across the plane, between all points of a grid.
TEST(Mirrors, FacesOfCracksAreAskedEverywhere) {
  const auto with = [](const std::string& value) {
    return mirrors(plate("$CRACK NAME=C\n  5 8\n  5 12\n$LOAD CASE=PULL TYPE=FACES\n  C (" + value +
                         ")"))
        .at("y 10");
  };
  EXPECT_EQ(with("exp(-((y-10.73)/0.05)^2)"), "load case PULL is not");
  EXPECT_EQ(with("exp(-((y-10.73)/0.05)^2) + exp(-((y-9.27)/0.05)^2)"), "");
}

TEST(Mirrors, EllipsesAndTheirPlanes) {
  const auto block = [](const std::string& crack) {
    return mirrors(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=HEXEC20 LX=20 LY=20 LZ=20 NX=5 NY=5 NZ=5
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  YMIN YMAX
$LOAD CASE=HOT TYPE=TEMPERATURE
  BODY 1
{}
$STEP NAME=HOT
  LOAD HOT 1
$END
)",
                               crack));
  };
  EXPECT_EQ(block("$CRACK NAME=C A=2 C=3 X0=10 Y0=10 Z0=10 NORMAL=Y"),
            (Found{{"x 10", ""}, {"y 10", ""}, {"z 10", ""}}));
  EXPECT_EQ(block("$CRACK NAME=C A=2 C=3 X0=9 Y0=10 Z0=10 NORMAL=Y"),
            (Found{{"x 10", "crack C is not"}, {"y 10", ""}, {"z 10", ""}}));
  EXPECT_EQ(block("$CRACK NAME=C A=2 X0=10 Y0=10 Z0=10 X1=11 Y1=11 Z1=10"),
            (Found{{"x 10", "crack C is not"}, {"y 10", "crack C is not"}, {"z 10", ""}}));
}

} // namespace
} // namespace spricka::test_mirrors
