// SPDX-License-Identifier: GPL-3.0-or-later
// Verification without running anything: tiers, what counts, tables, what has changed since the
// last time.
#include "base/csv.hpp"
#include "program/verify/comparison.hpp"
#include "program/verify/deck_list.hpp"
#include "program/verify/verification.hpp"
#include "program/verify/verification_report.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/run_text.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace spricka::program::test_verify {
namespace {

namespace fs = std::filesystem;
using test::Folder;

results::CheckResult check_of(const std::string& text, double error, const std::string& source) {
  results::CheckResult check;
  check.text = text;
  check.wanted = 100.0;
  check.error = error;
  check.found = 100.0 * (1.0 + error);
  check.tolerance = 0.01;
  check.passed = std::abs(error) <= 0.01;
  check.source = source;
  return check;
}

VerifiedDeck deck_of(const std::string& name, double cpu,
                     const std::vector<results::CheckResult>& checks) {
  VerifiedDeck deck;
  deck.name = name;
  deck.title = "Title of " + name;
  deck.cpu = cpu;
  deck.peak_memory = 50'000'000;
  deck.points.push_back({.values = "", .unknowns = 1234, .checks = checks});
  const bool missed = std::ranges::any_of(checks, [](const auto& check) { return !check.passed; });
  deck.exit_code = missed ? 1 : 0;
  return deck;
}

Verification sample() {
  Verification v;
  v.program = "spricka 9 (abcd)";
  v.machine = "some \"machine\", 2 cores";
  v.asked = {"all"};
  v.decks = {deck_of("arc", 1.0,
                     {check_of("K1(C,PULL)", 1e-3, "Bowie, \"1956\""),
                      check_of("K2(C,PULL)", -2e-3, "Bowie")}),
             deck_of("bare", 0.1, {}),
             deck_of("kept", 2.0, {check_of("G(C,PULL)", 0.0, "RECORDED")}),
             deck_of("zone", 4.0, {check_of("U.X.AT(0,0,PULL)", 5e-3, "exact")})};
  v.decks[0].points[0].checks[0].bar = 0.2;  // holds 0.1
  v.decks[0].points[0].checks[1].bar = 0.05; // does not hold 0.2
  return v;
}

TEST(Verification, CountsWhatProvesSomethingApartFromWhatDoesNot) {
  const VerificationCounts counts = count_checks_and_costs(sample());
  EXPECT_EQ(counts.checks, 3U);
  EXPECT_EQ(counts.missed, 0U);
  EXPECT_EQ(counts.recorded, 1U);
  EXPECT_EQ(counts.with_reference, 2U);
  EXPECT_EQ(counts.recorded_only, 1U);
  EXPECT_EQ(counts.unchecked, 1U);
  EXPECT_EQ(counts.bars, 2U);
  EXPECT_EQ(counts.within_bars, 1U);
  EXPECT_EQ(worst_outcome(sample()), base::ProgramOutcome::done);
}

// A reference is off by something itself, and may say so.
TEST(Verification, HoldsAReferenceAgainstItsOwnAccuracyToo) {
  Verification v = sample();
  results::CheckResult& second = v.decks[0].points[0].checks[1]; // off by more than its bar
  EXPECT_EQ(count_checks_and_costs(v).of_no_accuracy, 1U);
  const double beyond = std::abs(second.found - second.wanted) - second.bar;
  const double part = 100.0 * beyond / std::abs(second.wanted);
  second.source = fmt::format("handbook, +- {:.6f} %", 1.01 * part);
  EXPECT_EQ(count_checks_and_costs(v).within_accuracy, 1U);
  EXPECT_EQ(count_checks_and_costs(v).of_no_accuracy, 0U);
  second.source = fmt::format("handbook, +- {:.6f} %", 0.99 * part);
  EXPECT_EQ(count_checks_and_costs(v).within_accuracy, 0U);
  EXPECT_EQ(count_checks_and_costs(v).of_no_accuracy, 0U);
}

// Spreadsheets would compute them.
TEST(Verification, FormulasAreTextsInItsTable) {
  EXPECT_EQ(base::quote_csv_field("=HYPERLINK(1)"), "'=HYPERLINK(1)");
  EXPECT_EQ(base::quote_csv_field("@SUM(1,2)"), "\"'@SUM(1,2)\"");
  EXPECT_EQ(base::quote_csv_field("Bowie, 1956"), "\"Bowie, 1956\"");
}

TEST(Verification, EndsAsItsWorstDeckDoes) {
  Verification v = sample();
  v.decks[3] = deck_of("zone", 4.0, {check_of("U.X.AT(0,0,PULL)", 0.02, "exact")});
  EXPECT_EQ(worst_outcome(v), base::ProgramOutcome::check_failed);
  v.decks[1].exit_code = 3;
  EXPECT_EQ(worst_outcome(v), base::ProgramOutcome::deck_error);
  v.decks[2].exit_code = 128 + 11; // a signal
  EXPECT_EQ(worst_outcome(v), base::ProgramOutcome::defect);
}

TEST(Verification, TheTableIsReadAsItWasWritten) {
  const Folder folder;
  const fs::path file = folder.path() / "verification.csv";
  const Verification v = sample();
  std::ofstream(file) << verification_csv(v);
  const auto rows = base::parse_csv_rows(test::slurp(file));
  ASSERT_EQ(rows.size(), 6U); // names, four checks, a deck without one
  for (const auto& row : rows) {
    EXPECT_EQ(row.size(), rows.front().size());
  }
  EXPECT_EQ(rows[1][1], "Title of arc");
  EXPECT_EQ(rows[1][5], "Bowie, \"1956\"");
  const std::optional<Verification> back = read_verification_csv(file);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->program, v.program);
  EXPECT_EQ(back->machine, v.machine);
  ASSERT_EQ(back->decks.size(), v.decks.size());
  EXPECT_EQ(back->decks[0].title, v.decks[0].title);
  EXPECT_EQ(back->decks[0].points[0].checks[1].error, -2e-3);
  EXPECT_TRUE(compare_verifications(v, *back).is_unchanged());
  std::ofstream(file) << "a,b\n1,2\n";
  EXPECT_FALSE(read_verification_csv(file)); // some other table
}

TEST(VerificationComparison, TellsErrorsThatGrewAndChecksThatAreMissedNow) {
  Verification now = sample();
  now.decks[0].points[0].checks[0].error = 1.05e-3; // within a tenth
  now.decks[0].points[0].checks[1].error = 4e-3;    // twice as large, allowed
  now.decks[3].points[0].checks[0] = check_of("U.X.AT(0,0,PULL)", -0.02, "exact");
  const VerificationComparison c = compare_verifications(now, sample());
  ASSERT_EQ(c.worse.size(), 1U);
  EXPECT_EQ(c.worse[0].what, "K2(C,PULL)");
  EXPECT_EQ(c.worse[0].before, 2e-3);
  EXPECT_EQ(c.worse[0].now, 4e-3);
  ASSERT_EQ(c.failed.size(), 1U);
  EXPECT_EQ(c.failed[0].deck, "zone");
  EXPECT_TRUE(c.slower.empty());
  const VerificationComparison back = compare_verifications(sample(), now);
  EXPECT_EQ(back.passed.size(), 1U);
  EXPECT_EQ(back.better.size(), 1U);
}

TEST(VerificationComparison, ABusyMachineIsNoSlowerDeck) {
  Verification now = sample();
  for (VerifiedDeck& deck : now.decks) {
    deck.cpu *= 2.0; // all alike
  }
  EXPECT_TRUE(compare_verifications(now, sample()).slower.empty());
  EXPECT_NEAR(compare_verifications(now, sample()).pace, 2.0, 1e-12);
  now.decks[3].cpu = 2.0 * 8.0; // and one twice as much
  const VerificationComparison c = compare_verifications(now, sample());
  ASSERT_EQ(c.slower.size(), 1U);
  EXPECT_EQ(c.slower[0].deck, "zone");
  // What differs by less than a few starts of the program is noise.
  Verification noisy = sample();
  noisy.decks[1].cpu = 0.3;
  EXPECT_TRUE(compare_verifications(noisy, sample()).slower.empty());
  now.machine = "another";
  EXPECT_TRUE(compare_verifications(now, sample()).slower.empty());
}

TEST(VerificationComparison, MemoryAndSpeedAreTold) {
  Verification now = sample();
  now.decks[3].peak_memory *= 2;
  now.decks[3].cpu = 1.0;
  const VerificationComparison c = compare_verifications(now, sample());
  EXPECT_EQ(c.larger.size(), 1U);
  EXPECT_EQ(c.faster.size(), 1U);
}

TEST(VerificationPage, HoldsEveryCheckTheReasonsAndLoadsNothing) {
  Verification v = sample();
  v.decks[3] = deck_of("zone", 4.0, {check_of("U.X.AT(0,0,PULL)", 0.02, "exact <b>")});
  const std::vector<BenchmarkProblem> problems{{"C01", "Rings", {"arc"}, {}, ""},
                                               {"G04", "Beam", {}, {}, "its drawing is lost"}};
  const std::string page = verification_page(v, problems, compare_verifications(v, sample()));
  EXPECT_NE(page.find("K2(C,PULL)"), std::string::npos);
  EXPECT_NE(page.find("its drawing is lost"), std::string::npos);
  EXPECT_NE(page.find("MISSED"), std::string::npos);
  EXPECT_NE(page.find("1234 freedoms"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_EQ(page.find("exact <b>"), std::string::npos); // escaped
  EXPECT_NE(page.find("missed now"), std::string::npos);
}

TEST(VerificationChapter, HasARowForEachRunAndNamesTheTableOfChecks) {
  Verification v = sample();
  v.decks[0].points.push_back(
      {.values = "beta = 2", .unknowns = 9, .checks = {check_of("K1(C,PULL)", 5e-3, "exact")}});
  v.decks[3] = deck_of("zone", 4.0, {check_of("U.X.AT(0,0,PULL)", 0.02, "exact")});
  const std::vector<BenchmarkProblem> problems{{"C01", "Rings", {"arc"}, {}, ""},
                                               {"G04", "Beam", {}, {}, "its drawing is lost"}};
  const std::string chapter = verification_chapter(v, problems, "checks.csv");
  for (const char* row : {"| `arc` | Title of arc | 2 | 2 | 0.20 | 1.00 | 50 |",
                          "| `arc` | Title of arc, beta = 2 | 1 | 1 | 0.50 |  |  |",
                          "| `bare` | Title of bare | 0 | 0 |  | 0.10 | 50 |",
                          "| `kept` | Title of kept | 1 (1 recorded) | 1 | 0.00 | 2.00 | 50 |",
                          "| `zone` | Title of zone | 1 | 0, 1 MISSED | 2.00 | 4.00 | 50 |",
                          "its drawing is lost", "[checks.csv](checks.csv)"}) {
    EXPECT_NE(chapter.find(row), std::string::npos) << row << "\n" << chapter;
  }
  EXPECT_EQ(chapter.find("K2(C,PULL)"), std::string::npos); // in the table
}

TEST(VerificationChapter, SaysHowADeckEndedThatHasNoResults) {
  Verification v = sample();
  v.decks[1].points.clear();
  v.decks[1].exit_code = 128 + 11; // a signal
  v.decks[1].said_last = "out of memory";
  v.decks[3].exit_code = 5;
  const std::string chapter = verification_chapter(v, {}, "checks.csv");
  for (const char* row : {"| `bare` | out of memory | 0 | signal 11 |  | 0.10 | 50 |",
                          "| `zone` | Title of zone | 1 | 1, exit code 5 | 0.50 | 4.00 | 50 |"}) {
    EXPECT_NE(chapter.find(row), std::string::npos) << row << "\n" << chapter;
  }
}

class Tiers : public testing::Test {
protected:
  void deck(const std::string& name) const {
    std::ofstream(folder.path() / (name + ".deck")) << "$DECK\n$END\n";
  }
  static std::vector<std::string> names(const std::vector<ListedDeck>& decks) {
    std::vector<std::string> all;
    all.reserve(decks.size());
    for (const ListedDeck& d : decks) {
      all.push_back(d.name);
    }
    return all;
  }
  Folder folder;
};

TEST_F(Tiers, QuickAreTheCheapestThatFitTheBudget) {
  for (const char* name : {"cheap", "dear", "mean", "new"}) {
    deck(name);
  }
  std::ofstream(folder.path() / costs_name)
      << "# comment\ndeck,cpu,memory\ncheap,1,20\ndear," << quick_budget << ",30\nmean,3,30\n";
  const std::vector<ListedDeck> decks = list_decks(folder.path());
  base::OptionalFailure trouble;
  EXPECT_EQ(names(select_decks(decks, {"quick"}, trouble)),
            (std::vector<std::string>{"cheap", "mean"}));
  EXPECT_EQ(select_decks(decks, {"all"}, trouble).size(), 4U);
  EXPECT_EQ(names(select_decks(decks, {"*ea*", "new.deck"}, trouble)),
            (std::vector<std::string>{"cheap", "dear", "mean", "new"}));
  EXPECT_FALSE(trouble);
  EXPECT_TRUE(select_decks(decks, {"chep"}, trouble).empty());
  ASSERT_TRUE(trouble);
  EXPECT_EQ(trouble->kind, base::ProgramOutcome::usage);
  EXPECT_NE(trouble->hint.find("cheap"), std::string::npos) << trouble->hint;
}

TEST_F(Tiers, CostsStayWhileTheyAreAboutRight) {
  deck("kept");
  deck("other");
  deck("fresh");
  std::ofstream(folder.path() / costs_name) << "deck,cpu,memory\nkept,1,20\nother,1,20\ngone,1,1\n";
  write_deck_costs(
      folder.path(), list_decks(folder.path()),
      {{"kept", {1.3, 21'000'000}}, {"other", {3.0, 20'000'000}}, {"fresh", {2, 5'000'000}}});
  const auto rows = base::parse_csv_rows(test::slurp(folder.path() / costs_name));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[1], (std::vector<std::string>{"fresh", "2", "5"}));
  EXPECT_EQ(rows[2], (std::vector<std::string>{"kept", "1", "20"}));
  EXPECT_EQ(rows[3], (std::vector<std::string>{"other", "3", "20"}));
}

// The decks that ship: whoever adds one adds its cost (spricka verify DECK --costs) and, where it
// stands for a problem of the collections, its name there.
TEST(ShippedDecks, EachIsInATierAndTheTiersKeepTheirTime) {
  double quick = 0.0;
  double all = 0.0;
  for (const ListedDeck& deck : list_decks(test::decks_folder())) {
    ASSERT_TRUE(deck.cost) << deck.name << " is in no tier: spricka verify " << deck.name
                           << " --costs";
    all += deck.cost->cpu;
    quick += deck.quick ? deck.cost->cpu : 0.0;
  }
  EXPECT_LE(all, whole_budget);
  EXPECT_GT(quick, 0.5 * quick_budget);
}

TEST(ShippedDecks, ProblemsNameDecksThatAreThereOrAReason) {
  std::set<std::string> names;
  for (const ListedDeck& deck : list_decks(test::decks_folder())) {
    names.insert(deck.name);
  }
  const std::vector<BenchmarkProblem> problems = read_benchmark_coverage(test::decks_folder());
  std::set<std::string> ids;
  for (const BenchmarkProblem& problem : problems) {
    EXPECT_TRUE(ids.insert(problem.name).second) << problem.name << " stands there twice";
    for (const std::string& deck : problem.decks) {
      EXPECT_TRUE(names.contains(deck)) << problem.name << ": no deck " << deck;
    }
    EXPECT_TRUE(problem.is_covered() || !problem.remark.empty()) << problem.name;
  }
  EXPECT_EQ(problems.size(), 8U + 15 + 12 + 2 + 5 + 12 + 11);
}

} // namespace
} // namespace spricka::program::test_verify
