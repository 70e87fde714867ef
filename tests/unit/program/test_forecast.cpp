// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/places.hpp"
#include "tests/unit/support/check_text.hpp"

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>

// What `spricka check` foretells of a run against the run.
namespace spricka::test_forecast {
namespace {

using nlohmann::json;
using test::check_text;
using test::Checked;
using test::Folder;
using test::growing_crack;
using test::run_text;

// Flops of the listing, length by length, as it prints them.
std::vector<std::string> flops_of(const std::string& listing) {
  std::vector<std::string> found;
  for (std::size_t at = listing.find(" flops;"); at != std::string::npos;
       at = listing.find(" flops;", at + 1)) {
    const std::size_t begin = listing.rfind(' ', at - 1) + 1;
    found.push_back(listing.substr(begin, at - begin));
  }
  return found;
}

TEST(Forecast, FlopsAreExactlyThoseOfTheRun) {
  const Folder folder;
  const std::string deck = growing_crack(16, "1 2 3.5");
  const Checked c = check_text(folder, deck, 1, true);
  EXPECT_TRUE(c.found["forecast"]["exact"]);
  ASSERT_EQ(run_text(folder, deck).exit_code, 0);
  const std::vector<std::string> flops =
      flops_of(test::slurp(folder.path() / "out" / "listing.txt"));
  ASSERT_EQ(flops.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", c.found["lengths"][i]["flops"].get<double>());
    EXPECT_EQ(text.data(), flops[i]);
  }
}

// 3 mm by 0.01 mm at a time are 300 solutions at least.
TEST(Forecast, AGrowthByALawTakesItsStations) {
  std::string deck = growing_crack(8, "");
  const std::size_t at = deck.find("$GROW");
  const auto with = [&](const std::string& more) {
    return deck.substr(0, at) +
           "$STEP NAME=REST\n  LOAD PULL 0\n$GROW LAW=PARIS KMAX=PULL "
           "KMIN=REST C=1e-9 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' AMAX=4" +
           more + "\n$END\n";
  };
  const Folder folder;
  const double one = check_text(folder, with("")).found["forecast"]["flops"];
  const double many = check_text(folder, with(" DA=0.01")).found["forecast"]["flops"];
  EXPECT_NEAR(many / one, 300.0, 1e-9);
}

// Runs the program itself, as memory belongs to a process; returns its standard output.
std::string run_program(const std::vector<std::string>& arguments, const Folder& folder,
                        double& peak_memory) {
  const std::filesystem::path output = folder.path() / "stdout.txt";
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen(output.c_str(), "w", stdout) == nullptr) {
      _exit(126);
    }
    std::vector<std::string> words = arguments;
    words.insert(words.begin(), test::program_file());
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) {
      argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    execv(test::program_file().c_str(), argv.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  peak_memory = 1024.0 * static_cast<double>(usage.ru_maxrss);
  return test::slurp(output);
}

std::string cube() {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=TET10 LX=1 LY=1 LZ=1 NX=9 NY=9 NZ=9
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  ZMIN
$FREEDOM CLASS=EXTERNAL DOF=XYZ
  ZMAX
$LOAD CASE=PULL TYPE=TRACTION
  ZMAX 0 0 1
$STEP NAME=PULL
  LOAD PULL 1
$END
)";
}

// Two blocks with a thousand contact rows between them.
std::string two_blocks() {
  return R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LOWER
  $MESH SHAPE=BLOCK TYPE=TET10 LX=1 LY=1 LZ=0.4 NX=14 NY=14 NZ=4
$ENDNET
$NET NAME=UPPER
  $MESH SHAPE=BLOCK TYPE=TET10 Z0=0.4 LX=1 LY=1 LZ=0.4 NX=14 NY=14 NZ=4
$ENDNET
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=LOWER.BODY MATERIAL=M STATE=SOLID
$PROPERTY ESET=UPPER.BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  LOWER.ZMIN
$CONTACT NAME=FOOT SLAVE=UPPER.ZMIN MASTER=LOWER.ZMAX
$LOAD CASE=PUSH TYPE=TRACTION
  UPPER.ZMAX 0 0 -1
$STEP NAME=PUSH
  LOAD PUSH 1
$END
)";
}

TEST(Forecast, MemoryIsForetoldWithinAFifth) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's own memory counts in";
#endif
  const std::string texts[] = {growing_crack(60, "1 2"), growing_crack(100, "1 2"), cube(),
                               two_blocks()};
  for (const std::string& text : texts) {
    const Folder folder;
    const std::string deck = (folder.path() / "test.deck").string();
    std::ofstream(deck) << text;
    double used = 0.0;
    const json found = json::parse(
        run_program({"check", deck, "--forecast", "--json", "--threads", "1"}, folder, used));
    const double memory = found["forecast"]["memory"];
    run_program({"run", deck, "--threads", "1", "--quiet", "--out", (folder.path() / "o").string()},
                folder, used);
    EXPECT_NEAR(memory / used, 1.0, 0.2) << memory << " foretold, " << used << text;
  }
}

// The law against the symbolic analysis: a plate with a crack, a cube with externals, two blocks
// whose contact rows are eliminated with their factors.
TEST(Forecast, TheLawIsNearTheAnalysis) {
  for (const std::string& text :
       {growing_crack(16, "1 2"), growing_crack(60, "1"), cube(), two_blocks()}) {
    const Folder folder;
    const json rough = check_text(folder, text).found;
    const json exact = check_text(folder, text, 1, true).found;
    EXPECT_FALSE(rough["forecast"]["exact"]);
    for (std::size_t i = 0; i < exact["lengths"].size(); ++i) {
      const json& a = rough["lengths"][i];
      const json& b = exact["lengths"][i];
      for (const char* same : {"nets_new", "nets_reused", "unknowns_new", "externals"}) {
        EXPECT_EQ(a[same], b[same]) << same << text;
      }
      for (const auto& [name, factor] :
           {std::pair("flops", 2.5), std::pair("factor_entries", 1.8), std::pair("memory", 1.5)}) {
        const double ratio = a[name].get<double>() / b[name].get<double>();
        EXPECT_LT(ratio, factor) << name << text;
        EXPECT_GT(ratio, 1.0 / factor) << name << text;
      }
    }
  }
}

} // namespace
} // namespace spricka::test_forecast
