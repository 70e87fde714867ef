// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/verification_tables.hpp"

#include "base/exit_codes.hpp"

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

void add_changes(const std::vector<VerificationChange>& changes, const char* how,
                 report::ReportTable& table) {
  for (const VerificationChange& change : changes) {
    table.rows.push_back({how, change.deck, change.what, fmt::format("{:.3g}", change.before),
                          fmt::format("{:.3g}", change.now)});
  }
}

std::vector<VerificationChange> in_megabytes(std::vector<VerificationChange> changes) {
  for (VerificationChange& change : changes) {
    change.before *= 1e-6;
    change.now *= 1e-6;
  }
  return changes;
}

} // namespace

std::string deck_heading(const VerifiedDeck& deck, const VerifiedPoint& point) {
  return fmt::format("{}: {}", deck.name, what_of(deck, point));
}

std::string cost_text(const VerifiedDeck& deck, const VerifiedPoint& point) {
  return fmt::format("{} freedoms, {:.2f} s CPU, {:.0f} MB{}", point.unknowns, deck.cpu,
                     1e-6 * static_cast<double>(deck.memory),
                     deck.points.size() > 1 ? " with all points" : "");
}

report::ReportTable check_table(const VerifiedPoint& point) {
  report::ReportTable table{"",
                            {{"check", "", true},
                             {"reference", "", false},
                             {"result", "", false},
                             {"error", "", false},
                             {"allowed", "", false},
                             {"error bar", "", false},
                             {"source", "", true}},
                            {}};
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
  report::ReportTable table{"",
                            {{"deck", "", true},
                             {"what", "", true},
                             {"checks", "", false},
                             {"passed", "", false},
                             {"error / allowed", "", false},
                             {"CPU, s", "", false},
                             {"memory, MB", "", false}},
                            {}};
  for (const VerifiedDeck& deck : verification.decks) {
    std::string cpu = fmt::format("{:.2f}", deck.cpu);
    std::string memory = fmt::format("{:.0f}", 1e-6 * static_cast<double>(deck.memory));
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
  report::ReportTable table{"",
                            {{"problem", "", true},
                             {"what", "", true},
                             {"decks, other tests", "", true},
                             {"", "", true},
                             {"remark", "", true}},
                            {}};
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
  report::ReportTable table{
      "", {{"problem", "", true}, {"what", "", true}, {"not covered, because", "", true}}, {}};
  for (const BenchmarkProblem& problem : problems) {
    if (!problem.is_covered()) {
      table.rows.push_back({problem.name, problem.title, problem.remark});
    }
  }
  return table;
}

report::ReportTable failed_table(const Verification& verification) {
  report::ReportTable table{"",
                            {{"deck", "", true},
                             {"ended with", "", true},
                             {"checks missed", "", false},
                             {"said last", "", true}},
                            {}};
  for (const VerifiedDeck& deck : verification.decks) {
    if (!deck.failed()) {
      continue;
    }
    std::ptrdiff_t missed = 0;
    for (const VerifiedPoint& point : deck.points) {
      missed +=
          std::ranges::count_if(point.checks, [](const auto& check) { return !check.passed; });
    }
    table.rows.push_back({deck.name, end_of(deck), std::to_string(missed), deck.message});
  }
  return table;
}

report::ReportTable change_table(const VerificationComparison& comparison) {
  report::ReportTable table{"",
                            {{"what", "", true},
                             {"deck", "", true},
                             {"check", "", true},
                             {"before", "", false},
                             {"now", "", false}},
                            {}};
  add_changes(comparison.failed, "missed now (error)", table);
  add_changes(comparison.worse, "larger error", table);
  add_changes(comparison.slower, "slower (CPU, s)", table);
  add_changes(in_megabytes(comparison.larger), "more memory (MB)", table);
  add_changes(comparison.passed, "passed again (error)", table);
  add_changes(comparison.better, "smaller error", table);
  add_changes(comparison.faster, "faster (CPU, s)", table);
  return table;
}

} // namespace spricka::program
