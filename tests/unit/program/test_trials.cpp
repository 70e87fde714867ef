// SPDX-License-Identifier: GPL-3.0-or-later
// Decks as processes of their own: what they found, what they cost, and that one that fails, hangs
// or is ended concerns no other.
#include "program/trials/child_run.hpp"
#include "program/trials/deck_outcome.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/run_text.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

namespace spricka::test_trials {
namespace {

namespace fs = std::filesystem;
using program::ChildProcessResult;
using program::ChildRun;
using program::ChildRunner;
using program::DeckRunChecks;
using test::Folder;

// A plate with an edge crack under tension s: K1 is proportional to it.
std::string cracked_plate(const std::string& more) {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Plate'
$PARAMETER
  s = 10
  n = 10
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=20 NX=(n) NY=(2*n)
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  YMIN
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 0 (s)
$CRACK NAME=C A0=2 ANGLE=0
  0 10
$STEP NAME=PULL
  LOAD PULL 1
)" + more +
         "$END\n";
}

class Trials : public testing::Test {
protected:
  fs::path deck(const std::string& name, const std::string& text) const {
    std::ofstream(folder.path() / name) << text;
    return folder.path() / name;
  }
  ChildRun run_of(const fs::path& file) const {
    return {.deck = file, .out = file.string() + ".run", .defines = {}, .threads = 1};
  }
  Folder folder;
};

TEST_F(Trials, EachSaysHowItEndedWhatItFoundAndWhatItCost) {
  const fs::path good = deck("good.deck", cracked_plate("$CHECK\n"
                                                        "  K1(C,PULL) = 40 REL 0.5 SOURCE 'rough'\n"
                                                        "  G(C,PULL) = 1 REL 1e-9 SOURCE 'no'\n"
                                                        "  K(C,PULL) = 1 REL 99 SOURCE 'rough'\n"));
  const fs::path bad = deck("bad.deck", "$DECK VERSION=1\n$MISTAKE\n$END\n");
  std::vector<ChildRun> runs{run_of(good), run_of(bad), run_of(good)};
  runs[2].defines = {{"s", "2*10"}};
  runs[2].out = folder.path() / "double";
  std::vector<ChildProcessResult> ends(runs.size());
  ChildRunner(test::program_file())
      .run_all_children(runs, 2,
                        [&](std::size_t i, const ChildProcessResult& end) { ends[i] = end; });
  EXPECT_EQ(ends[0].exit_code, 1) << ends[0].messages; // a check that cannot hold
  EXPECT_EQ(ends[1].exit_code, 3);
  EXPECT_NE(ends[1].messages.find("bad.deck:2"), std::string::npos) << ends[1].messages;
  EXPECT_EQ(ends[2].exit_code, 1);
  EXPECT_GT(ends[0].cpu, 0.0);
  EXPECT_GT(ends[0].wall, 0.0);
  EXPECT_GT(ends[0].peak_memory, std::size_t{1} << 20U);
  EXPECT_TRUE(program::read_run_folder_checks(runs[1].out).empty());

  const std::vector<DeckRunChecks> first = program::read_run_folder_checks(runs[0].out);
  const std::vector<DeckRunChecks> twice = program::read_run_folder_checks(runs[2].out);
  ASSERT_EQ(first.size(), 1U);
  ASSERT_EQ(twice.size(), 1U);
  EXPECT_EQ(first[0].title, "Plate");
  EXPECT_EQ(first[0].values, "");
  ASSERT_EQ(first[0].checks.size(), 3U);
  const results::CheckResult& K1 = first[0].checks[0];
  EXPECT_TRUE(K1.passed);
  EXPECT_EQ(K1.source, "rough");
  EXPECT_GT(K1.bar, 0.0); // that of k.csv
  EXPECT_EQ(K1.bar, test::column(runs[0].out / "k.csv", "K1_bar")[0]);
  EXPECT_FALSE(first[0].checks[1].passed);
  EXPECT_TRUE(std::isnan(first[0].checks[1].bar)); // G has none
  EXPECT_EQ(first[0].checks[2].bar, K1.bar);       // K is K1
  EXPECT_NEAR(twice[0].checks[0].found, 2.0 * K1.found, 1e-9 * K1.found);
  // Nodes of 200 eight-noded elements, less the support: and those of the tip.
  EXPECT_GT(first[0].unknowns, 1200U);
  EXPECT_LT(first[0].unknowns, 3000U);
}

TEST_F(Trials, ASweepIsAnOutcomeForEachPoint) {
  const ChildRun run = run_of(deck("sweep.deck", cracked_plate("$SWEEP PARAMETER=s\n  1 3\n"
                                                               "$CHECK\n"
                                                               "  K1(C,PULL) = 1 ABS 1e9\n")));
  int code = -1;
  ChildRunner(test::program_file())
      .run_all_children({&run, 1}, 1,
                        [&](std::size_t, const ChildProcessResult& end) { code = end.exit_code; });
  EXPECT_EQ(code, 0);
  const std::vector<DeckRunChecks> points = program::read_run_folder_checks(run.out);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[1].values, "s = 3");
  EXPECT_NEAR(points[1].checks[0].found, 3.0 * points[0].checks[0].found, 1e-9);
}

TEST_F(Trials, AProcessThatIsTooSlowIsEndedAndLeavesNoResults) {
  ChildRun run = run_of(deck("slow.deck", cracked_plate("")));
  run.defines = {{"n", "400"}};
  run.seconds = 0.2;
  ChildProcessResult end;
  ChildRunner(test::program_file())
      .run_all_children({&run, 1}, 1, [&](std::size_t, const ChildProcessResult& e) { end = e; });
  EXPECT_TRUE(end.late);
  EXPECT_NE(end.exit_code, 0);
  EXPECT_FALSE(fs::exists(run.out));
  EXPECT_FALSE(fs::exists(run.out.string() + ".part"));
}

TEST_F(Trials, ALimitOfCpuTimeHoldsToo) {
  ChildRun run = run_of(deck("slow.deck", cracked_plate("")));
  run.defines = {{"n", "400"}};
  run.cpu_seconds = 0.2;
  ChildProcessResult end;
  ChildRunner(test::program_file())
      .run_all_children({&run, 1}, 1, [&](std::size_t, const ChildProcessResult& e) { end = e; });
  EXPECT_TRUE(end.late);
  EXPECT_GE(end.cpu, 0.2);
  EXPECT_FALSE(fs::exists(run.out));
}

TEST_F(Trials, ASignalEndsOneAndItsMemoryIsItsOwn) {
  const fs::path dies = deck("dies", "#!/bin/sh\necho last words >&2\nsleep 0.2\nkill -SEGV $$\n");
  fs::permissions(dies, fs::perms::owner_all);
  // Of this process, not of a shell that it starts.
  const std::vector<char> much(std::size_t{200} << 20U, 'x');
  const ChildRun run = run_of(dies);
  ChildProcessResult end;
  ChildRunner(dies).run_all_children({&run, 1}, 1,
                                     [&](std::size_t, const ChildProcessResult& e) { end = e; });
  EXPECT_EQ(end.signal, SIGSEGV);
  EXPECT_EQ(end.exit_code, 128 + SIGSEGV);
  EXPECT_EQ(end.messages, "last words\n");
  EXPECT_GT(end.peak_memory, 0U);
  EXPECT_LT(end.peak_memory, much.size());
}

TEST_F(Trials, AreStoppedTogetherAndNoneIsBegunAfterwards) {
  const fs::path file = deck("slow.deck", cracked_plate(""));
  std::vector<ChildRun> runs;
  for (int i = 0; i < 6; ++i) {
    runs.push_back(run_of(file));
    runs.back().out += std::to_string(i);
    runs.back().defines = {{"n", "400"}};
  }
  ChildRunner children(test::program_file());
  std::atomic<int> told{0};
  std::jthread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    children.stop();
  });
  const auto begin = std::chrono::steady_clock::now();
  children.run_all_children(runs, 2, [&](std::size_t, const ChildProcessResult&) { ++told; });
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
  EXPECT_TRUE(children.stopped());
  EXPECT_EQ(told, 0);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.path())) {
    EXPECT_EQ(entry.path().filename(), "slow.deck");
  }
}

TEST_F(Trials, AProgramThatIsNotThereIsTold) {
  const ChildRun run = run_of(deck("good.deck", cracked_plate("")));
  EXPECT_THROW(ChildRunner("/no/such/program")
                   .run_all_children({&run, 1}, 1, [](std::size_t, const ChildProcessResult&) {}),
               std::system_error);
}

} // namespace
} // namespace spricka::test_trials
