// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "program/study/study.hpp"
#include "program/study/variant_report.hpp"
#include "report/deck_name.hpp"
#include "report/drawing/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using report::ReportTable;

constexpr double least_error = 1e-12; // of an answer: below it there is round-off

struct CurveKind {
  SettingFamily family;
  bool corrected = false;
  bool joined = true;
};
constexpr std::array curves{CurveKind{SettingFamily::whole},
                            CurveKind{SettingFamily::whole, true},
                            CurveKind{SettingFamily::host},
                            CurveKind{SettingFamily::tip},
                            CurveKind{SettingFamily::quarter},
                            CurveKind{SettingFamily::linear},
                            CurveKind{SettingFamily::transition, false, false},
                            CurveKind{SettingFamily::tolerance},
                            CurveKind{SettingFamily::tube, false, false},
                            CurveKind{SettingFamily::path, false, false},
                            CurveKind{SettingFamily::part},
                            CurveKind{SettingFamily::asked},
                            CurveKind{SettingFamily::asked, true},
                            CurveKind{SettingFamily::peer}};

std::string freedoms_text(const StudyTrial& trial) {
  return trial.unknowns > 0 ? fmt::format("{}", trial.unknowns) : "-";
}

std::string series_name(SettingFamily family, bool corrected) {
  return fmt::format("{}{}", display_name(family), corrected ? ", corrected" : "");
}

// The errors of a family; none where the deck as it is would stand alone.
std::vector<report::DrawingPoint> curve_points(const Study& study, const AnswerGroupVerdict& group,
                                               const CurveKind& curve, bool against_cpu) {
  std::vector<report::DrawingPoint> points;
  bool own = false;
  for (const std::size_t row : find_trials_of_family(study.trials, curve.family)) {
    const StudyTrial& trial = study.trials[row];
    const double error = group.errors[row].plain_or_corrected(curve.corrected);
    const double x = against_cpu ? trial.end.cpu : static_cast<double>(trial.unknowns);
    own = own || trial.variant.family == curve.family;
    if (std::isfinite(error) && x > 0.0) {
      points.push_back({x, 100.0 * std::max(error, least_error)});
    }
  }
  return own ? points : std::vector<report::DrawingPoint>();
}

report::Plot group_plot(const Study& study, const AnswerGroupVerdict& group, bool against_cpu) {
  report::Plot plot =
      empty_logarithmic_plot(fmt::format("error of {} against {}", display_name(group.group),
                                         against_cpu ? "CPU time" : "freedoms"),
                             against_cpu ? "CPU  [s]" : "freedoms",
                             fmt::format("largest error of {}  [%]", display_name(group.group)));
  plot.legend_below = true;
  double low = std::numeric_limits<double>::max();
  double high = 0.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const CurveKind& curve = curves.at(i);
    report::PlotSeries series = report::styled_curve(series_name(curve.family, curve.corrected), i,
                                                     i / 7 + (curve.corrected ? 1 : 0));
    series.marker = report::palette_marker_shape(i);
    series.joined = curve.joined;
    series.points = curve_points(study, group, curve, against_cpu);
    for (const report::DrawingPoint& point : series.points) {
      low = std::min(low, point.x);
      high = std::max(high, point.x);
    }
    if (!series.points.empty()) {
      plot.series.push_back(std::move(series));
    }
  }
  if (group.floor > 0.0 && high > low) {
    plot.series.push_back(
        horizontal_line_series("the reference is no better", low, high, 100.0 * group.floor));
  }
  return plot;
}

// A row for each setting: freedoms, CPU, memory, the largest error of each group.
ReportTable settings_table(const Study& study) {
  const auto of = [&study](auto value) {
    return [&study, value](std::size_t t) { return std::invoke(value, study.trials[t]); };
  };
  report::Columns<std::size_t> columns;
  columns.words("setting", of([](const StudyTrial& trial) { return trial.variant.name; }))
      .number("freedoms", "", of(freedoms_text))
      .number("CPU", "s", of([](const StudyTrial& trial) { return trial.end.cpu; }), "{:.2f}")
      .number("memory", "MiB",
              of([](const StudyTrial& t) { return mebibytes(t.end.peak_memory); }));
  for (const AnswerGroupVerdict& group : study.groups) {
    const auto error = [&group](double AnswerGroupErrors::*kind) {
      return [&group, kind](std::size_t t) { return percent_number(group.errors[t].*kind); };
    };
    columns.number(fmt::format("{} error", display_name(group.group)), "%",
                   error(&AnswerGroupErrors::plain));
    if (group.group == AnswerGroup::K) {
      columns.number("corrected", "%", error(&AnswerGroupErrors::best))
          .number("bar", "%", error(&AnswerGroupErrors::bar));
    }
  }
  columns.words("", of(&StudyTrial::trouble));
  std::vector<std::size_t> rows(study.trials.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return columns.table("Settings", rows);
}

// A row for each series of each group: the power that errors fall by, where they stop, and why.
ReportTable series_table(const Study& study) {
  using Row = std::pair<AnswerGroup, const SeriesVerdict*>;
  std::vector<Row> rows;
  for (const AnswerGroupVerdict& group : study.groups) {
    for (const SeriesVerdict& series : group.series) {
      rows.emplace_back(group.group, &series);
    }
  }
  return report::Columns<Row>()
      .words("answers", [](const Row& row) { return display_name(row.first); })
      .words("series",
             [](const Row& row) { return series_name(row.second->family, row.second->corrected); })
      .number("power", "",
              [](const Row& row) {
                return row.second->slope ? fmt::format("{:.2f}", row.second->slope->power) : "-";
              })
      .number(
          "theory", "", [](const Row& row) { return row.second->theory; }, "{:g}")
      .number("plateau", "",
              [](const Row& row) {
                return row.second->plateau ? percent(row.second->plateau->level) : "";
              })
      .words("why", [](const Row& row) { return row.second->reason; })
      .table("Slopes and plateaus", rows);
}

// References of the deck that are not used, and what they are off by; the largest of each source.
ReportTable distrusted_table(const Study& study) {
  const std::vector<AnswerReference>& references = study.references;
  std::map<std::string, std::size_t> worst; // answers by source
  for (std::size_t a = 0; a < references.size(); ++a) {
    const auto [found, fresh] = worst.emplace(study.answers[a].check.source, a);
    if (!fresh && references[a].deck_is_off > references[found->second].deck_is_off) {
      found->second = a;
    }
  }
  std::vector<std::size_t> rows;
  for (const auto& [source, a] : worst) {
    if (references[a].deck_is_off > 0.0 && references[a].scale > 0.0) {
      rows.push_back(a);
    }
  }
  return report::Columns<std::size_t>()
      .words("check", [&](std::size_t a) { return study.answers[a].text; })
      .number("off by", "%",
              [&](std::size_t a) { return percent_number(references[a].deck_is_off); })
      .number("finest is sure to", "%",
              [&](std::size_t a) {
                return percent_number(references[a].uncertainty / references[a].scale);
              })
      .words("source", [&](std::size_t a) { return study.answers[a].check.source; })
      .table("References of the deck that finer meshes do not go to", rows);
}

std::string reference_words(const Study& study) {
  std::size_t own = 0;
  std::size_t all = 0;
  for (const AnswerReference& reference : study.references) {
    all += reference.scale > 0.0 ? 1 : 0;
    own += reference.scale > 0.0 && reference.of_deck ? 1 : 0;
  }
  const std::string finest = study.finest ? study.trials[*study.finest].variant.name : "none";
  const std::string answers = fmt::format("{} answer{}", all, all == 1 ? "" : "s");
  const std::string against = fmt::format(
      "the finest setting ({}), with its estimated error taken out where there is a bar", finest);
  return own == all ? answers + " against references of the deck"
         : own == 0 ? answers + " against " + against
                    : fmt::format("{}, {} against references of the deck, the others against {}",
                                  answers, own, against);
}

} // namespace

std::string study_text(const Study& study) {
  std::string out = report::table_to_text(settings_table(study)) + "\n";
  for (const ReportTable& table : {series_table(study), distrusted_table(study)}) {
    out += table.rows.empty() ? "" : report::table_to_text(table) + "\n";
  }
  out += reference_words(study) + "\n";
  for (const std::string& note : study.notes) {
    out += note + "\n";
  }
  out += "\n";
  for (const AnswerGroupVerdict& group : study.groups) {
    out += fmt::format("{}\n", fmt::join(group.sentences, "\n"));
  }
  return out;
}

std::string study_csv(const Study& study) {
  return trials_csv(
      "setting,family,fineness,freedoms,cpu,wall,memory,exit_code,answer,group,value,"
      "bar,raw,reference,of_deck,uncertainty,error,raw_error",
      study.trials, study.answers,
      [](const StudyTrial& trial) {
        return base::CsvRow{{"setting", trial.variant.name},
                            {"family", display_name(trial.variant.family)},
                            {"fineness", trial.variant.fineness}};
      },
      [&](const StudyTrial& trial, std::size_t a) {
        const AnswerReading& reading = trial.readings[a];
        const AnswerReference& reference = study.references[a];
        const double scale = reference.scale > 0.0 ? reference.scale : NAN;
        return base::CsvRow{{"group", display_name(study.answers[a].group)},
                            {"raw", reading.raw},
                            {"reference", reference.value},
                            {"of_deck", reference.of_deck},
                            {"uncertainty", reference.uncertainty},
                            {"error", (reading.value - reference.value) / scale},
                            {"raw_error", (reading.of_mesh() - reference.value) / scale}};
      });
}

std::string study_page(const base::SourceTexts& sources, const model::Model& model,
                       const Study& study) {
  report::HtmlPage page;
  const std::string title = begin_titled_page(
      page, model, "study",
      fmt::format("Work against precision of {}: {}", report::relative_deck_file_name(sources, 0),
                  reference_words(study)));
  page.add_heading("The cheapest settings");
  for (const AnswerGroupVerdict& group : study.groups) {
    for (const std::string& words : group.sentences) {
      page.add_paragraph(words, "");
    }
  }
  page.add_heading("Error and cost");
  for (const AnswerGroupVerdict& group : study.groups) {
    page.add_figure(
        {{draw_svg(group_plot(study, group, true)), draw_svg(group_plot(study, group, false))},
         "",
         fmt::format("The largest error of {} of all answers of the group, against the "
                     "CPU time of the whole run and against its freedoms.",
                     display_name(group.group))});
  }
  page.add_table(series_table(study));
  page.add_table(distrusted_table(study));
  page.add_heading("Settings");
  page.add_table(report::without_title(settings_table(study)));
  for (const std::string& note : study.notes) {
    page.add_paragraph(note);
  }
  return page.finish_page(title);
}

} // namespace spricka::program
