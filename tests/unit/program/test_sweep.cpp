// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/places.hpp"
#include "tests/unit/support/run_text.hpp"

#include <chrono>
#include <thread>

#include <csignal>
#include <sys/wait.h>

namespace spricka::test_sweep {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::Outcome;
using test::run_text;
using test::slurp;

// A plate with an edge crack of length a under tension s; `more` stands before $END.
std::string plate(const std::string& more) {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  a = 2
  s = 10
  H = 20
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=(H) NX=6 NY=10
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  YMIN
$LOAD CASE=PULL TYPE=TRACTION
  YMAX 0 (s)
$CRACK NAME=C A0=(a) ANGLE=0
  0 (H/2)
$STEP NAME=PULL
  LOAD PULL 1
)" + more +
         "$END\n";
}

std::string sweep_of_a(const std::string& values) {
  return plate("$SWEEP PARAMETER=a\n " + values + "\n");
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

fs::path out(const Folder& folder) {
  return folder.path() / "out";
}

TEST(Sweep, PointsAreThoseOfSingleRunsToTheLastBit) {
  const Folder folder;
  const Outcome outcome = run_text(
      folder, plate("$SWEEP PARAMETER=a\n 1.1 (a/0.7)\n$SWEEP PARAMETER=s WITH=H\n 1 20  -2 22\n"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  const std::vector<std::array<std::string, 3>> points{
      {"1.1", "1", "20"}, {"1.1", "-2", "22"}, {"2/0.7", "1", "20"}, {"2/0.7", "-2", "22"}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Folder single;
    std::ofstream(single.path() / "test.deck") << plate("");
    program::RunOptions options;
    options.deck = single.path() / "test.deck";
    options.out = out(single);
    options.defines = {{"a", points[i][0]}, {"s", points[i][1]}, {"h", points[i][2]}};
    options.quiet = true;
    testing::internal::CaptureStderr();
    EXPECT_EQ(program::run_deck(options), base::ProgramOutcome::done);
    testing::internal::GetCapturedStderr();
    const fs::path point = out(folder) / ("00" + std::to_string(i + 1));
    EXPECT_EQ(slurp(point / "k.csv"), slurp(out(single) / "k.csv")) << i;
    EXPECT_EQ(slurp(point / "results_001_PULL.vtu"), slurp(out(single) / "results_001_PULL.vtu"));
  }
  EXPECT_EQ(test::column(out(folder) / "sweep.csv", "a"),
            (std::vector<double>{1.1, 1.1, 2 / 0.7, 2 / 0.7}));
  EXPECT_EQ(test::column(out(folder) / "sweep.csv", "H"), (std::vector<double>{20, 22, 20, 22}));
  EXPECT_EQ(test::column(out(folder) / "sweep.csv", "K1:C:PULL:1")[3],
            test::column(out(folder) / "004" / "k.csv", "K1")[0]);
}

TEST(Sweep, FailedPointsAreRowsAndTheSweepGoesOn) {
  const Folder folder;
  // 50: longer than the plate is wide, a mistake of the deck at this point only
  const Outcome outcome = run_text(folder, sweep_of_a("1 50 2"));
  EXPECT_EQ(outcome.exit_code, 3) << outcome.messages;
  const std::vector<std::string> lines = lines_of(out(folder) / "sweep.csv");
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_TRUE(lines[1].starts_with("a,point,status,exit_code,error,checks,passed,")) << lines[1];
  EXPECT_TRUE(lines[2].starts_with("1,001,done,0,,")) << lines[2];
  EXPECT_TRUE(lines[3].starts_with("50,002,failed,3,")) << lines[3];
  EXPECT_NE(lines[3].find("test.deck:"), std::string::npos) << lines[3];
  EXPECT_TRUE(lines[4].starts_with("2,003,done,0,,")) << lines[4];
  EXPECT_FALSE(fs::exists(out(folder) / "002"));
  EXPECT_NE(slurp(out(folder) / "sweep.html").find("<svg"), std::string::npos);
}

TEST(Sweep, FinishedPointsAreTakenOverUntilSomethingChanges) {
  const Folder folder;
  const auto written = [&](const char* point) {
    return fs::last_write_time(out(folder) / point / "listing.txt");
  };
  const auto include = [&](const std::string& nu) {
    std::ofstream(folder.path() / "more.inc") << "$MATERIAL NAME=X E=1 NU=" + nu + "\n";
  };
  include("0.3");
  const std::string deck = plate("$INCLUDE FILE='more.inc'\n$SWEEP PARAMETER=a\n 1 2\n");
  ASSERT_EQ(run_text(folder, deck).exit_code, 0);
  const auto first = written("001");
  const std::string table = slurp(out(folder) / "sweep.csv");

  fs::remove(out(folder) / "002" / "point.json"); // not complete: computed again
  const auto second = written("002");
  ASSERT_EQ(run_text(folder, deck).exit_code, 0);
  EXPECT_EQ(written("001"), first);
  EXPECT_NE(written("002"), second);
  EXPECT_EQ(slurp(out(folder) / "sweep.csv"), table);

  include("0.2");
  ASSERT_EQ(run_text(folder, deck).exit_code, 0);
  EXPECT_NE(written("001"), first);

  // fewer points: the others' folders do not stay behind
  ASSERT_EQ(run_text(folder, sweep_of_a("2")).exit_code, 0);
  EXPECT_FALSE(fs::exists(out(folder) / "002"));
}

TEST(Sweep, AGeometryScriptCounts) {
  const Folder folder;
  const auto script = [&](const std::string& width) {
    std::ofstream(folder.path() / "plate.geo") << "W = " + width + R"(;
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, W, 10};
Physical Surface("BODY") = {1};
Physical Curve("FOOT") = {1};
Physical Curve("HEAD") = {3};
Mesh.MeshSizeMax = 2;
)";
  };
  const std::string deck = R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  s = 1
$IMPORT FILE='plate.geo' FORMAT=GEO
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  FOOT
$LOAD CASE=PULL TYPE=TRACTION
  HEAD 0 (s)
$STEP NAME=PULL
  LOAD PULL 1
$SWEEP PARAMETER=s
  2
$OUTPUT FILE='foot.csv' FORMAT=CSV EVERY=END
  REACTION FOOT
$END
)";
  script("5");
  const Outcome outcome = run_text(folder, deck);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_NEAR(test::column(out(folder) / "foot.csv", "REACTION.Y:FOOT:PULL:1").at(0), -10.0, 1e-9);
  script("6");
  ASSERT_EQ(run_text(folder, deck).exit_code, 0);
  EXPECT_NEAR(test::column(out(folder) / "foot.csv", "REACTION.Y:FOOT:PULL:1").at(0), -12.0, 1e-9);
}

TEST(Sweep, ChecksHoldForEachPoint) {
  const Folder folder;
  // Reaction over the clamped side: -s times the width of 10
  const std::string check = "$SWEEP PARAMETER=s\n 1 10 3\n$CHECK\n"
                            "  REACTION(YMIN,PULL,Y) = (-10*s) REL 1e-8 SOURCE 'balance'\n"
                            "  REACTION(YMIN,PULL,Y) = -10 REL 1e-8 SOURCE 'balance at s = 1'\n";
  const Outcome outcome = run_text(folder, plate(check));
  EXPECT_EQ(outcome.exit_code, 1) << outcome.messages;
  EXPECT_EQ(test::column(out(folder) / "sweep.csv", "passed"), (std::vector<double>{2, 1, 1}));
  // what was computed is not computed again, and its verdict stays
  EXPECT_EQ(run_text(folder, plate(check)).exit_code, 1);
}

TEST(Sweep, FoldersOfOthersAreNotTouched) {
  const Folder folder;
  ASSERT_EQ(run_text(folder, sweep_of_a("2")).exit_code, 0);
  EXPECT_EQ(run_text(folder, plate("")).exit_code, 7); // a single run does not wipe out a sweep
  EXPECT_TRUE(fs::exists(out(folder) / "001" / "k.csv"));
  const Folder other;
  fs::create_directories(out(other));
  std::ofstream(out(other) / "thesis.txt") << "years of work";
  EXPECT_EQ(run_text(other, sweep_of_a("2")).exit_code, 7);
  EXPECT_EQ(slurp(out(other) / "thesis.txt"), "years of work");
}

TEST(Sweep, ASignalLeavesFinishedPointsAndNothingHalf) {
  for (const int signal : {SIGTERM, SIGINT}) {
    const Folder folder;
    const std::string deck = (folder.path() / "test.deck").string();
    std::ofstream(deck) << sweep_of_a("1.0 1.1 1.2 1.3 1.4 1.5 1.6 1.7 1.8 1.9 2.0 2.1 2.2 2.3");
    const std::string run_folder = out(folder).string();
    const std::string program = test::program_file();
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      std::signal(SIGINT, SIG_DFL);
      std::freopen("/dev/null", "w", stderr);
      execl(program.c_str(), program.c_str(), "run", deck.c_str(), "--out", run_folder.c_str(),
            "--quiet", static_cast<char*>(nullptr));
      _exit(127);
    }
    for (int i = 0; i < 3000 && !fs::exists(out(folder) / "001"); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 128 + signal);
    std::size_t finished = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(out(folder))) {
      EXPECT_NE(entry.path().extension(), ".part");
      finished += entry.is_directory() ? 1 : 0;
    }
    EXPECT_GE(finished, 1U);
    EXPECT_LT(finished, 14U);
    const auto kept = fs::last_write_time(out(folder) / "001" / "listing.txt");
    EXPECT_EQ(run_text(folder, slurp(deck)).exit_code, 0);
    EXPECT_EQ(fs::last_write_time(out(folder) / "001" / "listing.txt"), kept);
    EXPECT_EQ(lines_of(out(folder) / "sweep.csv").size(), 16U);
  }
}

} // namespace
} // namespace spricka::test_sweep
