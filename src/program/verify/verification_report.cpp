// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/verification_report.hpp"

#include "base/exit_codes.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/plot.hpp"
#include "report/page.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <boost/range/adaptor/filtered.hpp>
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

std::string what_of(const VerifiedDeck& deck, const DeckRunChecks& point) {
  return fmt::format("{}{}{}", deck.title, point.values.empty() ? "" : ", ", point.values);
}

std::string check_count(const DeckRunChecks& point) {
  const auto recorded = std::ranges::count_if(point.checks, has_recorded_reference);
  return fmt::format("{}{}", point.checks.size(),
                     recorded > 0 ? fmt::format(" ({} recorded)", recorded) : "");
}

// Of a deck that ended otherwise than by a missed check also how.
std::string passed_count(const VerifiedDeck& deck, const DeckRunChecks& point) {
  const auto passed = std::ranges::count_if(point.checks, &results::CheckResult::passed);
  const auto missed = static_cast<std::ptrdiff_t>(point.checks.size()) - passed;
  const bool broken = deck.failed() && base::outcome_of_exit_code(deck.exit_code) !=
                                           base::ProgramOutcome::check_failed;
  return fmt::format("{}{}{}", passed, missed > 0 ? fmt::format(", {} MISSED", missed) : "",
                     broken ? ", " + end_of(deck) : "");
}

// The largest error of a point over what is allowed; empty where no check has found a value.
std::string largest_share(const DeckRunChecks& point) {
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

// "le1: NAFEMS LE1, elliptic membrane, beta = 0.78".
std::string deck_heading(const VerifiedDeck& deck, const DeckRunChecks& point) {
  return fmt::format("{}: {}", deck.name, what_of(deck, point));
}

// "1240 freedoms, 0.31 s CPU, 45 MB"; of a sweep time and memory are those of all its points.
std::string deck_cost_text(const VerifiedDeck& deck, const DeckRunChecks& point) {
  return fmt::format("{} freedoms, {:.2f} s CPU, {:.0f} MB{}", point.unknowns, deck.cpu,
                     megabytes(deck.peak_memory), deck.points.size() > 1 ? " with all points" : "");
}

// The checks of a point: check, reference, result, error, allowed, bar, source.
report::ReportTable checks_table(const DeckRunChecks& point) {
  using Check = results::CheckResult;
  return report::Columns<Check>()
      .words("check", &Check::text)
      .number("reference", "", &Check::wanted)
      .number("result", "",
              [](const Check& c) {
                return c.trouble.empty() ? report::format_six_digits(c.found) : "-";
              })
      .number("error", "", error_of)
      .number("allowed", "",
              [](const Check& c) { return error_in_words(c.tolerance, c.relative, "{:.4g}"); })
      .number(
          "error bar", "",
          [](const Check& c) { return std::isfinite(c.bar) ? fmt::format("{:.2g}", c.bar) : ""; })
      .words("source", [](const Check& c) { return c.trouble.empty() ? c.source : c.trouble; })
      .table("", point.checks);
}

// Every deck, and every point of a sweep: how many checks, how many passed, the largest error over
// what is allowed, costs of the deck.
report::ReportTable verified_deck_table(const Verification& verification) {
  struct DeckTableRow {
    const VerifiedDeck& deck;
    const DeckRunChecks* point; // null: it has no results
  };
  std::vector<DeckTableRow> rows;
  for (const VerifiedDeck& deck : verification.decks) {
    for (const DeckRunChecks& point : deck.points) {
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
               return r.point ? what_of(r.deck, *r.point) : r.deck.said_last;
             })
      .number("checks", "",
              [](const DeckTableRow& r) { return r.point ? check_count(*r.point) : "0"; })
      .number("passed", "",
              [](const DeckTableRow& r) {
                return r.point ? passed_count(r.deck, *r.point) : end_of(r.deck);
              })
      .number("error / allowed", "",
              [](const DeckTableRow& r) { return r.point ? largest_share(*r.point) : ""; })
      .fill_only_if(
          [](const DeckTableRow& r) { return !r.point || r.point == r.deck.points.data(); })
      .number(
          "CPU, s", "", [](const DeckTableRow& r) { return r.deck.cpu; }, "{:.2f}")
      .number(
          "memory, MB", "", [](const DeckTableRow& r) { return megabytes(r.deck.peak_memory); },
          "{:.0f}")
      .table("", rows);
}

// Problems of the open collections: which decks and tests stand for each, and how they ended.
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
      .table("", problems | boost::adaptors::filtered(std::mem_fn(&BenchmarkProblem::is_covered)));
}

// Those that are not covered, with the reason.
report::ReportTable uncovered_problem_table(const std::vector<BenchmarkProblem>& problems) {
  return report::Columns<BenchmarkProblem>()
      .words("problem", &BenchmarkProblem::name)
      .words("what", &BenchmarkProblem::title)
      .words("not covered, because", &BenchmarkProblem::remark)
      .table("", problems | boost::adaptors::filtered(std::not_fn(&BenchmarkProblem::is_covered)));
}

// Decks that have not ended with 0, and why.
report::ReportTable failed_deck_table(const Verification& verification) {
  return report::Columns<VerifiedDeck>()
      .words("deck", &VerifiedDeck::name)
      .words("ended with", end_of)
      .number("checks missed", "", &VerifiedDeck::missed_check_count)
      .words("said last", &VerifiedDeck::said_last)
      .table("",
             verification.decks | boost::adaptors::filtered(std::mem_fn(&VerifiedDeck::failed)));
}

/// Errors below this part of the reference are drawn here.
constexpr double smallest_drawn = 1e-9;

// The largest relative error of a deck against a reference, by what it takes; empty: it has none.
std::optional<report::DrawingPoint> mark_of(const VerifiedDeck& deck) {
  std::optional<double> worst;
  for (const results::CheckResult& check : checks_at_all_points(deck)) {
    if (check.relative && check.trouble.empty() && !has_recorded_reference(check)) {
      worst = std::max(worst.value_or(smallest_drawn), std::abs(check.error));
    }
  }
  if (!worst || deck.cpu <= 0.0) {
    return std::nullopt;
  }
  return report::DrawingPoint{deck.cpu, *worst};
}

report::Figure error_over_cpu(const Verification& verification) {
  report::Plot plot;
  plot.label = "error over CPU time, deck by deck";
  plot.x_name = "CPU [s]";
  plot.y_name = "largest relative error";
  plot.log_x = plot.log_y = true;
  plot.legend_below = true;
  for (const bool failed : {false, true}) {
    report::PlotSeries series =
        report::styled_curve(failed ? "a check missed" : "all checks passed", failed ? 1 : 0, 0);
    series.joined = false;
    series.marker = report::palette_marker_shape(failed ? 1 : 0);
    for (const VerifiedDeck& deck : verification.decks) {
      const std::optional<report::DrawingPoint> mark = mark_of(deck);
      if (mark && deck.failed() == failed) {
        series.points.push_back(*mark);
      }
    }
    if (!series.points.empty()) {
      plot.series.push_back(std::move(series));
    }
  }
  return {
      {report::draw_svg(plot)},
      "",
      "A mark for each deck: its largest relative error against a reference, and what it takes "
      "on this machine. Errors below 1e-9 are drawn there. How small an error a deck has is its "
      "mesh's choice: decks are as coarse as their tolerance lets them be."};
}

std::string machine_words(const Verification& verification) {
  return fmt::format(
      "{} on {}: {} at a time, one thread each. {:.1f} s CPU, {:.1f} s wall, at most "
      "{:.0f} MB for one.",
      verification.program, verification.machine, verification.at_once,
      count_checks_and_costs(verification).cpu, verification.wall,
      megabytes(count_checks_and_costs(verification).memory));
}

void add_comparison(report::HtmlPage& page, const VerificationComparison& comparison) {
  page.add_heading("Since the last verification");
  page.add_paragraph(fmt::format("Before: {} on {}. {}.", comparison.program, comparison.machine,
                                 comparison_summary(comparison)));
  page.add_paragraph(
      comparison.same_machine
          ? fmt::format("CPU of all decks is {:.2f} times that before, in the median: a deck is "
                        "slower when it takes 1.5 times more than that.",
                        comparison.pace)
          : "Times are not compared: the machine is another one.");
  page.add_table(verification_change_table(comparison));
}

void add_problems(report::HtmlPage& page, const Verification& verification,
                  const std::vector<BenchmarkProblem>& problems) {
  if (problems.empty()) {
    return;
  }
  page.add_heading("Problems of the open collections");
  page.add_table(benchmark_problem_table(verification, problems));
  page.add_table(uncovered_problem_table(problems));
}

void add_decks(report::HtmlPage& page, const Verification& verification) {
  page.add_heading("Decks");
  std::string unchecked;
  for (const VerifiedDeck& deck : verification.decks) {
    bool any = false;
    for (const DeckRunChecks& point : deck.points) {
      report::ReportTable table = checks_table(point);
      table.title = fmt::format("{} ({})", deck_heading(deck, point), deck_cost_text(deck, point));
      page.add_table(table);
      any = any || !table.rows.empty();
    }
    if (!any) {
      unchecked += fmt::format("{}{}", unchecked.empty() ? "" : ", ", deck.name);
    }
  }
  if (!unchecked.empty()) {
    page.add_paragraph("Without a check: " + unchecked + ".");
  }
}

// A cell of a table: a bar of its own would end it.
std::string cell_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    out += c == '|' ? "\\|" : std::string(1, c);
  }
  return out;
}

std::string markdown(const report::ReportTable& table, bool code_first) {
  std::string names = "|";
  std::string rule = "|";
  for (const report::ReportTable::ReportColumn& column : table.columns) {
    names += fmt::format(" {} |", column.name);
    rule += column.words ? "---|" : "---:|";
  }
  std::string out = names + "\n" + rule + "\n";
  for (const std::vector<std::string>& row : table.rows) {
    out += "|";
    for (std::size_t c = 0; c < row.size(); ++c) {
      out += c == 0 && code_first ? fmt::format(" `{}` |", row[c])
                                  : fmt::format(" {} |", cell_text(row[c]));
    }
    out += "\n";
  }
  return out + "\n";
}

std::string chapter_head(const Verification& verification) {
  std::string out = R"(# Verification

Every deck in `decks/` carries its reference values and the error that is allowed (`$CHECK`). This page is what the
decks find; [`spricka verify all --markdown FILE`](verify.md) writes it. The tests run the same decks. A check whose
source is `RECORDED` compares with an earlier value of this program and proves only that the value has not changed.

)";
  for (const std::string& line : verification_summary(verification)) {
    out += line + "\n";
  }
  return out + fmt::format("Times and memory: {}, one thread, {} decks at a time.\n\n",
                           verification.machine, verification.at_once);
}

std::string problem_sections(const Verification& verification,
                             const std::vector<BenchmarkProblem>& problems) {
  if (problems.empty()) {
    return {};
  }
  const report::ReportTable missing = uncovered_problem_table(problems);
  return "## Problems of the open collections\n\n" +
         markdown(benchmark_problem_table(verification, problems), false) +
         (missing.rows.empty() ? "" : "## Not covered\n\n" + markdown(missing, false));
}

std::string deck_section(const Verification& verification, const std::string& table_name) {
  return fmt::format(R"(## Decks

The table has a row for each deck, and for a deck with a sweep a row for each run. The column "error / allowed" has
the largest error of the run's checks over the error that is allowed. CPU time and memory are those of the whole deck.

All single checks are in the file [{0}]({0}), a row for each check: the run, the
quantity with its crack and step, the value found, its reference, the error, the allowed error, the error bar of K and
the source. The page [verify](verify.md#what-it-writes) explains the columns.

)",
                     table_name) +
         markdown(verified_deck_table(verification), true);
}

} // namespace

std::string verification_page(const Verification& verification,
                              const std::vector<BenchmarkProblem>& problems,
                              const std::optional<VerificationComparison>& comparison) {
  report::HtmlPage page;
  const bool failed = worst_outcome(verification) != base::ProgramOutcome::done;
  page.add_html("<h1>Verification</h1>\n");
  page.add_paragraph(machine_words(verification), "about");
  for (const std::string& line : verification_summary(verification)) {
    page.add_paragraph(line, failed ? "failed" : "about");
  }
  page.add_paragraph(fmt::format("Asked for: {}.", fmt::join(verification.asked, " ")), "about");
  if (failed) {
    page.add_heading("Failed");
    page.add_table(failed_deck_table(verification));
  }
  if (comparison) {
    add_comparison(page, *comparison);
  }
  page.add_heading("Error and cost");
  page.add_figure(error_over_cpu(verification));
  add_problems(page, verification, problems);
  add_decks(page, verification);
  return page.finish_page("Verification");
}

std::string verification_chapter(const Verification& verification,
                                 const std::vector<BenchmarkProblem>& problems,
                                 const std::string& table_name) {
  std::string out = chapter_head(verification) + problem_sections(verification, problems) +
                    deck_section(verification, table_name);
  out.erase(out.find_last_not_of('\n') + 1);
  return out + "\n";
}

} // namespace spricka::program
