// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/model_marks.hpp"
#include "report/drawing/plot.hpp"
#include "report/drawing/round_off.hpp"
#include "report/report.hpp"
#include "report/sweep_files.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/k_section.hpp"
#include "report/topics/parameter_unit.hpp"
#include "report/topics/result_tables.hpp"
#include "sample.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>

#include <charconv>

namespace spricka::report::test_page {
namespace {

std::string page_of(const test::Sample& sample) {
  return html_report(sample.sources, sample.model, sample.run);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The x of the text element that reads so.
double place_of(const std::string& drawing, const std::string& words) {
  const std::size_t end = drawing.find(">" + words + "<");
  EXPECT_NE(end, std::string::npos) << words;
  const std::size_t at = drawing.rfind("<text x=\"", end) + 9;
  double x = 0.0;
  std::from_chars(drawing.data() + at, drawing.data() + drawing.size(), x);
  return x;
}

TEST(HtmlPage, SaysAtItsHeadThatThereAreWarnings) {
  test::Sample sample = test::make_sample();
  EXPECT_FALSE(contains(page_of(sample), "class=\"warnings\""));
  for (const char* const name : {"first", "second", "third", "fourth"}) {
    sample.run.warnings.push_back({"W508", fmt::format("the {} <thing>{:>300}", name, "zzz")});
  }
  const std::string page = page_of(sample);
  const std::string head = page.substr(0, page.find("<h2"));
  EXPECT_TRUE(contains(head, "<a href=\"#notes\">4 warnings</a>; the first 3:"));
  EXPECT_TRUE(contains(head, "<b>W508, no answer:</b> the third &lt;thing&gt;"));
  EXPECT_FALSE(contains(head, "fourth")) << "it stands under the notes";
  EXPECT_FALSE(contains(head, "zzz")) << "a long one is cut";
  const std::string notes = page.substr(page.find("<h2 id=\"notes\">"));
  EXPECT_TRUE(contains(notes, "fourth"));
  EXPECT_TRUE(contains(notes, "zzz"));
}

TEST(KReportSection, HasEveryStepThatLoadsTheCracks) {
  test::Sample sample = test::make_sample();
  KReportSection section = make_k_report_section(sample.model, sample.run);
  ASSERT_EQ(section.tables.size(), 2U);
  EXPECT_TRUE(contains(section.tables[0].title, "LOAD"));
  EXPECT_TRUE(contains(section.tables[1].title, "PRESS"));
  EXPECT_EQ(section.tables[1].rows.size(), sample.run.increments.size());
  ASSERT_EQ(section.remarks.size(), 1U);
  EXPECT_EQ(section.remarks[0], "K is 0 at the end of UNLOAD.");

  sample.run.increments.resize(1); // one length: one table, and why UNLOAD has no bar
  section = make_k_report_section(sample.model, sample.run);
  ASSERT_EQ(section.tables.size(), 1U);
  EXPECT_EQ(section.tables[0].rows.size(), 3U);
  ASSERT_EQ(section.remarks.size(), 1U);
  EXPECT_TRUE(contains(section.remarks[0], "No error bar for step UNLOAD: "));
}

TEST(KReportSection, OfManyLengthsShowsTheLeadingStepAndNamesTheOthers) {
  test::Sample sample = test::make_sample();
  const results::CrackLengthResult one = sample.run.increments.front();
  while (sample.run.increments.size() < 50) {
    sample.run.increments.push_back(one);
  }
  const KReportSection section = make_k_report_section(sample.model, sample.run);
  ASSERT_EQ(section.tables.size(), 1U);
  EXPECT_TRUE(contains(section.tables[0].title, "LOAD"));
  EXPECT_TRUE(contains(section.remarks[0], "(PRESS)"));
}

TEST(KReportSection, ShowsRoundOffAsZero) {
  test::Sample sample = test::make_sample();
  sample.run.increments.resize(1);
  results::FrontPointResult& tip = sample.run.increments[0].steps[2].fronts[0].single_point();
  tip.K1 = 1e-12;
  tip.G = tip.G_from_K = 1e-30;
  const KReportSection section = make_k_report_section(sample.model, sample.run);
  for (const ReportTable& table : {section.tables.at(0), section.folded.at(0)}) {
    EXPECT_EQ(table.rows[2][3], "0");
  }
  EXPECT_EQ(section.folded[0].rows[2][7], "0") << "G";
}

TEST(MissingBars, AreGroupedByTheirReason) {
  test::Sample sample = test::make_sample();
  const std::vector<std::string> both{"PRESS", "LOAD"};
  EXPECT_TRUE(missing_error_bar_reasons(sample.run, both).empty());
  for (results::LoadStepResult& step : sample.run.increments[1].steps) {
    step.fronts[0].missing_bar_reason = "it is too hot";
  }
  std::vector<std::string> words = missing_error_bar_reasons(sample.run, both);
  ASSERT_EQ(words.size(), 1U);
  EXPECT_EQ(words[0], "No error bar for increment 2: it is too hot.");
  for (results::LoadStepResult& step : sample.run.increments[0].steps) {
    step.fronts[0].missing_bar_reason = "it is too hot";
  }
  words = missing_error_bar_reasons(sample.run, both);
  ASSERT_EQ(words.size(), 1U);
  EXPECT_EQ(words[0], "No error bar for any K here: it is too hot.");
}

TEST(ReferenceTable, HasNoPercentOfZero) {
  test::Sample sample = test::make_sample();
  sample.model.checks[0].value = 0.0;
  const ReportTable table = k_reference_table(sample.model, sample.run);
  EXPECT_EQ(table.rows[0][6], "");
  EXPECT_EQ(table.rows[1][6], "-1.96");
}

TEST(HtmlPage, NamesTheLengthsOfItsForces) {
  test::Sample sample = test::make_sample();
  EXPECT_TRUE(contains(page_of(sample), "At the last length, a = 18 mm."));
  results::LoadStepResult& last = sample.run.increments.back().steps.back();
  last.fronts.push_back(last.fronts.front());
  last.fronts.back().name = "C2";
  last.fronts.back().a = 2.0;
  EXPECT_TRUE(contains(page_of(sample), "C1: a = 18 mm, C2: a = 2 mm."));
}

TEST(BarWords, BoundOnlyWhatHasABar) {
  PlotSeries series;
  series.points = {{1.0, 100.0}, {2.0, 200.0}, {3.0, 300.0}};
  EXPECT_EQ(error_bar_note({series}), "");
  series.bars = {1.0, 1.0, 1.0};
  EXPECT_TRUE(contains(error_bar_note({series}), "at most 1 % of it"));
  EXPECT_FALSE(contains(error_bar_note({series}), "only"));
  series.bars = {no_bar, 1.0, no_bar};
  EXPECT_TRUE(
      contains(error_bar_note({series}), "for 1 of 3 points only, and there at most 0.5 %"));
  series.bars = {no_bar, no_bar, no_bar};
  EXPECT_EQ(error_bar_note({series}), "");
}

TEST(Plots, KeepTheAxisTitleClearOfWideNumbers) {
  Plot plot{"wide", "a", "K of wide numbers", {}};
  plot.series.emplace_back().points = {{0.0, 0.0}, {1.0, 546029.0}};
  const std::string drawing = draw_svg(plot);
  constexpr double digit = 6.68; // of 12 pixel figures in Helvetica: 0.556 of the size
  const double title = place_of(drawing, "K of wide numbers") + 13.0 * 0.35;
  EXPECT_GT(place_of(drawing, "500000") - 6.0 * digit, title);
}

TEST(Plots, WritePowersOfTenAsReadersDo) {
  Plot plot{"powers", "a", "b", {}};
  plot.log_x = plot.log_y = true;
  plot.series.emplace_back().points = {{1e-6, 1.0}, {1.0, 1e7}};
  const std::string drawing = draw_svg(plot);
  for (const char* const number : {">1000<", ">10⁶<", ">10⁻⁵<", ">0.01<", ">1<"}) {
    EXPECT_TRUE(contains(drawing, number)) << number;
  }
  const std::string seen =
      std::regex_replace(drawing, std::regex(R"re( data-[a-z-]+="[^"]*")re"), "");
  EXPECT_FALSE(contains(seen, "e+"));
  EXPECT_FALSE(contains(seen, "e-0"));
}

// All stresses times a factor, displacements as they are: a body that expands freely.
void scale_stresses(test::Sample& sample, const std::string& step, double factor) {
  for (results::CrackLengthResult& increment : sample.run.increments) {
    for (results::LoadStepResult& at : increment.steps) {
      for (results::Stress& stress : at.stress) {
        for (double& s : stress) {
          s *= at.step == step || step.empty() ? factor : 1.0;
        }
      }
    }
  }
}

TEST(RoundOff, StressesThatAreNothingElseAreNotDrawn) {
  test::Sample sample = test::make_sample();
  EXPECT_TRUE(contains(mesh_figures(sample.model, sample.run)[1].caption, "step LOAD, a = "));
  scale_stresses(sample, "LOAD", 1e-16);
  const Figure other = mesh_figures(sample.model, sample.run)[1];
  EXPECT_EQ(other.drawings.size(), 3U);
  EXPECT_TRUE(contains(other.caption, "step PRESS, a = ")) << other.caption;
  scale_stresses(sample, "PRESS", 1e-16);
  const Figure none = mesh_figures(sample.model, sample.run)[1];
  EXPECT_EQ(none.drawings.size(), 1U);
  EXPECT_TRUE(contains(none.caption, "round-off")) << none.caption;
}

// A press fit's forces balance on each body: what is left of them is no force.
TEST(RoundOff, ForcesThatAreNothingElseAreShownAsZero) {
  test::Sample sample = test::make_sample();
  results::CrackLengthResult& increment = sample.run.increments[0];
  for (results::LoadStepResult& step : increment.steps) {
    step.balance = {{"SLEEVE", {7e-12, 0, 0}, {0, 0, 0}, {-3e-11, 2e-12, 0}, {0, 0, 0}, 100.0}};
    step.contacts.clear();
  }
  const ReportTable table = force_balance_table(sample.model, increment);
  for (const std::size_t column : {2U, 3U, 6U, 7U}) {
    EXPECT_EQ(table.rows[0][column], "0") << table.columns[column].name;
  }
  increment.steps[0].balance[0].applied.x() = 7.0;
  EXPECT_EQ(force_balance_table(sample.model, increment).rows[0][2], "7");
}

// A body of a million times the stiffness says nothing about the stresses of the others.
TEST(RoundOff, IsMeasuredByTheSoftestBody) {
  test::Sample sample = test::make_sample();
  const results::CrackLengthResult& increment = sample.run.increments[0];
  const double stress = reference_elastic_stress(sample.model, increment);
  const double force = reference_elastic_force(sample.model, increment);
  sample.model.materials[1].E *= 1e6;
  EXPECT_EQ(reference_elastic_stress(sample.model, increment), stress);
  EXPECT_EQ(reference_elastic_force(sample.model, increment), force);
  sample.model.materials[0].E *= 2.0;
  EXPECT_DOUBLE_EQ(reference_elastic_stress(sample.model, increment), 2.0 * stress);
  sample.model.properties.clear();
  EXPECT_EQ(reference_elastic_force(sample.model, increment), 0.0);
}

TEST(ModelMarks, ShowWhatIsHeated) {
  test::Sample sample = test::make_sample();
  EXPECT_FALSE(contains(model_marks_legend(sample.model, 660.0), "temperature"));
  model::Load load;
  load.type = model::LoadType::temperature;
  load.elements = base::ElementSetId(1);
  sample.model.cases = {{"COLD", {load}}, {"HOT", {load}}};
  EXPECT_TRUE(contains(model_marks_legend(sample.model, 660.0), ">temperature COLD, HOT<"));
  const std::string drawing = mesh_figures(sample.model, sample.run)[0].drawings[0];
  sample.model.cases.clear();
  const std::string without = mesh_figures(sample.model, sample.run)[0].drawings[0];
  EXPECT_GT(drawing.size(),
            without.size() + 40 * sample.model.mesh.element_sets[1].elements.size());
}

TEST(ParameterUnit, IsThatOfTheNumberInTheDeck) {
  base::SourceTexts sources;
  sources.add_text("a.deck", "$PARAMETER\n  Delta = 84[um] ! old: delta = 3[kN]\n n = 3\n"
                             "! phi = 3[mm]\r\n phi=-30[deg]\r\n two = 2*3[mm]\n p = 1e3 [psi]\n");
  const base::UnitSystem system;
  EXPECT_EQ(find_parameter_unit(sources, system, "delta"), "mm");
  EXPECT_EQ(find_parameter_unit(sources, system, "n"), "");
  EXPECT_EQ(find_parameter_unit(sources, system, "phi"), "rad");
  EXPECT_EQ(find_parameter_unit(sources, system, "two"), "");
  EXPECT_EQ(find_parameter_unit(sources, system, "p"), "MPa");
  EXPECT_EQ(find_parameter_unit(sources, system, "elta"), "");
}

TEST(SweepPage, HasErrorBarsStepChecksAndUnits) {
  test::Sample sample = test::make_sample();
  sample.sources.add_text("more.inc", "$PARAMETER\n delta = 0.1[mm]\n");
  results::SweepResult sweep{{"delta"}, 3, {}};
  for (const double delta : {0.1, 0.2}) {
    results::SweepPoint point;
    point.folder = "001";
    point.values = {delta};
    point.checks = 4;
    point.passed = 3;
    point.outcome = base::ProgramOutcome::check_failed;
    point.warnings = delta > 0.15 ? 7 : 0;
    results::RunResult run = sample.run;
    run.increments.resize(1);
    point.cells = collect_sweep_values_of_run(sample.model, run);
    sweep.points.push_back(point);
  }
  results::SweepPoint failed;
  failed.values = {0.3};
  failed.outcome = base::ProgramOutcome::not_solvable;
  failed.error = "it is singular";
  sweep.points.push_back(failed);
  const std::string page = sweep_page(sample.sources, sample.model, sweep);
  const results::FrontPointResult& tip = sample.run.increments[0].steps[1].fronts[0].single_point();
  EXPECT_TRUE(contains(page, "At the end of step LOAD"));
  EXPECT_TRUE(contains(page, "3 of 4 passed"));
  EXPECT_TRUE(
      contains(page, fmt::format("<td>{:.5g}</td><td>{:.2g}</td>", tip.K1, tip.bar[0].size())));
  EXPECT_TRUE(contains(page, "<th>delta<br><span>mm</span></th>"));
  EXPECT_TRUE(contains(page, ">delta  [mm]<"));
  EXPECT_TRUE(contains(page, "p max BUSH"));
  EXPECT_TRUE(contains(page, "Error bars: "));
  EXPECT_TRUE(contains(page, "it is singular"));
  EXPECT_TRUE(contains(page, "1 of the points have warnings"));
  EXPECT_TRUE(contains(page, "<td class=\"w\">7</td>"));
}

TEST(SweepPage, HasLives) {
  test::Sample sample = test::make_sample();
  results::SweepResult sweep{{"delta"}, 2, {}};
  for (const double life : {1234.0, 5678.0}) {
    results::SweepPoint point;
    point.values = {life};
    results::RunResult run = sample.run;
    run.growth.emplace();
    run.growth->curve = {{0.0, {1.0}}, {life, {2.0}}};
    point.cells = collect_sweep_values_of_run(sample.model, run);
    EXPECT_EQ(point.cells.front().column_name(), "N");
    sweep.points.push_back(point);
  }
  const std::string page = sweep_page(sample.sources, sample.model, sweep);
  EXPECT_TRUE(contains(page, "<th>N<br><span>cycles</span></th>"));
  EXPECT_TRUE(contains(page, "N [cycles] over the swept parameter"));
  // later lengths are other ones at each point
  EXPECT_TRUE(contains(page, "increment 1 (a"));
  EXPECT_FALSE(contains(page, "increment 2"));
  EXPECT_TRUE(contains(page, "<td>1234</td>"));
  EXPECT_TRUE(contains(page, "<td>5678</td>"));
}

} // namespace
} // namespace spricka::report::test_page
