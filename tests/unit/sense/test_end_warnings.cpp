// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/judge_size.hpp"
#include "analysis/recover/net_errors.hpp"
#include "sense/end_warnings.hpp"
#include "tests/unit/support/run_text.hpp"

#include <fmt/format.h>

/// What only the whole run shows.
namespace spricka::test_end_warnings {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string said(const std::string& deck) {
  const test::Folder folder;
  const test::Outcome outcome = test::run_text(folder, deck);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  return outcome.messages;
}

// A block between a wall and a stop; pulled by the load of step PULL, pressed by PUSH.
std::string block(const std::string& fit, const std::string& steps) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=10 NX=2 NY=2
$MATERIAL NAME=M E=1000 NU=0
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  XMIN
$RIGID NAME=STOP SHAPE=LINE X0=10 Y0=-5 X1=10 Y1=15
$CONTACT NAME=C SLAVE=XMAX MASTER=STOP {}
$LOAD CASE=F TYPE=BODY
  BODY  1  0
{}
$END
)",
                     fit, steps);
}

const std::string push = "$STEP NAME=PUSH\n  LOAD F 1\n";
const std::string pull = "$STEP NAME=PULL\n  LOAD F -1\n";

TEST(IdleContacts, OneThatPressesInNoStep) {
  EXPECT_TRUE(has(said(block("GAP=1", push)), "W571: contact C")) << said(block("GAP=1", push));
  EXPECT_TRUE(has(said(block("GAP=0", pull)), "W571")) << said(block("GAP=0", pull));
  EXPECT_FALSE(has(said(block("GAP=0", push)), "W571"));
  EXPECT_FALSE(has(said(block("GAP=0", pull + push)), "W571")); // open in one step, as it may be
  EXPECT_FALSE(has(said(block("INTERFERENCE=0.2", pull)), "W571"));
}

// A block with a stop that it leaves, pulled until it is strained by a half and more.
TEST(Warnings, ComeTheWorstFirst) {
  const std::string text = said(block("GAP=0", "$STEP NAME=PULL\n  LOAD F -100\n"));
  EXPECT_LT(text.find("W508"), text.find("W571")) << text;
  EXPECT_TRUE(has(text, "W571")) << text;
}

// A seat drawn touching that lifts off while another contact presses is no mistake of a sign.
TEST(IdleContacts, ASeatMayLiftOff) {
  const std::string stop = "$RIGID NAME=SEAT SHAPE=LINE X0=15 Y0=10 X1=-5 Y1=10\n"
                           "$CONTACT NAME=D SLAVE=YMAX MASTER=SEAT {}\n";
  EXPECT_FALSE(has(said(block("GAP=0", fmt::format(fmt::runtime(stop), "GAP=0") + push)), "W571"));
  EXPECT_TRUE(has(said(block("GAP=0", fmt::format(fmt::runtime(stop), "GAP=1") + push)), "W571"));
}

std::string strip(const std::string& stress, const std::string& more = "") {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=20 LY=40 NX=8 NY=16
$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)
$NSET NAME=CORNER WHERE=(abs(y) < 1e-9 and abs(x-20) < 1e-9)
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$FREEDOM CLASS=SUPPRESSED DOF=Y
  LINE
$FREEDOM CLASS=SUPPRESSED DOF=X
  CORNER
$CRACK NAME=C PATH=LINE A0=4
$LOAD CASE=F TYPE=TRACTION
  YMAX  0  {}
$STEP NAME=FULL
  LOAD F 1
$STEP NAME=ZERO
  LOAD F 0
$GROW LAW=PARIS KMAX=FULL KMIN=ZERO C=1e-11 M=3 AMAX=5 KUNIT='MPa*mm^0.5' AUNIT='mm'
{}
$END
)",
                     stress, more);
}

// The life falls with the third power of the stress: of 50 MPa some 5000 cycles.
TEST(EndlessLives, AStressInAnotherUnit) {
  EXPECT_FALSE(has(said(strip("50")), "W572"));
  EXPECT_TRUE(has(said(strip("50e-6")), "W572: the life is"));
}

// What ends a life at once: the drawing, or loads that do not change; not the units of a law.
TEST(LivesOfNothing, SayWhatEndsThem) {
  std::string whole = strip("50");
  whole.replace(whole.find("A0=4"), 4, "A0=19.9");
  whole.replace(whole.find("AMAX=5"), 6, "AMAX=19.95");
  const std::string cut = said(whole);
  EXPECT_TRUE(has(cut, "Are the first lengths")) << cut;
  EXPECT_FALSE(has(cut, "KUNIT")) << cut;
  std::string still = strip("50");
  still.replace(still.find("LOAD F 0"), 8, "LOAD F 1");
  const std::string same = said(still);
  EXPECT_TRUE(has(same, "K does not change in a cycle")) << same;
}

TEST(StrangeTests, ReadingsOutsideAllLengths) {
  const auto readings = [](double unit) {
    std::string text = "$TEST NAME=T CRACK=C\n";
    for (const double a : {4.1, 4.2, 4.3, 4.4, 4.5, 4.6, 4.7, 4.8}) {
      text += fmt::format("  {} {}\n", 1000.0 * (a - 4.0), a * unit);
    }
    return text;
  };
  EXPECT_FALSE(has(said(strip("50", readings(1.0))), "W573"));
  const std::string inches = said(strip("50", readings(1.0 / 25.4)));
  EXPECT_TRUE(has(inches, "W573: test T")) << inches;
  EXPECT_TRUE(has(inches, "0.1614 to 0.189 mm")) << inches;
}

results::RunResult run_with_notes(const std::string& first, const std::string& later) {
  results::RunResult run;
  run.increments.resize(2);
  for (results::CrackLengthResult& increment : run.increments) {
    increment.steps.emplace_back().step = "S";
  }
  if (!first.empty()) {
    run.increments[0].steps[0].notes.push_back(results::less_exact_note(first));
  }
  run.increments[1].steps[0].notes.push_back(results::less_exact_note(later));
  return run;
}

TEST(LostLigaments, OnlyWhatWasSmallAtFirst) {
  const std::string bent = "LUG is bent or turned by 12 % of its size (largest "
                           "displacement 3): linear theory holds for less than about 10 %; are "
                           "moduli and loads in the units meant?";
  results::RunResult grown = run_with_notes("", bent);
  analysis::reword_notes_of_broken_ligaments(grown);
  EXPECT_FALSE(has(grown.increments[1].steps[0].notes[0].text, "units meant"));
  EXPECT_TRUE(has(grown.increments[1].steps[0].notes[0].text, "bent or turned by 12 %"));
  results::RunResult ever = run_with_notes(bent, bent);
  analysis::reword_notes_of_broken_ligaments(ever);
  EXPECT_EQ(ever.increments[1].steps[0].notes[0], results::less_exact_note(bent));
}

// What stays below its threshold does not grow, which is an answer.
TEST(Growth, BelowItsThresholdIsNotWarnedOf) {
  std::string deck = strip("0.5");
  deck.replace(deck.find("AMAX=5"), 6, "AMAX=5 DKTH=60");
  EXPECT_FALSE(has(said(deck), "W456")) << said(deck);
  EXPECT_FALSE(has(said(strip("50")), "W456"));
}

// A net that nothing strains has no error worth a word, whatever round-off looks like.
TEST(CoarseNets, RoundOffIsNoMesh) {
  results::RunResult run;
  results::CrackLengthResult& increment = run.increments.emplace_back();
  increment.mesh.element_label = {1};
  results::LoadStepResult& step = increment.steps.emplace_back();
  step.step = "S";
  for (const auto& [net, energy] : {std::pair("A", 1.0), std::pair("B", 1e-24)}) {
    results::ForceBalance balance;
    balance.body = net;
    balance.energy = energy;
    step.nets.push_back(balance);
    step.errors.push_back({net, 0.6, {base::ElementId(0)}, 1.0});
  }
  const std::vector<std::string> told = analysis::describe_coarse_nets(run);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_TRUE(has(told[0], "net A"));
}

// Two faces of a wholly held body: what is left of its load is round-off.
TEST(CoarseNets, ALoadThatASupportTakesStrainsNothing) {
  const std::string text = said(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=A
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=20 LY=10 NX=3 NY=7
$ENDNET
$NET NAME=B
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=20 LX=20 Y0=-2 LY=14 NX=10 NY=4
$ENDNET
$MATERIAL NAME=M E=210000 NU=0.3
$PROPERTY ESET=A.BODY MATERIAL=M STATE=STRESS THICK=1
$PROPERTY ESET=B.BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  A.XMIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  B.XMAX
$CONTACT NAME=FIT SLAVE=A.XMAX MASTER=B.XMIN GAP=0
$LOAD CASE=P TYPE=PRESSURE
  B.XMAX 10
$STEP NAME=PRESS
  LOAD P 1
$END
)");
  EXPECT_FALSE(has(text, "W504")) << text;
  EXPECT_TRUE(has(text, "W457")) << text;
}

} // namespace
} // namespace spricka::test_end_warnings
