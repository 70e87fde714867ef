// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/verification_report.hpp"

#include "program/trials/child_run.hpp"
#include "program/verify/verification_tables.hpp"
#include "report/drawing/plot.hpp"
#include "report/page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

/// Errors below this part of the reference are drawn here.
constexpr double smallest_drawn = 1e-9;

// The largest relative error of a deck against a reference, by what it takes; empty: it has none.
std::optional<report::DrawingPoint> mark_of(const VerifiedDeck& deck) {
  std::optional<double> worst;
  for (const VerifiedPoint& point : deck.points) {
    for (const results::CheckResult& check : point.checks) {
      if (check.relative && check.trouble.empty() && !has_recorded_reference(check)) {
        worst = std::max(worst.value_or(smallest_drawn), std::abs(check.error));
      }
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
    series.marker = report::closed_marker_shape(failed ? 1 : 0);
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
      verification.program, verification.machine, verification.at_once, count(verification).cpu,
      verification.wall, megabytes(count(verification).memory));
}

void add_comparison(report::HtmlPage& page, const VerificationComparison& comparison) {
  page.add_heading("Since the last verification");
  page.add_paragraph(fmt::format("Before: {} on {}. {}.", comparison.program, comparison.machine,
                                 summary(comparison)));
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
    for (const VerifiedPoint& point : deck.points) {
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
  for (const std::string& line : summary(verification)) {
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
  const bool failed = worst_outcome(verification) != base::Outcome::done;
  page.add_html("<h1>Verification</h1>\n");
  page.add_paragraph(machine_words(verification), "about");
  for (const std::string& line : summary(verification)) {
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
