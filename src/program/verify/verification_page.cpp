// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/verification_page.hpp"

#include "program/verify/verification_tables.hpp"
#include "report/drawing/plot.hpp"
#include "report/page.hpp"

#include <algorithm>
#include <cmath>

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
      if (check.relative && check.trouble.empty() && !is_recorded(check)) {
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
  report::PlotSeries passed;
  passed.name = "all checks passed";
  passed.joined = false;
  passed.colour = report::palette_colour(0);
  passed.marker = report::closed_marker(0);
  report::PlotSeries failed = passed;
  failed.name = "a check missed";
  failed.colour = report::palette_colour(1);
  failed.marker = report::closed_marker(1);
  for (const VerifiedDeck& deck : verification.decks) {
    if (const std::optional<report::DrawingPoint> mark = mark_of(deck)) {
      (deck.failed() ? failed : passed).points.push_back(*mark);
    }
  }
  for (report::PlotSeries& series : {std::ref(passed), std::ref(failed)}) {
    if (!series.points.empty()) {
      plot.series.push_back(series);
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
      verification.wall, 1e-6 * static_cast<double>(count(verification).memory));
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
  page.add_table(change_table(comparison));
}

void add_problems(report::HtmlPage& page, const Verification& verification,
                  const std::vector<BenchmarkProblem>& problems) {
  if (problems.empty()) {
    return;
  }
  page.add_heading("Problems of the open collections");
  page.add_table(problem_table(verification, problems));
  page.add_table(uncovered_table(problems));
}

void add_decks(report::HtmlPage& page, const Verification& verification) {
  page.add_heading("Decks");
  std::string unchecked;
  for (const VerifiedDeck& deck : verification.decks) {
    bool any = false;
    for (const VerifiedPoint& point : deck.points) {
      report::ReportTable table = check_table(point);
      table.title = fmt::format("{} ({})", deck_heading(deck, point), cost_text(deck, point));
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

} // namespace

std::string verification_page(const Verification& verification,
                              const std::vector<BenchmarkProblem>& problems,
                              const std::optional<VerificationComparison>& comparison) {
  report::HtmlPage page;
  const bool failed = worst_outcome(verification) != base::Outcome::done;
  page.add_html("<h1>Verification</h1>\n");
  page.add_html(
      fmt::format("<p class=\"about\">{}</p>\n", report::escape_xml(machine_words(verification))));
  for (const std::string& line : summary(verification)) {
    page.add_html(fmt::format("<p class=\"{}\">{}</p>\n", failed ? "failed" : "about",
                              report::escape_xml(line)));
  }
  page.add_html(
      fmt::format("<p class=\"about\">Asked for: {}.</p>\n",
                  report::escape_xml(fmt::format("{}", fmt::join(verification.asked, " ")))));
  if (failed) {
    page.add_heading("Failed");
    page.add_table(failed_table(verification));
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

} // namespace spricka::program
