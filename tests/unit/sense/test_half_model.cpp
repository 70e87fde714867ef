// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace spricka::test_half_model {
namespace {

// Largest difference of displacements where the part has elements, to the largest of the whole.
double difference(const test::Solved& whole, const test::Solved& part) {
  const std::vector<bool> used = model::mark_nodes_in_use(part.mesh());
  const results::LoadStepResult& last = whole.run.increments.front().steps.back();
  double off = 0.0;
  double size = 0.0;
  for (std::size_t n = 0; n < used.size(); ++n) {
    const base::Vec3 u = whole.vector(last.u, base::NodeId(n));
    size = std::max(size, u.norm());
    if (used[n]) {
      off = std::max(
          off,
          (part.vector(part.run.increments.front().steps.back().u, base::NodeId(n)) - u).norm());
    }
  }
  return off / size;
}

// The same with one of its sides alone; of how many elements the part has as many.
void expect_same(const std::string& deck, const std::string& cards, int parts) {
  const std::string end = "$END\n";
  ASSERT_TRUE(deck.ends_with(end));
  const auto whole = test::solve_text(deck);
  const auto part = test::solve_text(deck.substr(0, deck.size() - end.size()) + cards + end);
  ASSERT_TRUE(whole && part) << deck;
  EXPECT_EQ(part->mesh().element_count() * static_cast<std::size_t>(parts),
            whole->mesh().element_count());
  EXPECT_LT(difference(*whole, *part), 1e-9) << cards << deck;
}

// A ring held outside, loaded in its bore.
std::string ring(const std::string& loads) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=30 NR=3 NT=24
$MATERIAL NAME=M E=200000 NU=0.3 ALPHA=1e-5
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=2
$NSET NAME=MIDDLE WHERE=(abs(y) < 1e-6 and x > 0)
$NSET NAME=EAST FROM=INNER WHERE=(x > -1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  OUTER
{}$STEP NAME=S
  LOAD F 1
$END
)",
                     loads);
}

TEST(HalfModel, LoadsOfTheWholeActWithTheirOwnHalf) {
  const std::string above = "$SYMMETRY NORMAL=Y\n";
  const std::string below = "$SYMMETRY NORMAL=Y KEEP=BELOW\n";
  for (const char* load :
       {"TYPE=RESULTANT\n  BODY 500 0\n", "TYPE=RESULTANT\n  EAST 500 0\n",
        "TYPE=BEARING SHAPE=COSINE\n  INNER 500 0\n", "TYPE=BEARING SHAPE=UNIFORM\n  INNER 500 0\n",
        "TYPE=BEARING SHAPE=COSINE\n  EAST 500 0\n", "TYPE=FORCE\n  MIDDLE (3*x) 0\n",
        "TYPE=FORCE\n  INNER (x) (y)\n", "TYPE=TRACTION\n  EAST 3 (2*y)\n",
        "TYPE=PRESSURE\n  INNER (30 + x)\n", "TYPE=BODY\n  BODY 1 (y)\n",
        "TYPE=TEMPERATURE\n  BODY (x + y*y)\n"}) {
    const std::string deck = ring(std::string("$LOAD CASE=F ") + load);
    expect_same(deck, above, 2);
    expect_same(deck, below, 2);
  }
  expect_same(ring("$LOAD CASE=F TYPE=PRESSURE\n  INNER 30\n"),
              "$SYMMETRY NORMAL=X\n$SYMMETRY NORMAL=Y KEEP=BELOW\n", 4);
}

TEST(HalfModel, ContactsAndTheirMountsStay) {
  const std::string deck = R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=PIN
$MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=10 NR=4 NT=32
$ENDNET
$NET NAME=BUSH
$MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=12 NR=1 NT=48
$ENDNET
$NET NAME=RING
$MESH SHAPE=RING TYPE=QUAMC8 RI=12 RO=30 NR=4 NT=40
$ENDNET
$MATERIAL NAME=M E=200000 NU=0.3
$PROPERTY ESET=PIN.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=BUSH.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=RING.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  RING.OUTER
$LOAD CASE=F TYPE=RESULTANT
  PIN.BODY 500 0
$CONTACT NAME=FIT SLAVE=BUSH.OUTER MASTER=RING.INNER DIAMETRAL=0.05
$CONTACT NAME=PIN SLAVE=PIN.OUTER MASTER=BUSH.INNER GAP=0
$STEP NAME=PRESS
  FIT FIT 1
$STEP NAME=MOUNT
  MOUNT PIN
$STEP NAME=LOAD
  LOAD F 1
$END
)";
  const auto whole = test::solve_text(deck);
  const auto half =
      test::solve_text(deck.substr(0, deck.size() - 5) + "$SYMMETRY NORMAL=Y\n$END\n");
  ASSERT_TRUE(whole && half);
  const std::vector<bool> used = model::mark_nodes_in_use(half->mesh());
  for (std::size_t s = 0; s < 3; ++s) {
    double off = 0.0;
    for (std::size_t n = 0; n < used.size(); ++n) {
      const base::NodeId node(n);
      const base::Vec3 there = whole->vector(whole->step(s).u, node);
      const base::Vec3 here = half->vector(half->step(s).u, node);
      off = used[n] ? std::max(off, (there - here).norm()) : off;
    }
    EXPECT_LT(off, 1e-9 * 0.05) << s;
  }
}

// Two blocks beside each other, each pressed on a foot: mirror images with names of their own.
TEST(HalfModel, OfTwoImagesOneIsLeft) {
  std::string deck = "$DECK VERSION=1 LENGTH=mm FORCE=N\n$MATERIAL NAME=M E=200000 NU=0.3\n";
  for (const auto& [name, x] : {std::pair{"A", -3}, std::pair{"B", 1}}) {
    deck += fmt::format(R"($NET NAME=FOOT{0}
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0={1} Y0=-1 LX=2 LY=1 NX=4 NY=2
$ENDNET
$NET NAME=TOP{0}
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0={1} Y0=0 LX=2 LY=1 NX=4 NY=2
$ENDNET
$PROPERTY ESET=FOOT{0}.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=TOP{0}.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  FOOT{0}.YMIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  TOP{0}.XMIN TOP{0}.XMAX
$CONTACT NAME={0} SLAVE=TOP{0}.YMIN MASTER=FOOT{0}.YMAX GAP=0
$LOAD CASE=F TYPE=RESULTANT
  TOP{0}.YMAX 0 -100
)",
                        name, x);
  }
  deck += "$STEP NAME=FIRST\n  MOUNT B\n  MOUNT A\n$STEP NAME=S\n  LOAD F 1\n$END\n";
  const auto half =
      test::solve_text(deck.substr(0, deck.size() - 5) + "$SYMMETRY NORMAL=X\n$END\n");
  ASSERT_TRUE(half);
  ASSERT_EQ(half->model.contacts.size(), 1U);
  EXPECT_EQ(half->model.contacts.front().name, "B");
  EXPECT_EQ(half->model.steps.front().actions.size(), 1U);
  const auto whole = test::solve_text(deck);
  ASSERT_TRUE(whole);
  EXPECT_LT(difference(*whole, *half), 1e-9);
}

// What went with the other side is told of where it is asked for.
TEST(HalfModel, WhatIsAskedOfTheOtherSideIsToldOf) {
  const std::string load = "$LOAD CASE=F TYPE=PRESSURE\n  INNER 5\n";
  const std::string west = "$NSET NAME=WEST FROM=INNER WHERE=(x < -1)\n";
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(
      folder, ring(load + west + "$SYMMETRY NORMAL=X\n$OUTPUT FILE='u.csv' FORMAT=CSV\n  U EAST\n" +
                   "  U WEST\n$CHECK\n  U.X.MIN(WEST,S) = 0 ABS 1 SOURCE 'none'\n"));
  EXPECT_EQ(outcome.exit_code, 1) << outcome.messages;
  const std::string words = "WEST lies on the side that $SYMMETRY leaves away";
  const std::size_t first = outcome.messages.find(words);
  ASSERT_NE(first, std::string::npos) << outcome.messages;
  EXPECT_NE(outcome.messages.find(words, first + 1), std::string::npos) << outcome.messages;
}

std::string block(const std::string& type, const std::string& more) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE={} X0=-2 Y0=-1 Z0=-1 LX=4 LY=2 LZ=2 NX=4 NY=2 NZ=2
$MATERIAL NAME=M E=200000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  XMIN
{}$STEP NAME=S
  LOAD F 1
$END
)",
                     type, more);
}

TEST(HalfModel, SolidsAreHalvedAsWell) {
  const std::string loads = "$LOAD CASE=F TYPE=RESULTANT\n  XMAX 500 0 0\n"
                            "$LOAD CASE=F TYPE=TRACTION\n  ZMAX 3 (y) 4\n  ZMIN 3 (y) -4\n";
  for (const char* type : {"HEXEC20", "HEXE8", "HEXEC27"}) {
    expect_same(block(type, loads), "$SYMMETRY NORMAL=Y\n", 2);
    expect_same(block(type, loads), "$SYMMETRY NORMAL=Z KEEP=BELOW\n$SYMMETRY NORMAL=Y\n", 4);
  }
}

// A ring of hexahedra, 24 round, in nodes by r, theta and z.
std::string solid_ring(const std::string& load) {
  constexpr int round = 24;
  constexpr int layers = 3; // of nodes, across and along
  const auto label = [](int r, int t, int z) { return 1 + t % round + round * (r + layers * z); };
  std::string nodes;
  std::string elements;
  for (int z = 0; z < layers; ++z) {
    for (int r = 0; r < layers; ++r) {
      for (int t = 0; t < round; ++t) {
        nodes += fmt::format("  {} {} ({}*pi/12) {}\n", label(r, t, z), 10 + 8 * r, t, 5 * z);
        if (r + 1 < layers && z + 1 < layers) {
          elements += fmt::format("  {} {} {} {} {} {} {} {} {}\n", label(r, t, z), label(r, t, z),
                                  label(r + 1, t, z), label(r + 1, t + 1, z), label(r, t + 1, z),
                                  label(r, t, z + 1), label(r + 1, t, z + 1),
                                  label(r + 1, t + 1, z + 1), label(r, t + 1, z + 1));
        }
      }
    }
  }
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$COOR SYSTEM=CYL DIM=3
{}$ELEMENT TYPE=HEXE8 ESET=BODY
{}$MATERIAL NAME=M E=200000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID
$NSET NAME=INNER WHERE=(rho < 10.1)
$NSET NAME=OUTER WHERE=(rho > 25.9)
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  OUTER
$LOAD CASE=F {}
$STEP NAME=S
  LOAD F 1
$END
)",
                     nodes, elements, load);
}

// Half the pressure of a pin presses across the plane as well.
TEST(HalfModel, APinInSpacePressesOnItsHalf) {
  for (const char* shape : {"COSINE", "UNIFORM"}) {
    const std::string deck =
        solid_ring(fmt::format("TYPE=BEARING SHAPE={}\n  INNER 500 0 0", shape));
    expect_same(deck, "$SYMMETRY NORMAL=Y\n", 2);
    expect_same(deck, "$SYMMETRY NORMAL=Z\n$SYMMETRY NORMAL=Y KEEP=BELOW\n", 4);
    // On a part of the bore beside the load what is left across it is balanced along the bore.
    std::string beside = deck;
    beside.replace(beside.find("(rho < 10.1)"), 12, "(rho < 10.1 and y > -6)");
    expect_same(beside, "$SYMMETRY NORMAL=Z\n", 2);
  }
}

// What a deck with $SYMMETRY is refused for.
std::string refusal(const std::string& deck) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(folder, deck);
  EXPECT_EQ(outcome.exit_code, 3) << outcome.messages;
  return outcome.messages;
}

TEST(HalfModel, WhatStandsAgainstThePlaneIsNamed) {
  const std::string half = "$SYMMETRY NORMAL=Y\n";
  const auto expect = [&](const std::string& deck, const std::string& words) {
    const std::string said = refusal(deck);
    EXPECT_NE(said.find("E354"), std::string::npos) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  expect(ring("$LOAD CASE=F TYPE=RESULTANT\n  BODY 500 3\n" + half),
         "load case F is not mirrored by it");
  expect(ring("$LOAD CASE=F TYPE=RESULTANT\n  BODY 500 0\n$FREEDOM CLASS=SUPPRESSED DOF=X\n  3\n" +
              half),
         "the supports along x are not mirrored by it");
  std::string odd = ring("$LOAD CASE=F TYPE=PRESSURE\n  INNER 5\n" + half);
  odd.replace(odd.find("NT=24"), 5, "NT=25");
  expect(odd, "lies across it, which must be a line of the mesh");
  const std::string load = "$LOAD CASE=F TYPE=PRESSURE\n  INNER 5\n";
  expect(ring(load + half + "$CRACK NAME=C\n  14 0\n  18 0\n"),
         "crack C lies in it and does not begin at a surface");
  expect(ring(load + half + "$CRACK NAME=C\n  10 1\n  14 1\n"), "crack C is not mirrored by it");
  expect(ring(load + half + "$CRACK NAME=C LINE=SMOOTH\n  14 -4\n  16 0\n  14 4\n"),
         "crack C is a smooth curve across it");
  expect(block("HEXEC20", "$LOAD CASE=F TYPE=PRESSURE\n  XMAX 1\n" + half +
                              "$CRACK NAME=C A=0.3 X0=0 Y0=0 Z0=0 NORMAL=Y\n"),
         "crack C lies in it");
}

TEST(HalfModel, APlaneIsNamedOnceAndLiesInSpace) {
  const std::string load = "$LOAD CASE=F TYPE=PRESSURE\n  INNER 5\n";
  EXPECT_NE(refusal(ring(load + "$SYMMETRY NORMAL=Y\n$SYMMETRY NORMAL=Y KEEP=BELOW\n"))
                .find("a second $SYMMETRY with NORMAL=Y"),
            std::string::npos);
  EXPECT_NE(refusal(ring(load + "$SYMMETRY NORMAL=Z\n")).find("E313"), std::string::npos);
}

// A straight crack with two tips across the plane: K of the half is K of the whole.
TEST(HalfModel, ACrackAcrossBeginsInThePlane) {
  const std::string deck = R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-10 Y0=-10 LX=20 LY=20 NX=20 NY=20
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=1
$NSET NAME=FOOT WHERE=(abs(x) < 1e-9 and y < 1e-9 - 10)
$NSET NAME=HEAD WHERE=(abs(x) < 1e-9 and y > 10 - 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  FOOT
$FREEDOM CLASS=SUPPRESSED DOF=X
  HEAD
$CRACK NAME=C
  -4 1
  -2 0
  2 0
  4 1
$LOAD CASE=F TYPE=TRACTION
  YMAX 0 100
  YMIN 0 -100
$LOAD CASE=F TYPE=PRESSURE
  C.LEFT 60
$STEP NAME=S
  LOAD F 1
$END
)";
  const auto whole = test::solve_text(deck);
  for (const char* side : {"ABOVE", "BELOW"}) {
    const auto half = test::solve_text(deck.substr(0, deck.size() - 5) +
                                       fmt::format("$SYMMETRY NORMAL=X KEEP={}\n$END\n", side));
    ASSERT_TRUE(whole && half);
    ASSERT_EQ(whole->step().fronts.size(), 2U);
    ASSERT_EQ(half->step().fronts.size(), 1U);
    const results::FrontPointResult& tip = half->step().fronts.front().single_point();
    EXPECT_NEAR(tip.K1 / whole->step().fronts.front().single_point().K1, 1.0, 1e-3);
    EXPECT_NEAR(std::abs(tip.K2 / whole->step().fronts.front().single_point().K2), 1.0, 1e-2);
  }
}

// Cracks that are drawn in the plane: at a bore, and inside where another plane cuts them.
TEST(HalfModel, ACrackInThePlaneOpensByHalf) {
  const std::string faces = R"($CRACK NAME=C
  10 0
  14 0
$LOAD CASE=F TYPE=PRESSURE
  INNER 30
$LOAD CASE=F TYPE=FACES
  C (x)
)";
  const auto whole = test::solve_text(ring(faces));
  for (const char* side : {"ABOVE", "BELOW"}) {
    const auto half =
        test::solve_text(ring(faces + fmt::format("$SYMMETRY NORMAL=Y KEEP={}\n", side)));
    ASSERT_TRUE(whole && half);
    EXPECT_NEAR(half->step().fronts.front().single_point().K1 /
                    whole->step().fronts.front().single_point().K1,
                1.0, 1e-3);
    EXPECT_EQ(half->step().fronts.front().single_point().K2, 0.0);
    EXPECT_EQ(half->step().fronts.front().name, "C");
  }
}

TEST(HalfModel, AQuarterHoldsHalfACentreCrack) {
  const std::string deck = R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-10 Y0=-20 LX=20 LY=40 NX=20 NY=40
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=1
$SYMMETRY NORMAL=Y
$SYMMETRY NORMAL=X
$CRACK NAME=C
  -4 0
  4 0
$LOAD CASE=F TYPE=TRACTION
  YMAX 0 100
  YMIN 0 -100
$STEP NAME=S
  LOAD F 1
$END
)";
  const auto quarter = test::solve_text(deck);
  ASSERT_TRUE(quarter);
  ASSERT_EQ(quarter->step().fronts.size(), 1U);
  // Isida 1971 for a/W = 0.4 and a long plate, by Feddersen's secant to 3e-3
  const double K = 100 * std::sqrt(std::numbers::pi * 4 / std::cos(0.2 * std::numbers::pi));
  EXPECT_NEAR(quarter->step().fronts.front().single_point().K1 / K, 1.0, 3e-3);
}

// Pressure on one face only is no mirror image of itself, pressure on both that grows is.
TEST(HalfModel, PressureOnFacesIsComparedFaceByFace) {
  const auto with = [](const char* load) {
    return ring(std::string("$SYMMETRY NORMAL=Y\n$CRACK NAME=C\n  10 0\n  14 0\n$LOAD CASE=F ") +
                load);
  };
  EXPECT_NE(refusal(with("TYPE=PRESSURE\n  C.LEFT 3\n")).find("load case F is not mirrored"),
            std::string::npos);
  EXPECT_TRUE(test::solve_text(with("TYPE=PRESSURE\n  C.LEFT (x)\n  C.RIGHT (x)\n")));
}

} // namespace
} // namespace spricka::test_half_model
