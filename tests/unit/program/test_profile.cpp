// SPDX-License-Identifier: GPL-3.0-or-later
// What a profile adds up to, how it is shown, and that its trace is one that viewers open.
#include "analysis/lengths/recorder.hpp"
#include "model/model.hpp"
#include "program/job/ready_deck.hpp"
#include "program/profile/floor.hpp"
#include "program/profile/profile_report.hpp"
#include "program/profile/profile_sums.hpp"
#include "program/profile/trace.hpp"
#include "program/trials/child_run.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/run_text.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <nlohmann/json.hpp>

namespace spricka::test_profile {
namespace {

using nlohmann::json;
using program::ProcessorCostSum;
using program::ProcessorCostTable;
using results::RunProfile;

// A run of 10 s with two lengths: the mesher is asked while the deck is read and in TOPOLOGY, nets
// are condensed on two threads at the first length and found again at the second.
RunProfile sample() {
  RunProfile p;
  p.begin = 100.0;
  p.end = 110.0;
  p.cpu = 9.0;
  p.peak = 900;
  p.intervals = {
      {.processor = "DECK", .text = "deck", .begin = 100.0, .end = 102.0, .cpu = 1.0, .peak = 100},
      {.processor = "TOPOLOGY",
       .text = "a = 1",
       .begin = 102.0,
       .end = 103.0,
       .cpu = 0.6,
       .length = 0,
       .peak = 150},
      {.processor = "CONDENSE",
       .text = "2 nets",
       .begin = 103.0,
       .end = 106.0,
       .cpu = 5.0,
       .flops = 4e9,
       .length = 0,
       .peak = 900},
      {.processor = "CONTACT",
       .text = "rows",
       .begin = 106.0,
       .end = 107.0,
       .cpu = 1.0,
       .flops = 1e9,
       .length = 0,
       .peak = 900},
      {.processor = "CONTACT",
       .text = "step",
       .begin = 107.0,
       .end = 107.5,
       .cpu = 0.5,
       .length = 0,
       .peak = 900},
      {.processor = "CONDENSE",
       .text = "none",
       .begin = 108.0,
       .end = 108.5,
       .cpu = 0.4,
       .flops = 0.0,
       .length = 1,
       .peak = 900}};
  p.nets = {{.name = "LUG",
             .freedoms = 900,
             .externals = 40,
             .entries = 3e4,
             .flops = 3e9,
             .begin = 103.1,
             .assembled = 104.1,
             .end = 105.9,
             .stiffness_cpu = 1.0,
             .analysis_cpu = 0.3,
             .numeric_cpu = 1.5,
             .length = 0},
            {.name = "PIN",
             .freedoms = 500,
             .externals = 40,
             .entries = 2e4,
             .flops = 1e9,
             .beside = true,
             .begin = 103.2,
             .assembled = 103.7,
             .end = 104.9,
             .stiffness_cpu = 0.5,
             .analysis_cpu = 0.2,
             .numeric_cpu = 1.0,
             .length = 0},
            {.name = "LUG",
             .freedoms = 900,
             .externals = 40,
             .entries = 3e4,
             .reused = true,
             .length = 1},
            {.name = "PIN",
             .freedoms = 500,
             .externals = 40,
             .entries = 2e4,
             .reused = true,
             .length = 1}};
  p.lengths = {{.a = 1.0, .counts = true, .begin = 102.0, .end = 107.6, .cpu = 7.2},
               {.counts = false, .begin = 107.9, .end = 108.6, .cpu = 0.45}};
  p.mesher = {{.begin = 100.5, .end = 101.5, .cpu = 0.9, .peak = 70},
              {.begin = 102.2, .end = 102.6, .cpu = 0.35, .peak = 80}};
  return p;
}

const ProcessorCostSum& row(const ProcessorCostTable& sums, const std::string& processor) {
  const auto found = std::ranges::find(sums.rows, processor, &ProcessorCostSum::processor);
  EXPECT_NE(found, sums.rows.end()) << processor;
  return *found;
}

TEST(RunProfile, ProcessorsAddUpToTheRun) {
  const ProcessorCostTable sums = program::processor_costs(sample());
  double cpu = sums.cpu_rest + *row(sums, "MESHER").cpu;
  double wall = sums.wall_rest;
  for (const ProcessorCostSum& sum : sums.rows) {
    cpu += sum.processor == "MESHER" ? 0.0 : *sum.cpu;
    wall += sum.wall;
  }
  EXPECT_NEAR(cpu, 9.0 + 1.25, 1e-12);
  EXPECT_NEAR(cpu, sums.total_cpu(), 1e-12);
  EXPECT_NEAR(wall, 10.0, 1e-12);
  EXPECT_NEAR(sums.cpu_rest, 0.5, 1e-12);  // behind the last stretch and between them
  EXPECT_NEAR(sums.wall_rest, 2.0, 1e-12); // 107.5 .. 108, 108.5 .. 110
}

TEST(RunProfile, WhatTheProgramWaitsForTheMesherIsTheMeshers) {
  const ProcessorCostTable sums = program::processor_costs(sample());
  EXPECT_NEAR(row(sums, "DECK").wall, 1.0, 1e-12);
  EXPECT_NEAR(row(sums, "TOPOLOGY").wall, 0.6, 1e-12);
  EXPECT_NEAR(row(sums, "MESHER").wall, 1.4, 1e-12);
  EXPECT_EQ(row(sums, "MESHER").calls, 2U);
}

TEST(RunProfile, StiffnessIsTakenOutOfCondense) {
  const ProcessorCostTable sums = program::processor_costs(sample());
  EXPECT_EQ(row(sums, "STIFFNESS").calls, 2U);
  EXPECT_NEAR(*row(sums, "STIFFNESS").cpu, 1.5, 1e-12);
  EXPECT_NEAR(*row(sums, "CONDENSE").cpu, 5.4 - 1.5, 1e-12);
  // 1.5 of 4.5 s of both threads, in the 2.8 s that one was busy at the least
  EXPECT_NEAR(row(sums, "STIFFNESS").wall, 2.8 * 1.5 / 4.5, 1e-12);
  EXPECT_FALSE(row(sums, "STIFFNESS").flops);
}

TEST(RunProfile, FlopsCountWhereTheyAreKnown) {
  const ProcessorCostTable sums = program::processor_costs(sample());
  const ProcessorCostSum& contact = row(sums, "CONTACT");
  EXPECT_EQ(contact.flops, 1e9);
  EXPECT_FALSE(contact.all_counted);
  EXPECT_NEAR(contact.counted_cpu, 1.0, 1e-12); // of 1.5
  EXPECT_TRUE(row(sums, "CONDENSE").all_counted);
  EXPECT_EQ(row(sums, "CONDENSE").raised, 750U);
  EXPECT_EQ(row(sums, "CONTACT").raised, 0U);
}

TEST(RunProfile, NetsAndLengthsSayWhatWasReused) {
  const RunProfile profile = sample();
  const auto nets = program::net_costs(profile);
  ASSERT_EQ(nets.size(), 2U);
  EXPECT_EQ(nets[0].condensed, 1U);
  EXPECT_EQ(nets[0].reused, 1U);
  EXPECT_EQ(nets[0].flops, 3e9);
  const auto lengths = program::crack_length_costs(profile);
  ASSERT_EQ(lengths.size(), 2U);
  EXPECT_EQ(lengths[0].condensed, (std::vector<std::string>{"LUG", "PIN"}));
  EXPECT_EQ(lengths[1].reused, (std::vector<std::string>{"LUG", "PIN"}));
  EXPECT_EQ(lengths[0].flops, 4e9);
  EXPECT_NEAR(*lengths[0].mesher_cpu, 0.35, 1e-12);
}

// Of one track: each within the one that is open, or behind it, without a bit between them.
void expect_nested(std::vector<json> events) {
  std::ranges::sort(events, [](const json& a, const json& b) {
    return std::pair(a["ts"].get<double>(), -a["dur"].get<double>()) <
           std::pair(b["ts"].get<double>(), -b["dur"].get<double>());
  });
  std::vector<double> ends;
  for (const json& event : events) {
    const double begin = event["ts"];
    const double end = begin + event["dur"].get<double>();
    while (!ends.empty() && ends.back() <= begin) {
      ends.pop_back();
    }
    if (!ends.empty()) {
      EXPECT_LE(end, ends.back()) << event;
    }
    ends.push_back(end);
  }
}

std::map<std::pair<int, int>, std::vector<json>> tracks_of(const json& trace) {
  std::map<std::pair<int, int>, std::vector<json>> tracks;
  for (const json& event : trace["traceEvents"]) {
    if (event["ph"] == "X") {
      EXPECT_GE(event["ts"].get<double>(), 0.0);
      EXPECT_GE(event["dur"].get<double>(), 0.0);
      EXPECT_TRUE(event["args"].is_object()) << event;
      tracks[{event["pid"], event["tid"]}].push_back(event);
    }
  }
  return tracks;
}

TEST(RunProfile, TheTraceIsValidAndItsEventsNest) {
  const json trace = json::parse(program::trace_json(sample()));
  const auto tracks = tracks_of(trace);
  ASSERT_EQ(tracks.size(), 3U); // main, a thread beside it, the mesher
  for (const auto& [track, events] : tracks) {
    expect_nested(events);
  }
  double processors = 0.0;
  for (const json& event : tracks.at({1, 0})) {
    processors += event["cat"] == "processor" ? event["dur"].get<double>() : 0.0;
  }
  EXPECT_NEAR(processors, 8e6, 1.0); // the intervals, in microseconds
  for (const json& event : trace["traceEvents"]) {
    const std::string kind = event["ph"];
    EXPECT_TRUE(kind == "X" || kind == "M" || kind == "C") << kind;
  }
}

TEST(RunProfile, WhatIsNotKnownIsCalledUnknown) {
  program::ProfileWithCostFloor record{.profile = sample(), .floor = {}, .bytes_read = 10};
  record.floor.why_not = "its matrix is singular";
  record.profile.mesher.back().cpu.reset();
  const std::string text = program::profile_text(record);
  EXPECT_NE(text.find("unknown: its matrix is singular"), std::string::npos) << text;
  EXPECT_NE(text.find("plain factorisations the run took is unknown"), std::string::npos);
  EXPECT_TRUE(std::isnan(program::cost_over_floor(record)));
  const std::string table = program::profile_csv(record);
  EXPECT_NE(table.find("\nfloor,plain factorisation,,,,,"), std::string::npos) << table;
  EXPECT_NE(table.find("\nprocessor,MESHER,,,2,,"), std::string::npos) << table;
}

TEST(RunProfile, CountsPlainFactorisations) {
  program::ProfileWithCostFloor record{.profile = sample(), .floor = {}};
  record.floor = {.why_not = {},
                  .equations = 9,
                  .entries = 20,
                  .flops = 1e6,
                  .assembly = 7.0,
                  .analysis = 0.25,
                  .numeric = 0.5,
                  .solution = 0.25,
                  .times = 1};
  EXPECT_NEAR(program::cost_over_floor(record), 10.25, 1e-12);
  EXPECT_NE(program::profile_text(record).find("The run took 10.2 plain factorisations, 5.12 for "
                                               "each of its 2 crack lengths"),
            std::string::npos);
}

TEST(RunProfile, ARecorderTakesDownStretchesAndLengths) {
  analysis::ProfileRecorder recorder(base::Stopwatch(), base::cpu_seconds());
  {
    analysis::ScopedProfileCrackLength length(&recorder);
    const analysis::ScopedProfileInterval stretch(&recorder, "TOPOLOGY", "cut");
    length.set_length(3.0);
  }
  { const analysis::ScopedProfileInterval stretch(&recorder, "OUTPUT", "tables"); }
  const RunProfile profile = recorder.finish();
  ASSERT_EQ(profile.intervals.size(), 2U);
  EXPECT_EQ(profile.intervals[0].length, 0U);
  EXPECT_FALSE(profile.intervals[1].length);
  EXPECT_TRUE(profile.intervals[0].resident && *profile.intervals[0].resident > 0);
  ASSERT_EQ(profile.lengths.size(), 1U);
  EXPECT_EQ(profile.lengths[0].a, 3.0);
  EXPECT_FALSE(profile.lengths[0].counts);
  for (const auto& [track, events] : tracks_of(json::parse(program::trace_json(profile)))) {
    expect_nested(events);
  }
}

// Two plates, one above the other; `between` holds them together.
std::string two_plates(const std::string& between) {
  return "$DECK VERSION=1 LENGTH=mm FORCE=N\n"
         "$NET NAME=LOW\n$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX=6 NY=3\n$ENDNET\n"
         "$NET NAME=TOP\n$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX=4 NY=2 Y0=5\n$ENDNET\n"
         "$MATERIAL NAME=M E=1000 NU=0.3\n"
         "$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=STRESS\n"
         "$PROPERTY ESET=TOP.BODY MATERIAL=M STATE=STRESS\n"
         "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  LOW.YMIN\n" +
         between +
         "$LOAD CASE=PUSH TYPE=TRACTION\n  TOP.YMAX 0 -1\n"
         "$STEP NAME=PUSH\n  LOAD PUSH 1\n$END\n";
}

program::FactorisationCostFloor floor_of(const std::string& text) {
  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "test.deck";
  std::ofstream(file) << text;
  const program::CheckedDeck ready =
      program::read_and_check_deck(file, {}, program::Log(program::LogFormat::text));
  EXPECT_TRUE(ready.model);
  return ready.model ? program::measure_factorisation_cost_floor(*ready.model)
                     : program::FactorisationCostFloor();
}

TEST(RunProfile, TheFloorIsOneFactorisationOfAllBodies) {
  // Nodes of quadratic elements: (2 nx + 1)(2 ny + 1) - nx ny, without those that are held.
  const auto nodes = [](int nx, int ny) { return (2 * nx + 1) * (2 * ny + 1) - nx * ny; };
  const std::string contact = "$CONTACT NAME=C MASTER=LOW.YMAX SLAVE=TOP.YMIN\n"
                              "$FREEDOM CLASS=SUPPRESSED DOF=X\n  TOP.XMIN\n";
  const program::FactorisationCostFloor apart = floor_of(two_plates(contact));
  EXPECT_EQ(apart.why_not, "");
  EXPECT_EQ(apart.equations, 2 * (nodes(6, 3) - 13) + 2 * nodes(4, 2) - 5);
  EXPECT_GT(apart.flops, 0.0);
  EXPECT_GE(apart.entries, static_cast<double>(apart.equations));
  EXPECT_GE(apart.times, 1);
  // Tied freedoms follow, and have no row.
  const program::FactorisationCostFloor tied =
      floor_of(two_plates("$MPC TYPE=TRANSITION SLAVE=TOP.YMIN MASTER=LOW.YMAX\n"));
  EXPECT_EQ(tied.why_not, "");
  EXPECT_EQ(tied.equations, 2 * (nodes(6, 3) - 13) + 2 * nodes(4, 2) - 2 * 9);
}

// A process begins with the peak of the one that started it, as getrusage has it.
TEST(RunProfile, ThePeakOfMemoryIsTheProgramsOwn) {
  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "test.deck";
  std::ofstream(file) << two_plates("$MPC TYPE=TRANSITION SLAVE=TOP.YMIN MASTER=LOW.YMAX\n");
  constexpr std::size_t mebi = std::size_t{1} << 20U;
  const std::vector<char> much(400 * mebi, 'x');
  EXPECT_GT(base::peak_memory(), much.size());
  const program::ChildRun run{
      .deck = file, .out = folder.path() / "out", .defines = {}, .threads = 1};
  program::ChildRunner(test::program_file())
      .run_all_children({&run, 1}, 1, [](std::size_t, const program::ChildProcessResult& end) {
        EXPECT_EQ(end.exit_code, 0);
      });
  const std::string listing = test::slurp(run.out / "listing.txt");
  const std::string before = "at most ";
  const std::size_t at = listing.find(before);
  ASSERT_NE(at, std::string::npos);
  EXPECT_LT(std::stod(listing.substr(at + before.size())), 380.0);
  EXPECT_GT(std::stod(listing.substr(at + before.size())), 1.0);
}

} // namespace
} // namespace spricka::test_profile
