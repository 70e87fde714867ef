// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/verification_tables.hpp"

#include "base/exit_codes.hpp"
#include "program/trials/child_run.hpp"

#include <algorithm>
#include <cmath>
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
  const auto recorded = std::ranges::count_if(point.checks, is_recorded);
  return fmt::format("{}{}", point.checks.size(),
                     recorded > 0 ? fmt::format(" ({} recorded)", recorded) : "");
}

// Of a deck that ended otherwise than by a missed check also how.
std::string passed_count(const VerifiedDeck& deck, const VerifiedPoint& point) {
  const auto passed = std::ranges::count_if(point.checks, &results::CheckResult::passed);
  const auto missed = static_cast<std::ptrdiff_t>(point.checks.size()) - passed;
  const bool broken =
      deck.failed() && base::exit_outcome(deck.exit_code) != base::Outcome::check_failed;
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

std::string cost_text(const VerifiedDeck& deck, const VerifiedPoint& point) {
  return fmt::format("{} freedoms, {:.2f} s CPU, {:.0f} MB{}", point.unknowns, deck.cpu,
                     megabytes(deck.memory), deck.points.size() > 1 ? " with all points" : "");
}

report::ReportTable check_table(const VerifiedPoint& point) {
  report::ReportTable table =
      report::make_table("", "<check|reference|result|error|allowed|error bar|<source");
  for (const results::CheckResult& check : point.checks) {
    const bool found = check.trouble.empty();
    table.rows.push_back({check.text, report::six_digits(check.wanted),
                          found ? report::six_digits(check.found) : "-", error_of(check),
                          error_in_words(check.tolerance, check.relative, "{:.4g}"),
                          std::isfinite(check.bar) ? fmt::format("{:.2g}", check.bar) : "",
                          found ? check.source : check.trouble});
  }
  return table;
}

report::ReportTable deck_table(const Verification& verification) {
  report::ReportTable table =
      report::make_table("", "<deck|<what|checks|passed|error / allowed|CPU, s|memory, MB");
  for (const VerifiedDeck& deck : verification.decks) {
    std::string cpu = fmt::format("{:.2f}", deck.cpu);
    std::string memory = fmt::format("{:.0f}", megabytes(deck.memory));
    for (const VerifiedPoint& point : deck.points) {
      table.rows.push_back({deck.name, what_of(deck, point), check_count(point),
                            passed_count(deck, point), largest_share(point), std::exchange(cpu, ""),
                            std::exchange(memory, "")});
    }
    if (deck.points.empty()) {
      table.rows.push_back({deck.name, deck.message, "0", end_of(deck), "", cpu, memory});
    }
  }
  return table;
}

report::ReportTable problem_table(const Verification& verification,
                                  const std::vector<BenchmarkProblem>& problems) {
  report::ReportTable table =
      report::make_table("", "<problem|<what|<decks, other tests|<|<remark");
  for (const BenchmarkProblem& problem : problems) {
    if (problem.is_covered()) {
      std::vector<std::string> by = problem.decks;
      by.insert(by.end(), problem.tests.begin(), problem.tests.end());
      table.rows.push_back({problem.name, problem.title, fmt::format("{}", fmt::join(by, ", ")),
                            standing(verification, problem), problem.remark});
    }
  }
  return table;
}

report::ReportTable uncovered_table(const std::vector<BenchmarkProblem>& problems) {
  report::ReportTable table = report::make_table("", "<problem|<what|<not covered, because");
  for (const BenchmarkProblem& problem : problems) {
    if (!problem.is_covered()) {
      table.rows.push_back({problem.name, problem.title, problem.remark});
    }
  }
  return table;
}

report::ReportTable failed_table(const Verification& verification) {
  report::ReportTable table = report::make_table("", "<deck|<ended with|checks missed|<said last");
  for (const VerifiedDeck& deck : verification.decks) {
    if (!deck.failed()) {
      continue;
    }
    table.rows.push_back(
        {deck.name, end_of(deck), std::to_string(deck.missed_checks()), deck.message});
  }
  return table;
}

report::ReportTable change_table(const VerificationComparison& comparison) {
  report::ReportTable table = report::make_table("", "<what|<deck|<check|before|now");
  for (const ChangeKind& kind : change_kinds) {
    for (const VerificationChange& change : comparison.*kind.changes) {
      table.rows.push_back({kind.in_table, change.deck, change.what,
                            fmt::format("{:.3g}", kind.unit * change.before),
                            fmt::format("{:.3g}", kind.unit * change.now)});
    }
  }
  return table;
}

} // namespace spricka::program
