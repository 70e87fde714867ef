// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/ladder_report.hpp"

#include "model/model.hpp"
#include "program/study/variant_report.hpp"
#include "report/deck_name.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::string unit_of(const model::Model& model, AnswerGroup group) {
  switch (group) {
  case AnswerGroup::K:
    return model.units.stress_intensity_name();
  case AnswerGroup::T:
  case AnswerGroup::pressure:
  case AnswerGroup::stress:
    return model.units.stress_name();
  default:
    return {};
  }
}

std::string number_or_none(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : "-";
}

report::ReportTable variants_table(const model::Model& model, const ModelHierarchy& ladder) {
  const std::string unit = unit_of(model, ladder.answers.front().group);
  report::ReportTable table = report::make_table("Rungs", "<rung");
  table.columns.push_back({ladder.answers.front().text, unit, false});
  if (ladder.answers.size() > 1) {
    table.columns.push_back({ladder.answers.back().text, unit, false});
  }
  const report::ReportTable costs = report::make_table(
      "", fmt::format("largest difference [%]|bar [%]|CPU [s]|memory [MiB]|freedoms|<{:g} %",
                      100.0 * ladder.tolerance));
  table.columns.insert(table.columns.end(), costs.columns.begin(), costs.columns.end());
  for (const ModelVariantResult& variant : ladder.variants) {
    if (variant.readings.empty()) {
      continue;
    }
    std::vector<std::string> row{variant.variant.name,
                                 number_or_none(variant.readings.front().value)};
    if (ladder.answers.size() > 1) {
      row.push_back(number_or_none(variant.readings.back().value));
    }
    row.insert(row.end(),
               {variant.verdict == ModelVariantVerdict::richest
                    ? "-"
                    : fmt::format("{:+.2g}", 100.0 * variant.difference),
                variant.bar > 0.0 ? in_percent(variant.bar) : "-",
                fmt::format("{:.2f}", variant.end.cpu), mebibytes(variant.end.peak_memory),
                fmt::format("{}", variant.unknowns), display_name(variant.verdict)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::ReportTable left_out_table(const ModelHierarchy& ladder) {
  report::ReportTable table = report::make_table("Left out", "<rung|<why");
  for (const ModelVariantResult& variant : ladder.variants) {
    if (variant.readings.empty()) {
      table.rows.push_back({variant.variant.name, variant.trouble});
    }
  }
  return table;
}

std::string ladder_sentence(const ModelHierarchy& ladder) {
  const char* const what = display_name(ladder.answers.front().group);
  if (!ladder.stopped.empty()) {
    return fmt::format("nothing is concluded: '{}' {} stopped before an answer was there",
                       fmt::join(ladder.stopped, "', '"),
                       ladder.stopped.size() == 1 ? "was" : "were");
  }
  if (!ladder.cheapest) {
    return "no rung has an answer";
  }
  const ModelVariantResult& cheapest = ladder.variants[*ladder.cheapest];
  if (cheapest.verdict == ModelVariantVerdict::richest) {
    return fmt::format("{} within {:g} %: no simpler and cheaper model will do; the deck as given "
                       "takes {:.2f} s",
                       what, 100.0 * ladder.tolerance, cheapest.end.cpu);
  }
  return fmt::format("{} within {:g} %: '{}' is enough ({}), {:+.2g} % at most from '{}', for "
                     "{:.2f} s in place of {:.2f} s",
                     what, 100.0 * ladder.tolerance, cheapest.variant.name, cheapest.variant.words,
                     100.0 * cheapest.difference, ladder.variants[*ladder.richest].variant.name,
                     cheapest.end.cpu, ladder.variants[*ladder.richest].end.cpu);
}

report::Plot ladder_plot(const ModelHierarchy& ladder) {
  report::Plot plot = cost_plot(
      "difference of each rung from the richest against CPU time", "CPU  [s]",
      fmt::format("largest difference of {}  [%]", display_name(ladder.answers.front().group)));
  double low = 1e300;
  double high = 0.0;
  for (const ModelVariantResult& variant : ladder.variants) {
    if (variant.readings.empty()) {
      continue;
    }
    low = std::min(low, variant.end.cpu);
    high = std::max(high, variant.end.cpu);
    if (variant.verdict == ModelVariantVerdict::richest || !(std::abs(variant.difference) > 0.0)) {
      continue;
    }
    report::PlotSeries series;
    series.name = variant.variant.name;
    series.points = {{variant.end.cpu, 100.0 * std::abs(variant.difference)}};
    series.colour = report::palette_colour(plot.series.size());
    series.marker = report::closed_marker(plot.series.size());
    series.joined = false;
    plot.series.push_back(std::move(series));
  }
  plot.series.push_back(
      level_line("the tolerance", low, std::max(high, 1.01 * low), 100.0 * ladder.tolerance));
  return plot;
}

} // namespace

std::string hierarchy_text(const model::Model& model, const ModelHierarchy& ladder) {
  std::string out = report::to_text(variants_table(model, ladder)) + "\n";
  const report::ReportTable left = left_out_table(ladder);
  out += left.rows.empty() ? "" : report::to_text(left) + "\n";
  return out + ladder_sentence(ladder) + "\n";
}

std::string hierarchy_csv(const ModelHierarchy& ladder) {
  base::CsvTable csv("rung,verdict,freedoms,cpu,wall,memory,exit_code,answer,value,bar,difference");
  for (const ModelVariantResult& variant : ladder.variants) {
    base::CsvRow head = cost_fields(variant);
    head.insert(head.end(),
                {{"rung", variant.variant.name}, {"verdict", display_name(variant.verdict)}});
    if (variant.readings.empty()) {
      csv.add_row(head);
    }
    for (std::size_t a = 0; a < variant.readings.size(); ++a) {
      const AnswerReading& reading = variant.readings[a];
      const double rich = ladder.variants[*ladder.richest].readings[a].value;
      csv.add_row(head, {{"answer", ladder.answers[a].text},
                         {"value", reading.value},
                         {"bar", reading.bar},
                         {"difference", (reading.value - rich) / ladder.scales[a]}});
    }
  }
  return csv.text();
}

std::string hierarchy_page(const base::SourceTexts& sources, const model::Model& model,
                           const ModelHierarchy& ladder) {
  report::HtmlPage page;
  const std::string title = begin_page(
      page, model, "ladder", fmt::format("Simpler models of {}", report::deck_name(sources, 0)));
  page.add_paragraph(ladder_sentence(ladder), "");
  page.add_figure({{draw_svg(ladder_plot(ladder))},
                   "",
                   "The largest difference of each rung from the richest, of all answers, against "
                   "the CPU time of its run."});
  page.add_table(variants_table(model, ladder));
  page.add_table(left_out_table(ladder));
  return page.finish_page(title);
}

} // namespace spricka::program
