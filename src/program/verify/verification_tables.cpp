// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/verification_tables.hpp"

#include "base/exit_codes.hpp"
#include "program/trials/child_run.hpp"
#include "report/drawing/columns.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::string error_in_words(double value, bool relative, const char* form) {
  return relative ? fmt::format("{} %", fmt::format(fmt::runtime(form), 100.0 * value))
                  : fmt::format("{:.2g}", value);
}

std::string error_of(const results::CheckResult& check) {
  if (!check.trouble.empty()) {
    return "-";
  }
  return error_in_words(check.error, check.relative, "{:+.3f}") + (check.passed ? "" : " MISSED");
}

std::string end_of(const VerifiedDeck& deck) {
  if (deck.late) {
    return "too slow, ended";
  }
  return deck.exit_code > 128 ? fmt::format("signal {}", deck.exit_code - 128)
                              : fmt::format("exit code {}", deck.exit_code);
}

std::string what_of(const VerifiedDeck& deck, const VerifiedPoint& point) {
  return fmt::format("{}{}{}", deck.title, point.values.empty() ? "" : ", ", point.values);
}

std::string check_count(const VerifiedPoint& point) {
  const auto recorded = std::ranges::count_if(point.checks, has_recorded_reference);
  return fmt::format("{}{}", point.checks.size(),
                     recorded > 0 ? fmt::format(" ({} recorded)", recorded) : "");
}

// Of a deck that ended otherwise than by a missed check also how.
std::string passed_count(const VerifiedDeck& deck, const VerifiedPoint& point) {
  const auto passed = std::ranges::count_if(point.checks, &results::CheckResult::passed);
  const auto missed = static_cast<std::ptrdiff_t>(point.checks.size()) - passed;
  const bool broken =
      deck.failed() && base::outcome_of_exit_code(deck.exit_code) != base::Outcome::check_failed;
  return fmt::format("{}{}{}", passed, missed > 0 ? fmt::format(", {} MISSED", missed) : "",
                     broken ? ", " + end_of(deck) : "");
}

// The largest error of a point over what is allowed; empty where no check has found a value.
std::string largest_share(const VerifiedPoint& point) {
  double largest = -1.0;
  for (const results::CheckResult& check : point.checks) {
    if (check.trouble.empty()) {
      const double error = std::abs(check.error);
      largest = std::max(largest, error > 0.0 ? error / check.tolerance : 0.0);
    }
  }
  return largest < 0.0 ? "" : fmt::format("{:.2f}", largest);
}

// How the decks of a problem have ended, as far as they were run.
std::string standing(const Verification& verification, const BenchmarkProblem& problem) {
  std::size_t run = 0;
  std::size_t failed = 0;
  for (const std::string& name : problem.decks) {
    const auto found = std::ranges::find(verification.decks, name, &VerifiedDeck::name);
    if (found != verification.decks.end()) {
      ++run;
      failed += found->failed() ? 1 : 0;
    }
  }
  if (failed > 0) {
    return fmt::format("{} of {} FAILED", failed, problem.decks.size());
  }
  if (problem.decks.empty()) {
    return "by a test";
  }
  return run == problem.decks.size() ? "passed"
         : run == 0                  ? "not run"
                                     : fmt::format("{} of {} run", run, problem.decks.size());
}

} // namespace

std::string deck_heading(const VerifiedDeck& deck, const VerifiedPoint& point) {
  return fmt::format("{}: {}", deck.name, what_of(deck, point));
}

std::string deck_cost_text(const VerifiedDeck& deck, const VerifiedPoint& point) {
  return fmt::format("{} freedoms, {:.2f} s CPU, {:.0f} MB{}", point.unknowns, deck.cpu,
                     megabytes(deck.memory), deck.points.size() > 1 ? " with all points" : "");
}

report::ReportTable checks_table(const VerifiedPoint& point) {
  using Check = results::CheckResult;
  return report::Columns<Check>()
      .words("check", &Check::text)
      .number("reference", "", &Check::wanted)
      .number("result", "",
              [](const Check& c) { return c.trouble.empty() ? report::six_digits(c.found) : "-"; })
      .number("error", "", error_of)
      .number("allowed", "",
              [](const Check& c) { return error_in_words(c.tolerance, c.relative, "{:.4g}"); })
      .number(
          "error bar", "",
          [](const Check& c) { return std::isfinite(c.bar) ? fmt::format("{:.2g}", c.bar) : ""; })
      .words("source", [](const Check& c) { return c.trouble.empty() ? c.source : c.trouble; })
      .table("", point.checks);
}

report::ReportTable verified_deck_table(const Verification& verification) {
  struct DeckTableRow {
    const VerifiedDeck& deck;
    const VerifiedPoint* point; // null: it has no results
  };
  std::vector<DeckTableRow> rows;
  for (const VerifiedDeck& deck : verification.decks) {
    for (const VerifiedPoint& point : deck.points) {
      rows.push_back({deck, &point});
    }
    if (deck.points.empty()) {
      rows.push_back({deck, nullptr});
    }
  }
  return report::Columns<DeckTableRow>()
      .words("deck", [](const DeckTableRow& r) { return r.deck.name; })
      .words("what",
             [](const DeckTableRow& r) {
               return r.point ? what_of(r.deck, *r.point) : r.deck.message;
             })
      .number("checks", "",
              [](const DeckTableRow& r) { return r.point ? check_count(*r.point) : "0"; })
      .number("passed", "",
              [](const DeckTableRow& r) {
                return r.point ? passed_count(r.deck, *r.point) : end_of(r.deck);
              })
      .number("error / allowed", "",
              [](const DeckTableRow& r) { return r.point ? largest_share(*r.point) : ""; })
      .where([](const DeckTableRow& r) { return !r.point || r.point == r.deck.points.data(); })
      .number(
          "CPU, s", "", [](const DeckTableRow& r) { return r.deck.cpu; }, "{:.2f}")
      .number(
          "memory, MB", "", [](const DeckTableRow& r) { return megabytes(r.deck.memory); },
          "{:.0f}")
      .table("", rows);
}

namespace {

// Those that are covered, or that are not.
std::vector<BenchmarkProblem> problems_that(bool covered,
                                            const std::vector<BenchmarkProblem>& problems) {
  std::vector<BenchmarkProblem> found;
  std::ranges::copy_if(problems, std::back_inserter(found), [&](const BenchmarkProblem& problem) {
    return problem.is_covered() == covered;
  });
  return found;
}

} // namespace

report::ReportTable benchmark_problem_table(const Verification& verification,
                                            const std::vector<BenchmarkProblem>& problems) {
  return report::Columns<BenchmarkProblem>()
      .words("problem", &BenchmarkProblem::name)
      .words("what", &BenchmarkProblem::title)
      .words("decks, other tests",
             [](const BenchmarkProblem& problem) {
               std::vector<std::string> by = problem.decks;
               by.insert(by.end(), problem.tests.begin(), problem.tests.end());
               return fmt::format("{}", fmt::join(by, ", "));
             })
      .words("", [&](const BenchmarkProblem& problem) { return standing(verification, problem); })
      .words("remark", &BenchmarkProblem::remark)
      .table("", problems_that(true, problems));
}

report::ReportTable uncovered_problem_table(const std::vector<BenchmarkProblem>& problems) {
  return report::Columns<BenchmarkProblem>()
      .words("problem", &BenchmarkProblem::name)
      .words("what", &BenchmarkProblem::title)
      .words("not covered, because", &BenchmarkProblem::remark)
      .table("", problems_that(false, problems));
}

report::ReportTable failed_deck_table(const Verification& verification) {
  return report::Columns<VerifiedDeck>()
      .words("deck", &VerifiedDeck::name)
      .words("ended with", end_of)
      .number("checks missed", "", &VerifiedDeck::missed_check_count)
      .words("said last", &VerifiedDeck::message)
      .table("", verification.decks | std::views::filter(&VerifiedDeck::failed));
}

report::ReportTable verification_change_table(const VerificationComparison& comparison) {
  using Row = std::pair<const ChangeKind*, VerificationChange>;
  std::vector<Row> rows;
  for (const ChangeKind& kind : change_kinds) {
    for (const VerificationChange& change : comparison.*kind.changes) {
      rows.emplace_back(&kind, change);
    }
  }
  return report::Columns<Row>()
      .words("what", [](const Row& row) { return row.first->in_table; })
      .words("deck", [](const Row& row) { return row.second.deck; })
      .words("check", [](const Row& row) { return row.second.what; })
      .number(
          "before", "", [](const Row& row) { return row.first->unit * row.second.before; },
          "{:.3g}")
      .number(
          "now", "", [](const Row& row) { return row.first->unit * row.second.now; }, "{:.3g}")
      .table("", rows);
}

} // namespace spricka::program
