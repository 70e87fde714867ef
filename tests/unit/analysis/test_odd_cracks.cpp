// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/run_text.hpp"

// What a user is told about cracks that cannot be: the code, the place, what to do.
namespace spricka::test_odd_cracks {
namespace {

struct Odd {
  const char* cracks;
  const char* code;
  std::vector<std::string> words;
};

std::string deck_with(const std::string& cracks) {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=P
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=10 NX=10 NY=10
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$MATERIAL NAME=N E=3000 NU=0.3
$ESET NAME=SOFT FROM=P.BODY WHERE=(x < 8)
$ESET NAME=HARD FROM=P.BODY WHERE=(x > 8)
$PROPERTY ESET=SOFT MATERIAL=M STATE=STRAIN
$PROPERTY ESET=HARD MATERIAL=N STATE=STRAIN
$NSET NAME=FLOOR WHERE=(y < 1e-9) ORDER=(x)
$NSET NAME=HELD  WHERE=(y < 1e-9 and x > 2.4)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  HELD
$NSET NAME=PIN WHERE=(x > 10 - 1e-9 and y < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=X
  PIN
$LOAD CASE=T TYPE=TRACTION
  P.YMAX 0 1
$STEP NAME=S
  LOAD T 1
)" + cracks +
         "$END\n";
}

class OddCrack : public testing::TestWithParam<Odd> {};

TEST_P(OddCrack, IsRefusedWithItsPlaceAndAHint) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(folder, deck_with(GetParam().cracks));
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.messages.find(std::string("error ") + GetParam().code), std::string::npos)
      << outcome.messages;
  for (const std::string& word : GetParam().words) {
    EXPECT_NE(outcome.messages.find(word), std::string::npos) << word << "\n" << outcome.messages;
  }
  EXPECT_NE(outcome.messages.find("$CRACK"), std::string::npos); // the card's line
  EXPECT_NE(outcome.messages.find("^^^^^^"), std::string::npos);
  EXPECT_NE(outcome.messages.find("       = "), std::string::npos); // a hint
  EXPECT_EQ(outcome.messages.find("error E", outcome.messages.find("error E") + 1),
            std::string::npos); // said once
}

INSTANTIATE_TEST_SUITE_P(
    All, OddCrack,
    testing::Values(
        Odd{"$CRACK NAME=A NET=P\n -1 5\n 3 5\n", "E421", {"(-1, 5)", "boundary point is (0, 5)"}},
        Odd{"$CRACK NAME=A NET=P\n 0.01 5\n 3 5\n", "E421", {"short of the boundary", "(0, 5)"}},
        Odd{"$CRACK NAME=A NET=P\n 0 5\n -3 5\n", "E425", {"leaves its body", "(0, 5)"}},
        Odd{"$CRACK NAME=A NET=P A0=12 ANGLE=1.5707963\n 4 0\n", "E425", {"a = 12", "(4, 10)"}},
        Odd{"$CRACK NAME=A NET=P\n 4 5\n 4 12\n", "E425", {"leaves its body", "(4, 10)"}},
        // the whole outline lies where the mouth is
        Odd{"$CRACK NAME=A NET=P\n 4 0\n 4 50000\n", "E425", {"leaves its body"}},
        Odd{"$CRACK NAME=A NET=P\n 4 0\n 4 10\n", "E423", {"net section is lost"}},
        Odd{"$CRACK NAME=A NET=P\n 0 10\n 3 10\n", "E423", {"runs along the boundary", "PATH"}},
        Odd{"$CRACK NAME=A PATH=FLOOR A0=4\n", "E423", {"not all nodes of PATH are suppressed"}},
        Odd{"$CRACK NAME=A NET=P\n 5 5\n 9 5\n", "E424", {"material boundary"}},
        Odd{"$CRACK NAME=A NET=P\n 4 4.5\n 7.9 4.5\n",
            "E424",
            {"too long for the crack", "refine"}},
        Odd{"$CRACK NAME=A NET=P\n 0 5\n 3 5\n$TIPNET CRACK=A RADIUS=4\n", "E423", {"of room"}},
        Odd{"$CRACK NAME=A NET=P\n 2 5\n 6 5\n 6 7\n 4 7\n 4 4\n", "E430", {"itself at (4, 5)"}},
        Odd{"$CRACK NAME=A NET=P\n 2 5\n 6 5\n 3 5.1\n", "E430", {"turns back at (6, 5)"}},
        Odd{"$CRACK NAME=A NET=P\n 2 5\n 6 5\n$CRACK NAME=B NET=P\n 4 3\n 4 7\n",
            "E430",
            {"crack B meets crack A at (4, 5)", "branches"}}));

} // namespace
} // namespace spricka::test_odd_cracks
