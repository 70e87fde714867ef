// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "program/study/ladder.hpp"
#include "program/study/variant_report.hpp"
#include "report/deck_name.hpp"
#include "report/drawing/columns.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <boost/range/adaptor/filtered.hpp>
#include <fmt/format.h>

namespace spricka::program {

namespace {

bool has_answers(const ModelVariantResult& variant) {
  return !variant.readings.empty();
}

base::OutputUnit unit_of(const model::Model& model, AnswerGroup group) {
  switch (group) {
  case AnswerGroup::K:
    return model.units.output_stress_intensity();
  case AnswerGroup::T:
  case AnswerGroup::pressure:
  case AnswerGroup::stress:
    return model.units.output_stress();
  default:
    return {};
  }
}

report::ReportTable variants_table(const model::Model& model,
                                   const SimplerModelComparison& ladder) {
  const base::OutputUnit unit = unit_of(model, ladder.answers.front().group);
  const auto value_of = [&](std::size_t answer) {
    return [answer, unit](const ModelVariantResult& variant) {
      const double value = unit.from_deck(variant.readings[answer].value);
      return std::isfinite(value) ? fmt::format("{:.5g}", value) : "-";
    };
  };
  report::Columns<ModelVariantResult> columns;
  columns.words("rung", [](const ModelVariantResult& variant) { return variant.variant.name; })
      .number(ladder.answers.front().text, unit.name, value_of(0));
  if (ladder.answers.size() > 1) {
    columns.number(ladder.answers.back().text, unit.name, value_of(ladder.answers.size() - 1));
  }
  columns
      .number("largest difference", "%",
              [](const ModelVariantResult& variant) {
                return variant.verdict == ModelVariantVerdict::richest
                           ? "-"
                           : fmt::format("{:+.2g}", 100.0 * variant.difference);
              })
      .number("bar", "%",
              [](const ModelVariantResult& variant) {
                return variant.bar > 0.0 ? percent_number(variant.bar) : "-";
              })
      .number(
          "CPU", "s", [](const ModelVariantResult& variant) { return variant.end.cpu; }, "{:.2f}")
      .number("memory", "MiB",
              [](const ModelVariantResult& variant) { return mebibytes(variant.end.peak_memory); })
      .number("freedoms", "", &ModelVariantResult::unknowns)
      .words(fmt::format("{:g} %", 100.0 * ladder.tolerance),
             [](const ModelVariantResult& variant) { return display_name(variant.verdict); });
  return columns.table("Rungs", ladder.variants | boost::adaptors::filtered(has_answers));
}

report::ReportTable left_out_table(const SimplerModelComparison& ladder) {
  return report::Columns<ModelVariantResult>()
      .words("rung", [](const ModelVariantResult& variant) { return variant.variant.name; })
      .words("why", &ModelVariantResult::trouble)
      .table("Left out", ladder.variants | boost::adaptors::filtered(std::not_fn(has_answers)));
}

std::string ladder_sentence(const SimplerModelComparison& ladder) {
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

report::Plot ladder_plot(const SimplerModelComparison& ladder) {
  report::Plot plot = empty_logarithmic_plot(
      "difference of each rung from the richest against CPU time", "CPU  [s]",
      fmt::format("largest difference of {}  [%]", display_name(ladder.answers.front().group)));
  double low = 1e300;
  double high = 0.0;
  for (const ModelVariantResult& variant :
       ladder.variants | boost::adaptors::filtered(has_answers)) {
    low = std::min(low, variant.end.cpu);
    high = std::max(high, variant.end.cpu);
    if (variant.verdict == ModelVariantVerdict::richest || !(std::abs(variant.difference) > 0.0)) {
      continue;
    }
    report::PlotSeries series = report::styled_curve(variant.variant.name, plot.series.size(), 0);
    series.points = {{variant.end.cpu, 100.0 * std::abs(variant.difference)}};
    series.marker = report::palette_marker_shape(plot.series.size());
    series.joined = false;
    plot.series.push_back(std::move(series));
  }
  plot.series.push_back(horizontal_line_series("the tolerance", low, std::max(high, 1.01 * low),
                                               100.0 * ladder.tolerance));
  return plot;
}

} // namespace

std::string simpler_models_text(const model::Model& model, const SimplerModelComparison& ladder) {
  std::string out = report::table_to_text(variants_table(model, ladder)) + "\n";
  const report::ReportTable left = left_out_table(ladder);
  out += left.rows.empty() ? "" : report::table_to_text(left) + "\n";
  return out + ladder_sentence(ladder) + "\n";
}

std::string simpler_models_csv(const SimplerModelComparison& ladder) {
  return trials_csv(
      "rung,verdict,freedoms,cpu,wall,memory,exit_code,answer,value,bar,difference",
      ladder.variants, ladder.answers,
      [](const ModelVariantResult& variant) {
        return base::CsvRow{{"rung", variant.variant.name},
                            {"verdict", display_name(variant.verdict)}};
      },
      [&](const ModelVariantResult& variant, std::size_t a) {
        const double rich = ladder.variants[*ladder.richest].readings[a].value;
        return base::CsvRow{{"difference", (variant.readings[a].value - rich) / ladder.scales[a]}};
      });
}

std::string simpler_models_page(const base::SourceTexts& sources, const model::Model& model,
                                const SimplerModelComparison& ladder) {
  report::HtmlPage page;
  const std::string title = begin_titled_page(
      page, model, "ladder",
      fmt::format("Simpler models of {}", report::relative_deck_file_name(sources, 0)));
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
