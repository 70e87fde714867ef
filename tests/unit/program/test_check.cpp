// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/check_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace spricka::test_check {
namespace {

using nlohmann::json;
using test::check_text;
using test::Checked;
using test::Folder;
using test::growing_crack;
using test::Outcome;
using test::run_text;

// A pin in a hub, the pin's centre off by `off`; radii 20 and 20.5.
std::string rings(double off, const std::string& gap) {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=HUB
  $MESH SHAPE=RING TYPE=QUAMC8 RI=20.5 RO=30 NR=2 NT=48
$ENDNET
$NET NAME=PIN
  $MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=20 X0=)" +
         std::to_string(off) + R"( NR=2 NT=48
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=HUB.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=PIN.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  HUB.OUTER
$CONTACT NAME=FIT SLAVE=PIN.OUTER MASTER=HUB.INNER )" +
         gap + R"(
$LOAD CASE=PUSH TYPE=RESULTANT
  PIN.BODY 1 0
$STEP NAME=PUSH
  LOAD PUSH 1
$END
)";
}

// Two plates, one above the other; widths 6 and 10.
std::string plates(const std::string& more,
                   const std::string& contact = "$CONTACT NAME=FACE SLAVE=TOP.YMIN "
                                                "MASTER=LOW.YMAX\n") {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LOW
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=6 LY=5 NX=4 NY=2
$ENDNET
$NET NAME=TOP
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 Y0=5.25 NX=5 NY=2
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=STRESS
$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LOW.YMIN
)" + contact +
         R"($LOAD CASE=PUSH TYPE=PRESSURE
  TOP.YMAX 1
$LOAD CASE=SIDE TYPE=RESULTANT
  TOP.BODY 5 0
)" + more +
         "$END\n";
}

const std::string press = "$STEP NAME=PRESS\n  LOAD PUSH 1\n";

TEST(ResultCheck, GapOfConcentricRings) {
  const Folder folder;
  const Checked c = check_text(folder, rings(0.0, "DIAMETRAL=0.08"));
  ASSERT_EQ(c.outcome.exit_code, 0) << c.outcome.messages;
  const json& pair = c.found["contacts"][0];
  EXPECT_NEAR(pair["gap"]["low"].get<double>(), 0.5, 1e-4); // edges are parabolas, not arcs
  EXPECT_NEAR(pair["gap"]["high"].get<double>(), 0.5, 1e-4);
  EXPECT_NEAR(pair["gap"]["mean"].get<double>(), 0.5, 1e-4);
  EXPECT_NEAR(pair["declared_gap"].get<double>(), -0.04, 1e-12);
  EXPECT_LT(pair["normals_angle"].get<double>(), 1e-6);
  EXPECT_LT(pair["slave"]["overhang"].get<double>(), 1e-9);
  EXPECT_EQ(pair["slave"]["facing"], 48);
  EXPECT_EQ(pair["master"]["facing"], 48);
}

TEST(ResultCheck, GapAndNormalsOfEccentricRings) {
  const Folder folder;
  const Checked c = check_text(folder, rings(0.25, ""));
  ASSERT_EQ(c.outcome.exit_code, 0) << c.outcome.messages;
  const json& pair = c.found["contacts"][0];
  EXPECT_NEAR(pair["gap"]["low"].get<double>(), 0.25, 1e-4);
  EXPECT_NEAR(pair["gap"]["high"].get<double>(), 0.75, 1e-4);
  EXPECT_TRUE(pair["declared_gap"].is_null());
  // The ray from one centre meets the other circle at sin(angle) = offset / radius or nearly so.
  const double angle = std::asin(0.25 / 20.5) * 180.0 / std::numbers::pi;
  EXPECT_NEAR(pair["normals_angle"].get<double>(), angle, 0.05 * angle);
}

TEST(ResultCheck, OverhangIsWhatSeesNoTarget) {
  const Folder folder;
  const Checked c = check_text(folder, plates(press));
  ASSERT_EQ(c.outcome.exit_code, 0) << c.outcome.messages;
  const json& pair = c.found["contacts"][0];
  EXPECT_NEAR(pair["slave"]["overhang"].get<double>(), 0.4, 1e-9);
  EXPECT_NEAR(pair["master"]["overhang"].get<double>(), 0.0, 1e-9);
  EXPECT_EQ(pair["slave"]["facing"], 3); // edges of 2 over a width of 6
  EXPECT_NEAR(pair["gap"]["low"].get<double>(), 0.25, 1e-12);
  EXPECT_NEAR(pair["gap"]["high"].get<double>(), 0.25, 1e-12);
}

TEST(ResultCheck, RigidModesAreCountedAndNamed) {
  const Folder folder;
  const auto body = [&](const std::string& deck, std::size_t b) {
    return check_text(folder, deck).found["bodies"][b]["modes"];
  };
  const json low = body(plates(press), 0);
  EXPECT_EQ(low["supports"], 3);
  EXPECT_EQ(low["nothing"].size(), 0U);
  const json top = body(plates(press), 1);
  EXPECT_EQ(top["supports"], 0);
  EXPECT_EQ(top["contact"], 2); // up and down, tilt
  EXPECT_EQ(top["nothing"], json::array({"direction X"}));
  // no contact at all: the body is free as to everything
  const json alone = body(plates(press, ""), 1);
  EXPECT_EQ(alone["nothing"], json::array({"direction X", "direction Y", "rotation"}));
  // a pin in a bore: contact feels all but its rotation
  const json pin = body(rings(0.0, "GAP=0"), 1);
  EXPECT_EQ(pin["contact"], 2);
  EXPECT_EQ(pin["nothing"], json::array({"rotation"}));
}

TEST(ResultCheck, WhatNothingHoldsIsRefusedInTheWordsOfTheRun) {
  for (const char* steps : {"$STEP NAME=SHOVE\n  LOAD SIDE 1\n", // nothing stops it sideways
                            "$STEP NAME=PRESS\n  LOAD PUSH 1\n$STEP NAME=LIFT\n  LOAD PUSH -1\n"}) {
    const Folder folder;
    const Checked c = check_text(folder, plates(steps));
    EXPECT_EQ(c.outcome.exit_code, 4);
    const Outcome run = run_text(folder, plates(steps));
    EXPECT_EQ(run.exit_code, 4);
    EXPECT_EQ(c.outcome.messages, run.messages);
    EXPECT_NE(c.outcome.messages.find("body TOP is loaded but not held"), std::string::npos);
    EXPECT_EQ(c.found["exit_code"], 4);
  }
}

TEST(ResultCheck, MistakesOfCardsAreThree) {
  const Folder folder;
  const Checked apart =
      check_text(folder, plates(press, "$CONTACT NAME=FACE SLAVE=TOP.YMAX MASTER=LOW.YMIN\n"));
  EXPECT_EQ(apart.outcome.exit_code, 3);
  EXPECT_NE(apart.outcome.messages.find("E411"), std::string::npos) << apart.outcome.messages;
  // only the third length runs out of the plate
  const Checked long_crack = check_text(folder, growing_crack(6, "1 2 12"));
  EXPECT_EQ(long_crack.outcome.exit_code, 3) << long_crack.outcome.messages;
  EXPECT_NE(long_crack.outcome.messages.find("test.deck:"), std::string::npos);
}

TEST(ResultCheck, WorstElementIsNamedWithItsPlace) {
  const Folder folder;
  const Checked c = check_text(folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$COOR DIM=2
  1  0 0
  2  1 0
  3  2 0
  4  0 1
  5  1 1
  6  3 1
$ELEMENT TYPE=QUAM4 ESET=ALL
  7  1 2 5 4
  9  2 3 6 5
$MATERIAL NAME=M E=1 NU=0
$PROPERTY ESET=ALL MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  1 2
$STEP NAME=S
$END
)");
  ASSERT_EQ(c.outcome.exit_code, 0) << c.outcome.messages;
  const auto of = [&](const std::string& measure) {
    for (const json& q : c.found["quality"]) {
      if (q["measure"] == measure) {
        return q;
      }
    }
    return json();
  };
  EXPECT_EQ(of("smallest angle")["element"], 9);
  EXPECT_NEAR(of("smallest angle")["value"].get<double>(), 45.0, 1e-9);
  EXPECT_NEAR(of("largest angle")["value"].get<double>(), 135.0, 1e-9);
  EXPECT_NEAR(of("aspect")["value"].get<double>(), 2.0, 1e-9);
  EXPECT_EQ(of("scaled Jacobian")["element"], 9);
  EXPECT_LT(of("scaled Jacobian")["value"].get<double>(), 0.95);
  EXPECT_GT(of("scaled Jacobian")["value"].get<double>(), std::sqrt(0.5));
  EXPECT_NEAR(of("aspect")["at"][0].get<double>(), 1.75, 1e-12);
}

TEST(ResultCheck, GrowthPlanShowsEveryLength) {
  const Folder folder;
  const Checked c = check_text(folder, growing_crack(40, "1 2 3.5"));
  ASSERT_EQ(c.outcome.exit_code, 0) << c.outcome.messages;
  const json& lengths = c.found["lengths"];
  ASSERT_EQ(lengths.size(), 3U);
  EXPECT_EQ(lengths[2]["a"], 3.5);
  EXPECT_NEAR(lengths[2]["tips"][0]["at"][0].get<double>(), 3.5, 1e-9);
  EXPECT_NEAR(lengths[2]["tips"][0]["mouth"][1].get<double>(), 10.0, 1e-9);
  EXPECT_GT(lengths[0]["elements_cut"], 0);
  EXPECT_EQ(lengths[1]["nets_reused"], 1); // what no length touches is factorised once
}

TEST(ResultCheck, CracksInSolidsHaveTheirKind) {
  const Folder folder;
  const auto deck = [](const std::string& crack) {
    return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE=TET10 LX=4 LY=4 LZ=8 NX=3 NY=3 NZ=5
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  B.ZMIN
$CRACK NAME=C NET=B )" +
           crack + R"( Z0=4 NORMAL=Z
$LOAD CASE=L TYPE=TRACTION
  B.ZMAX 0 0 1
$STEP NAME=S
  LOAD L 1
$END
)";
  };
  const double pi = std::numbers::pi;
  for (const auto& [crack, kind, length] : {std::tuple("A=0.5 X0=2 Y0=2", "embedded", pi),
                                            {"A=0.5 X0=2 Y0=0", "surface", 0.5 * pi},
                                            {"A=0.5 X0=0 Y0=0", "corner", 0.25 * pi}}) {
    const Checked c = check_text(folder, deck(crack));
    ASSERT_EQ(c.outcome.exit_code, 0) << c.outcome.messages;
    const json& fronts = c.found["lengths"][0]["fronts"];
    ASSERT_EQ(fronts.size(), 1U);
    EXPECT_EQ(fronts[0]["kind"], kind);
    EXPECT_EQ(fronts[0]["front"], "C");
    EXPECT_NEAR(fronts[0]["length"].get<double>(), length, 1e-3 * length);
    EXPECT_NEAR(fronts[0]["a"].get<double>(), 0.5, 1e-3);
    EXPECT_GT(fronts[0]["elements"].get<int>(), 7);
  }
  const Checked through = check_text(folder, deck("A=7 X0=2 Y0=-6"));
  ASSERT_EQ(through.outcome.exit_code, 0) << through.outcome.messages;
  EXPECT_EQ(through.found["lengths"][0]["fronts"][0]["kind"], "through");
}

TEST(ResultCheck, PointsOfASweepAreLookedAt) {
  const Folder folder;
  std::string deck = growing_crack(6, "1 (last)");
  deck.replace(deck.find("$MESH"), 5,
               "$PARAMETER\n  last = 2\n$SWEEP PARAMETER=last\n  2 12\n$MESH");
  const Checked c = check_text(folder, deck);
  EXPECT_EQ(c.outcome.exit_code, 3);
  EXPECT_NE(c.outcome.messages.find("point 002 (last = 12)"), std::string::npos)
      << c.outcome.messages;
  EXPECT_EQ(c.found["sweep"], json::array({"last = 2", "last = 12"}));
}

// Two bars of one element each, tied by their 4 + 4 nodes: dependent freedoms have a column.
TEST(ResultCheck, ListingCountsDependentFreedoms) {
  const Folder folder;
  const std::filesystem::path file = folder.path() / "test.deck";
  std::ofstream(file) << R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=A
  $MESH SHAPE=BLOCK TYPE=HEXE8 LX=2 LY=4 LZ=6 NX=1 NY=1 NZ=1
$ENDNET
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE=HEXE8 X0=2 LX=2 LY=4 LZ=6 NX=1 NY=1 NZ=1
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=A.BODY MATERIAL=M STATE=SOLID
$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  A.XMIN
$MPC TYPE=TRANSITION SLAVE=B.XMIN MASTER=A.XMAX
$LOAD CASE=PULL TYPE=TRACTION
  B.XMAX 1 0 0
$STEP NAME=FULL
  LOAD PULL 1
$END
)";
  program::RunOptions options;
  options.deck = file;
  options.check_only = true;
  testing::internal::CaptureStdout();
  EXPECT_EQ(program::run_deck(options), base::ProgramOutcome::done);
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_NE(text.find("dependent"), std::string::npos) << text;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string net;
    words >> net;
    if (net == "B" && line.find("HEXE8") != std::string::npos) {
      // nodes, elements, local, external, suppressed, prescribed, dependent
      std::vector<int> counts(7);
      for (int& count : counts) {
        words >> count;
      }
      EXPECT_EQ(counts, (std::vector<int>{8, 1, 12, 0, 0, 0, 12})) << line;
      return;
    }
  }
  FAIL() << "no row of net B\n" << text;
}

// Growths by a law, in space: `check` shows the first front, as of any deck.
TEST(ResultCheck, FrontsThatGrow) {
  for (const std::string shape : {"FREE", "ELLIPSE"}) {
    const test::Folder folder;
    const test::Checked checked = test::check_text(
        folder, R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=HEXEC20 X0=-10 Y0=-10 Z0=-10 LX=20 LY=20 LZ=20 NX=4 NY=4 NZ=4
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  ZMIN
$LOAD CASE=PULL TYPE=TRACTION
  ZMAX 0 0 1
$CRACK NAME=C A=0.5 C=1 X0=0 Y0=0 Z0=0 NORMAL=Z
$STEP NAME=FULL
  LOAD PULL 1
$STEP NAME=ZERO
  LOAD PULL 0
$GROW LAW=PARIS SHAPE=)" +
                    shape +
                    R"( KMAX=FULL KMIN=ZERO C=1e-3 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' AMAX=1.2
$END
)");
    EXPECT_EQ(checked.outcome.exit_code, 0) << shape << checked.outcome.messages;
    ASSERT_EQ(checked.found["lengths"].size(), 1U) << shape;
    EXPECT_EQ(checked.found["lengths"][0]["fronts"][0]["kind"], "embedded");
  }
}

} // namespace
} // namespace spricka::test_check
