// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/convert.hpp"
#include "tests/unit/support/run_text.hpp"

#include <charconv>

namespace spricka::test_convert {
namespace {

using test::Folder;
using test::Outcome;

Outcome convert(const Folder& folder, const std::string& in, const std::string& out,
                bool replace = true) {
  testing::internal::CaptureStderr();
  Outcome outcome;
  outcome.exit_code = base::exit_code(program::convert_mesh_or_deck(
      {folder.path() / in, folder.path() / out, {}, program::LogFormat::text, replace}));
  outcome.messages = testing::internal::GetCapturedStderr();
  return outcome;
}

// Two nets whose numbers clash; a pressure of 10 on a side of 3 and a thickness of 2, twice.
std::string two_plates(const std::string& more = "") {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N TITLE='two plates'
$NET NAME=A
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=4 LY=3 NX=2 NY=2
$ENDNET
$NET NAME=B
  $MESH SHAPE=BLOCK TYPE=TRIM3 X0=10 LX=4 LY=3 NX=2 NY=2
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3 RHO=7.8e-9
$PROPERTY ESET=A.BODY MATERIAL=M STATE=STRESS THICK=2
$PROPERTY ESET=B.BODY MATERIAL=M STATE=STRAIN THICK=2
$FREEDOM CLASS=SUPPRESSED DOF=XY
  A.XMIN B.XMIN
$LOAD CASE=PUSH TYPE=PRESSURE
  A.XMAX 10
  B.XMAX 10
$STEP NAME=FIRST
  LOAD PUSH 2
$STEP NAME=SECOND
  LOAD PUSH 3
)" + more +
         "$END\n";
}

void write(const Folder& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder.path() / name) << text;
}

/// Sum of the values of a keyword's lines in direction 1.
double sum_of_loads(const std::string& text) {
  double sum = 0.0;
  std::istringstream lines(text.substr(text.find("*CLOAD")));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line[0] != '*') {
    const std::size_t dof = line.find(", ") + 2;
    const std::size_t value = line.find(", ", dof) + 2;
    double number = 0.0;
    std::from_chars(line.data() + value, line.data() + line.size(), number);
    sum += line[dof] == '1' ? number : 0.0;
  }
  return sum;
}

TEST(Convert, TheFirstStepOfADeckBecomesNodalForcesAndSupports) {
  const Folder folder;
  write(folder, "a.deck", two_plates());
  const Outcome outcome = convert(folder, "a.deck", "a.inp");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_NE(outcome.messages.find("only the first of 2 steps"), std::string::npos);
  const std::string text = test::slurp(folder.path() / "a.inp");
  EXPECT_NEAR(sum_of_loads(text), -2.0 * 2.0 * 10.0 * 3.0 * 2.0, 1e-10);
  for (const char* part : {"TYPE=CPS8", "TYPE=CPE3", "ELSET=A_BODY", "NAME=B_XMAX", "*DENSITY"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  // a mesh has no step: the words say where it is
  const Outcome back = convert(folder, "a.inp", "b.msh");
  EXPECT_EQ(back.exit_code, 0);
  EXPECT_NE(back.messages.find("*STEP (1, line "), std::string::npos) << back.messages;
}

TEST(Convert, ADeckOfAnInpHasItsForcesAndSupports) {
  const Folder folder;
  write(folder, "a.deck", two_plates());
  ASSERT_EQ(convert(folder, "a.deck", "a.inp").exit_code, 0);
  const Outcome begun = convert(folder, "a.inp", "b.deck");
  EXPECT_EQ(begun.exit_code, 0) << begun.messages;
  EXPECT_EQ(begun.messages.find("W467"), std::string::npos) << begun.messages; // all is taken
  const std::string deck = test::slurp(folder.path() / "b.deck");
  for (const char* part : {"$NET NAME=A_BODY\n", "ESET='B_BODY'\n", "$STEP NAME=STEP_1\n",
                           "$FREEDOM CLASS=SUPPRESSED DOF=XY\n"}) {
    EXPECT_NE(deck.find(part), std::string::npos) << part << deck;
  }
  const Outcome again = convert(folder, "b.deck", "c.inp");
  EXPECT_EQ(again.exit_code, 0) << again.messages;
  const std::string text = test::slurp(folder.path() / "c.inp");
  EXPECT_NEAR(sum_of_loads(text), -2.0 * 2.0 * 10.0 * 3.0 * 2.0, 1e-9);
  EXPECT_EQ(convert(folder, "a.deck", "d.deck").exit_code, 2);
}

// A solid bar of 2 x 3 x 10: the resultants of a traction, a pressure, a body force and a bearing.
TEST(Convert, LoadsInSpaceBecomeNodalForces) {
  const Folder folder;
  const auto sum = [&](const std::string& load) {
    write(folder, "b.deck",
          "$DECK VERSION=1 LENGTH=mm FORCE=N\n"
          "$MESH SHAPE=BLOCK TYPE=HEXEC20 LX=2 LY=3 LZ=10 NX=2 NY=2 NZ=3\n"
          "$MATERIAL NAME=M E=1000 NU=0.3 ALPHA=1e-5\n"
          "$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID\n"
          "$FREEDOM CLASS=SUPPRESSED DOF=XYZ\n  ZMIN\n$LOAD CASE=F TYPE=" +
              load + "\n$STEP NAME=S\n  LOAD F 2\n$END\n");
    const Outcome outcome = convert(folder, "b.deck", "b.inp");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
    return sum_of_loads(test::slurp(folder.path() / "b.inp"));
  };
  EXPECT_NEAR(sum("TRACTION\n  ZMAX 5 0 0"), 2.0 * 5.0 * 6.0, 1e-11);
  EXPECT_NEAR(sum("PRESSURE\n  XMAX 5"), -2.0 * 5.0 * 30.0, 1e-10);
  EXPECT_NEAR(sum("BODY\n  BODY 0.5 0 0"), 2.0 * 0.5 * 60.0, 1e-11);
  EXPECT_NEAR(sum("RESULTANT\n  BODY 7 0 0"), 14.0, 1e-11);
}

TEST(Convert, TemperaturesBelongToNodes) {
  const Folder folder;
  const auto deck = [&](const std::string& alpha, const std::string& lines) {
    write(folder, "h.deck",
          "$DECK VERSION=1 LENGTH=mm FORCE=N\n"
          "$MESH SHAPE=BLOCK TYPE=QUAM4 LX=2 LY=1 NX=2 NY=1\n"
          "$ESET NAME=L WHERE=(x < 1.1)\n$ESET NAME=R WHERE=(x > 0.9)\n"
          "$MATERIAL NAME=M E=1000 NU=0.3 ALPHA=1e-5\n"
          "$MATERIAL NAME=N E=1000 NU=0.3" +
              alpha +
              "\n$PROPERTY ESET=L MATERIAL=M STATE=STRESS\n"
              "$PROPERTY ESET=R MATERIAL=N STATE=STRESS\n"
              "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  XMIN\n"
              "$LOAD CASE=T TYPE=TEMPERATURE\n" +
              lines + "$STEP NAME=S\n  LOAD T 3\n$END\n");
    return convert(folder, "h.deck", "h.inp");
  };
  EXPECT_EQ(deck(" ALPHA=1e-6", "  L (10*x)\n  R (5*x + 5)\n").exit_code, 0);
  const std::string text = test::slurp(folder.path() / "h.inp");
  EXPECT_NE(text.find("*INITIAL CONDITIONS, TYPE=TEMPERATURE\n1, 0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("*TEMPERATURE\n1, 0\n2, 30\n3, 30\n4, 0\n5, 45\n6, 45\n"), std::string::npos)
      << text;
  EXPECT_EQ(text.find("*CLOAD"), std::string::npos); // heat is not written twice
  const Outcome jump = deck(" ALPHA=1e-6", "  L 10\n");
  EXPECT_EQ(jump.exit_code, 4);
  EXPECT_NE(jump.messages.find("a temperature that jumps between elements"), std::string::npos);
  EXPECT_EQ(deck("", "  L 10\n").exit_code, 0); // the other part does not expand
}

TEST(Convert, WhatTheFormatCannotSayIsNamedAndNothingIsWritten) {
  const Folder folder;
  write(folder, "a.deck",
        two_plates("$CONTACT NAME=FACE SLAVE=B.XMIN MASTER=A.XMAX\n"
                   "$CRACK NAME=C NET=A A0=0.5 ANGLE=90[deg]\n  2 0\n"));
  const Outcome outcome = convert(folder, "a.deck", "a.inp");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.messages.find("E540: $CONTACT cannot be written"), std::string::npos)
      << outcome.messages;
  EXPECT_NE(outcome.messages.find("E540: $CRACK cannot be written"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.inp"));
  EXPECT_EQ(convert(folder, "a.deck", "a.msh").exit_code, 0); // a mesh has no contact
}

TEST(Convert, NineNodesHaveNoNameInAbaqus) {
  const Folder folder;
  write(folder, "a.deck", R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC9 LX=1 LY=1
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$END
)");
  const Outcome outcome = convert(folder, "a.deck", "a.inp");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.messages.find("QUAMC9"), std::string::npos) << outcome.messages;
}

TEST(Convert, ExitCodes) {
  const Folder folder;
  write(folder, "bad.deck", "$DECK VERSION=1 LENGTH=mm\n$END\n");
  write(folder, "bad.msh", "no mesh\n");
  EXPECT_EQ(convert(folder, "bad.deck", "a.txt").exit_code, 2);
  EXPECT_EQ(convert(folder, "bad.deck", "a.msh").exit_code, 3);
  EXPECT_EQ(convert(folder, "bad.msh", "a.vtu").exit_code, 3);
  EXPECT_EQ(convert(folder, "none.deck", "a.msh").exit_code, 7);
  write(folder, "a.deck", two_plates());
  EXPECT_EQ(convert(folder, "a.deck", "no/folder/a.msh").exit_code, 7);
}

TEST(Convert, AGeometryScriptBecomesAMesh) {
  const Folder folder;
  write(folder, "box.geo",
        "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 2, 3};\n"
        "Physical Volume(\"body\") = {1};\nPhysical Surface(\"skin\") = {1:6};\n");
  EXPECT_EQ(convert(folder, "box.geo", "box.msh").exit_code, 0);
  EXPECT_EQ(convert(folder, "box.msh", "box.inp").exit_code, 0);
  const std::string text = test::slurp(folder.path() / "box.inp");
  EXPECT_NE(text.find("TYPE=C3D4"), std::string::npos);
  EXPECT_NE(text.find("*SURFACE, NAME=SKIN"), std::string::npos);
}

TEST(Convert, AFileThatIsThereStaysUntilToldOtherwise) {
  const Folder folder;
  std::ofstream(folder.path() / "a.deck") << two_plates();
  std::ofstream(folder.path() / "a.msh") << "precious";
  const Outcome refused = convert(folder, "a.deck", "a.msh", false);
  EXPECT_EQ(refused.exit_code, 7);
  EXPECT_NE(refused.messages.find("E464"), std::string::npos) << refused.messages;
  EXPECT_EQ(test::slurp(folder.path() / "a.msh"), "precious");
  EXPECT_EQ(convert(folder, "a.deck", "b.msh", false).exit_code, 0);
  EXPECT_EQ(convert(folder, "a.deck", "a.msh").exit_code, 0);
  EXPECT_NE(test::slurp(folder.path() / "a.msh"), "precious");
}

} // namespace
} // namespace spricka::test_convert
