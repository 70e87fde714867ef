// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/csv.hpp"
#include "model/forward.hpp"
#include "program/study/deck_answers.hpp"
#include "report/drawing/plot.hpp"
#include "report/page.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// What the pages and tables of studies and ladders have in common.
namespace spricka::program {

/// A part as per cent with two digits, "0.023 %"; "-" where it is not finite.
std::string percent(double part);
/// The same as a bare number, for columns of per cent.
std::string percent_number(double part);

/// Memory as tables have it [MiB], of bytes.
std::string mebibytes(std::size_t bytes);

/// A plot against CPU time or freedoms with both axes logarithmic.
report::Plot empty_logarithmic_plot(const std::string& label, const std::string& x_name,
                                    const std::string& y_name);

/// A dashed line across a plot at the height `level`.
report::PlotSeries horizontal_line_series(const std::string& name, double low, double high,
                                          double level);

/// Begins a page with the deck's title, or without one the name of the command, and what it is
/// about, a sentence without its point. The title.
std::string begin_titled_page(report::HtmlPage& page, const model::Model& model,
                              const char* command, const std::string& about);

/// A table of trials with a row for each answer, or for a trial without any: `columns` names them.
/// Beside what `head` gives of a trial and `fields` of a trial's answer there are
/// freedoms,cpu,wall,memory,exit_code,answer,value,bar.
template <class Trials, class Head, class Fields>
std::string trials_csv(std::string_view columns, const Trials& trials,
                       const std::vector<AnswerRequest>& answers, const Head& head,
                       const Fields& fields) {
  base::CsvTable csv(columns);
  for (const auto& trial : trials) {
    base::CsvRow first = head(trial);
    first.insert(first.end(), {{"freedoms", trial.unknowns},
                               {"cpu", trial.end.cpu},
                               {"wall", trial.end.wall},
                               {"memory", trial.end.peak_memory},
                               {"exit_code", trial.end.exit_code}});
    if (trial.readings.empty()) {
      csv.add_row(first);
    }
    for (std::size_t a = 0; a < trial.readings.size(); ++a) {
      base::CsvRow row = fields(trial, a);
      row.insert(row.end(), {{"answer", answers[a].text},
                             {"value", trial.readings[a].value},
                             {"bar", trial.readings[a].bar}});
      csv.add_row(first, row);
    }
  }
  return csv.text();
}

} // namespace spricka::program
