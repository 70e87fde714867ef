// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/study_report.hpp"

#include "model/model.hpp"
#include "program/study/cheapest.hpp"
#include "program/study/study_charts.hpp"
#include "program/study/study_tables.hpp"
#include "report/deck_name.hpp"
#include "report/page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    out += c == '"' ? "\"\"" : std::string(1, c);
  }
  return out + "\"";
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
  const report::ReportTable series = series_table(study);
  if (!series.rows.empty()) {
    out += report::to_text(series) + "\n";
  }
  const report::ReportTable distrusted = distrusted_table(study);
  if (!distrusted.rows.empty()) {
    out += report::to_text(distrusted) + "\n";
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
  std::string out = "setting,family,fineness,freedoms,cpu,wall,memory,exit_code,answer,group,value,"
                    "bar,best,reference,of_deck,uncertainty,error,best_error\n";
  for (const Trial& trial : study.trials) {
    const std::string head = fmt::format(
        "{},{},{},{},{},{},{},{}", quoted(trial.setting.name),
        quoted(display_name(trial.setting.family)), trial.setting.fineness, trial.unknowns,
        trial.end.cpu, trial.end.wall, trial.end.peak_memory, trial.end.exit_code);
    if (trial.readings.empty()) {
      out += head + ",,,,,,,,,,\n";
    }
    for (std::size_t a = 0; a < trial.readings.size(); ++a) {
      const AnswerReading& reading = trial.readings[a];
      const AnswerReference& reference = study.verdict.references[a];
      const bool counts = reference.scale > 0.0;
      const double error = counts ? (reading.value - reference.value) / reference.scale : NAN;
      const double best = counts ? (reading.best - reference.value) / reference.scale : NAN;
      out +=
          fmt::format("{},{},{},{},{},{},{},{:d},{},{},{}\n", head, quoted(study.answers[a].text),
                      quoted(display_name(study.answers[a].group)), cell(reading.value),
                      cell(reading.bar), cell(reading.best), cell(reference.value),
                      reference.of_deck, cell(reference.uncertainty), cell(error), cell(best));
    }
  }
  return out;
}

std::string study_page(const base::SourceTexts& sources, const model::Model& model,
                       const Study& study) {
  report::HtmlPage page;
  const std::string title = model.title.empty() ? "spricka study" : model.title;
  page.add_html(fmt::format("<h1>{}</h1>\n", report::escape_xml(title)));
  page.add_html(
      fmt::format("<p class=\"about\">Work against precision of {}: {}. Computed by spricka "
                  "{}.</p>\n",
                  report::escape_xml(report::deck_name(sources, 0)),
                  report::escape_xml(reference_words(study)), SPRICKA_VERSION));
  page.add_heading("The cheapest settings");
  for (const std::string& words : sentences(study)) {
    page.add_html(fmt::format("<p>{}</p>\n", report::escape_xml(words)));
  }
  page.add_heading("Error and cost");
  for (const GroupVerdict& group : study.verdict.groups) {
    for (const report::Figure& figure : study_figures(study, group)) {
      page.add_figure(figure);
    }
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
