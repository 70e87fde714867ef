// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/study_report.hpp"

#include "model/model.hpp"
#include "program/study/variant_report.hpp"
#include "report/deck_name.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

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

std::string series_name(SettingFamily family, bool corrected) {
  return fmt::format("{}{}", display_name(family), corrected ? ", corrected" : "");
}

// The errors of a family; none where the deck as it is would stand alone.
std::vector<report::DrawingPoint> curve_points(const Study& study, const GroupVerdict& group,
                                               const CurveKind& curve, bool against_cpu) {
  std::vector<report::DrawingPoint> points;
  bool own = false;
  for (const std::size_t row : series_rows(study.trials, curve.family)) {
    const Trial& trial = study.trials[row];
    const double error = curve.corrected ? group.errors[row].best : group.errors[row].plain;
    const double x = against_cpu ? trial.end.cpu : static_cast<double>(trial.unknowns);
    own = own || trial.setting.family == curve.family;
    if (std::isfinite(error) && x > 0.0) {
      points.push_back({x, 100.0 * std::max(error, least_error)});
    }
  }
  return own ? points : std::vector<report::DrawingPoint>();
}

report::Plot group_plot(const Study& study, const GroupVerdict& group, bool against_cpu) {
  report::Plot plot = cost_plot(fmt::format("error of {} against {}", display_name(group.group),
                                            against_cpu ? "CPU time" : "freedoms"),
                                against_cpu ? "CPU  [s]" : "freedoms",
                                fmt::format("largest error of {}  [%]", display_name(group.group)));
  plot.legend_below = true;
  double low = std::numeric_limits<double>::max();
  double high = 0.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const CurveKind& curve = curves.at(i);
    report::PlotSeries series;
    series.name = series_name(curve.family, curve.corrected);
    series.colour = report::palette_colour(i);
    series.dash = report::dash_pattern(i / 7 + (curve.corrected ? 1 : 0));
    series.marker = report::closed_marker(i);
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
    plot.series.push_back(level_line("the reference is no better", low, high, 100.0 * group.floor));
  }
  return plot;
}

// A row for each setting: freedoms, CPU, memory, the largest error of each group.
ReportTable settings_table(const Study& study) {
  std::string columns = "<setting|freedoms|CPU [s]|memory [MiB]";
  for (const GroupVerdict& group : study.verdict.groups) {
    columns += fmt::format("|{} error [%]{}", display_name(group.group),
                           group.group == AnswerGroup::K ? "|corrected [%]|bar [%]" : "");
  }
  ReportTable table = report::make_table("Settings", columns + "|<");
  for (std::size_t t = 0; t < study.trials.size(); ++t) {
    const Trial& trial = study.trials[t];
    std::vector<std::string> row{
        trial.setting.name, trial.unknowns > 0 ? fmt::format("{}", trial.unknowns) : "-",
        fmt::format("{:.2f}", trial.end.cpu), mebibytes(trial.end.peak_memory)};
    for (const GroupVerdict& group : study.verdict.groups) {
      row.push_back(in_percent(group.errors[t].plain));
      if (group.group == AnswerGroup::K) {
        row.push_back(in_percent(group.errors[t].best));
        row.push_back(in_percent(group.errors[t].bar));
      }
    }
    row.push_back(trial.trouble);
    table.rows.push_back(std::move(row));
  }
  return table;
}

// A row for each series of each group: the power that errors fall by, where they stop, and why.
ReportTable series_table(const Study& study) {
  ReportTable table =
      report::make_table("Slopes and plateaus", "<answers|<series|power|theory|plateau|<why");
  for (const GroupVerdict& group : study.verdict.groups) {
    for (const SeriesVerdict& series : group.series) {
      table.rows.push_back({display_name(group.group), series_name(series.family, series.corrected),
                            series.slope ? fmt::format("{:.2f}", series.slope->power) : "-",
                            series.theory ? fmt::format("{:g}", *series.theory) : "",
                            series.plateau ? percent(series.plateau->level) : "", series.reason});
    }
  }
  return table;
}

// References of the deck that are not used, and what they are off by; the largest of each source.
ReportTable distrusted_table(const Study& study) {
  ReportTable table = report::make_table("References of the deck that finer meshes do not go to",
                                         "<check|off by [%]|finest is sure to [%]|<source");
  std::map<std::string, std::size_t> worst; // by source
  for (std::size_t a = 0; a < study.verdict.references.size(); ++a) {
    const double off = study.verdict.references[a].deck_is_off;
    const auto [found, fresh] = worst.emplace(study.answers[a].check.source, a);
    if (!fresh && off > study.verdict.references[found->second].deck_is_off) {
      found->second = a;
    }
  }
  for (const auto& [source, a] : worst) {
    const AnswerReference& reference = study.verdict.references[a];
    if (reference.deck_is_off > 0.0 && reference.scale > 0.0) {
      table.rows.push_back({study.answers[a].text, in_percent(reference.deck_is_off),
                            in_percent(reference.uncertainty / reference.scale), source});
    }
  }
  return table;
}

std::vector<std::string> sentences(const Study& study) {
  std::vector<std::string> all;
  for (const GroupVerdict& group : study.verdict.groups) {
    for (const CheapestSetting& cheapest : group.cheapest) {
      all.push_back(cheapest.words);
    }
    if (!group.peer.empty()) {
      all.push_back(group.peer);
    }
  }
  return all;
}

std::string reference_words(const Study& study) {
  std::size_t own = 0;
  std::size_t all = 0;
  for (const AnswerReference& reference : study.verdict.references) {
    all += reference.scale > 0.0 ? 1 : 0;
    own += reference.scale > 0.0 && reference.of_deck ? 1 : 0;
  }
  const std::string finest =
      study.verdict.finest ? study.trials[*study.verdict.finest].setting.name : "none";
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
  std::string out = report::to_text(settings_table(study)) + "\n";
  for (const ReportTable& table : {series_table(study), distrusted_table(study)}) {
    out += table.rows.empty() ? "" : report::to_text(table) + "\n";
  }
  out += reference_words(study) + "\n";
  for (const std::string& note : study.notes) {
    out += note + "\n";
  }
  out += "\n";
  for (const std::string& words : sentences(study)) {
    out += words + "\n";
  }
  return out;
}

std::string study_csv(const Study& study) {
  base::CsvTable csv(
      "setting,family,fineness,freedoms,cpu,wall,memory,exit_code,answer,group,value,"
      "bar,best,reference,of_deck,uncertainty,error,best_error");
  for (const Trial& trial : study.trials) {
    base::CsvRow head = cost_fields(trial);
    head.insert(head.end(), {{"setting", trial.setting.name},
                             {"family", display_name(trial.setting.family)},
                             {"fineness", trial.setting.fineness}});
    if (trial.readings.empty()) {
      csv.add_row(head);
    }
    for (std::size_t a = 0; a < trial.readings.size(); ++a) {
      const AnswerReading& reading = trial.readings[a];
      const AnswerReference& reference = study.verdict.references[a];
      const double scale = reference.scale > 0.0 ? reference.scale : NAN;
      csv.add_row(head, {{"answer", study.answers[a].text},
                         {"group", display_name(study.answers[a].group)},
                         {"value", reading.value},
                         {"bar", reading.bar},
                         {"best", reading.best},
                         {"reference", reference.value},
                         {"of_deck", reference.of_deck},
                         {"uncertainty", reference.uncertainty},
                         {"error", (reading.value - reference.value) / scale},
                         {"best_error", (reading.best - reference.value) / scale}});
    }
  }
  return csv.text();
}

std::string study_page(const base::SourceTexts& sources, const model::Model& model,
                       const Study& study) {
  report::HtmlPage page;
  const std::string title =
      begin_page(page, model, "study",
                 fmt::format("Work against precision of {}: {}", report::deck_name(sources, 0),
                             reference_words(study)));
  page.add_heading("The cheapest settings");
  for (const std::string& words : sentences(study)) {
    page.add_paragraph(words, "");
  }
  page.add_heading("Error and cost");
  for (const GroupVerdict& group : study.verdict.groups) {
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
  page.add_table(report::untitled(settings_table(study)));
  for (const std::string& note : study.notes) {
    page.add_paragraph(note);
  }
  return page.finish_page(title);
}

} // namespace spricka::program
