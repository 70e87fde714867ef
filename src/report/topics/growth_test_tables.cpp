// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/growth_test_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/file.hpp"
#include "report/drawing/plot.hpp"
#include "report/topics/result_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace spricka::report {

namespace {

constexpr double k_infinite = std::numeric_limits<double>::infinity();

/// Empty where a value is not a number.
std::optional<double> present(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

/// A number of a point of a test, or what follows from it.
template <class Value> auto present_value(Value value) {
  return [=](const auto& row) { return present(std::invoke(value, row)); };
}

// Computed K at the lengths that were solved.
PlotSeries computed_series(const results::GrowthTestResult& test, const KFigureScale& scale) {
  PlotSeries series;
  series.name = "computed";
  series.marker = MarkerShape::square;
  for (const auto& [a, K] : test.computed) {
    series.points.push_back(scale(a, K));
  }
  return series;
}

void add_measured(Plot& plot, const results::GrowthTestResult& test, const KFigureScale& scale) {
  PlotSeries points = marker_series("from the test, 95 %", MarkerShape::circle);
  points.colour = palette_colour(1);
  for (const results::GrowthTestPoint& p : test.points) {
    if (std::isnan(p.K)) {
      continue;
    }
    points.points.push_back(scale(p.a, p.K));
    PlotSeries band; // a line down and up
    band.colour = points.colour;
    band.points = {scale(p.a, std::isnan(p.low) ? p.K : p.low),
                   scale(p.a, std::isnan(p.high) ? p.K : p.high)};
    plot.series.push_back(band);
  }
  plot.series.push_back(points);
}

std::string readings_plot(const model::Model& model, const results::GrowthTestResult& test) {
  Plot plot{"Readings of the test", "N", axis_title("a", model.units.output_length()), {}};
  PlotSeries& readings = plot.series.emplace_back(marker_series("", MarkerShape::circle));
  readings.colour = palette_colour(1);
  for (const auto& [cycles, a] : test.readings) {
    readings.points.push_back({cycles, a});
  }
  plot.legend_below = true;
  return draw_svg(plot);
}

Figure figure_of(const model::Model& model, const results::RunResult& run,
                 const results::GrowthTestResult& test) {
  const KFigureScale scale{find_figure_reference_values(model)};
  Plot plot = scale.plot(model, "Stress intensity factor from the test over crack length");
  plot.legend_below = true;
  plot.series.push_back(computed_series(test, scale));
  add_measured(plot, test, scale);
  std::vector<KCheckReference> references = k_references(model, run);
  std::erase_if(references, [&](const KCheckReference& reference) {
    return reference.tip != test.tip || reference.step != leading_step_name(model);
  });
  constexpr std::array shapes{MarkerShape::diamond, MarkerShape::plus, MarkerShape::cross};
  add_reference_marks(plot, references, "", shapes, scale);
  return {{readings_plot(model, test), draw_svg(plot)},
          "",
          fmt::format("Test {}: the readings, the K₁ of {} that follows from its measured growth "
                      "({}, {}), and K₁ computed at step {}.{}",
                      test.name, test.tip, test.method, test.reference, leading_step_name(model),
                      scale.state
                          ? fmt::format(" R = {}, σ = {} (the deck's parameters R and SIGMA).",
                                        model.units.output_length().text(scale.state->radius, 6),
                                        model.units.output_stress().text(scale.state->sigma, 4))
                          : std::string())};
}

} // namespace

void write_growth_test_csv(const std::filesystem::path& file, const model::Model& model,
                           const results::RunResult& run) {
  if (run.tests.empty()) {
    return;
  }
  using Point = results::GrowthTestPoint;
  using Row = std::pair<const results::GrowthTestResult*, const Point*>;
  std::vector<Row> rows;
  for (const results::GrowthTestResult& test : run.tests) {
    for (const Point& point : test.points) {
      rows.emplace_back(&test, &point);
    }
  }
  const base::OutputUnit length = model.units.output_length();
  const base::OutputUnit unit = model.units.output_stress_intensity();
  Columns<Row> columns;
  columns.exact("test", [](const Row& row) { return row.first->name; })
      .exact("tip", [](const Row& row) { return row.first->tip; })
      .exact("N", [](const Row& row) { return row.second->cycles; })
      .exact("a", length, [](const Row& row) { return row.second->a; })
      .exact("rate", length, [](const Row& row) { return row.second->rate; });
  for (const auto& [name, member, of_values] : {std::tuple("rate_low", &Point::rate_low, length),
                                                {"rate_high", &Point::rate_high, length},
                                                {"R", &Point::R, base::OutputUnit()},
                                                {"K_exp", &Point::K, unit},
                                                {"K_low", &Point::low, unit},
                                                {"K_high", &Point::high, unit},
                                                {"K_computed", &Point::computed, unit}}) {
    columns.exact(name, of_values,
                  [member = member](const Row& row) { return present(row.second->*member); });
  }
  columns.exact("ratio", [](const Row& row) { return present(row.second->ratio()); })
      .exact("covered", [](const Row& row) { return row.second->covered ? 1 : 0; });
  const std::string units =
      fmt::format("a [{0}], rates [{0}/cycle], K [{1}], R ratio covered [1]; low and high: 95 %",
                  length.name, unit.name);
  write_file(file, columns.csv(units, rows));
}

ReportTable growth_test_summary_table(const model::Model& model, const results::RunResult& run) {
  using Test = results::GrowthTestResult;
  const auto compared = [](const Test& test) {
    return results::compare_test_k(test, 0.0, k_infinite);
  };
  Columns<Test> columns;
  columns.words("test", &Test::name)
      .words("tip", &Test::tip)
      .words("method", &Test::method)
      .words("reference", &Test::reference)
      .number("readings", "", [](const Test& test) { return test.readings.size(); })
      .number("scatter", model.units.output_length(), present_value(&Test::scatter), "{:.4g}")
      .number("compared", "", [=](const Test& test) { return compared(test).points; })
      .fill_only_if([=](const Test& test) { return compared(test).points > 0; })
      .number(
          "K_exp/K", "", [=](const Test& test) { return compared(test).ratio; }, "{:.4f}")
      .number(
          "rms", "%", [=](const Test& test) { return 100.0 * compared(test).rms; }, "{:.2f}")
      .number(
          "K inside band", "%", [=](const Test& test) { return 100.0 * compared(test).inside; },
          "{:.0f}")
      .fill_only_if({})
      .number("cycles", "", present_value(&Test::cycles), "{:.0f}")
      .number("computed", "", present_value(&Test::computed_cycles), "{:.0f}")
      .number("+-", "", present_value(&Test::cycles_error), "{:.0f}");
  return columns.table("Crack growth tests", run.tests);
}

ReportTable test_points_table(const model::Model& model, const results::GrowthTestResult& test) {
  using Point = results::GrowthTestPoint;
  const base::OutputUnit k_unit = model.units.output_stress_intensity();
  const base::OutputUnit a_unit = model.units.output_length();
  constexpr const char* four = "{:.4g}";
  Columns<Point> columns;
  columns.number("N", "", &Point::cycles)
      .number("a", a_unit, present_value(&Point::a), four)
      .number("da/dN", a_unit, present_value(&Point::rate), four)
      .number("R", "", present_value(&Point::R), "{:.3f}")
      .number("K_exp", k_unit, present_value(&Point::K), four)
      .number("from", k_unit, present_value(&Point::low), four)
      .number("to", k_unit, present_value(&Point::high), four)
      .number("computed", k_unit, present_value(&Point::computed), four)
      .number("K_exp/K", "", present_value(&Point::ratio), "{:.3f}");
  return columns.table(fmt::format("Test {}: K of {}", test.name, test.tip), test.points);
}

std::vector<Figure> growth_test_figures(const model::Model& model, const results::RunResult& run) {
  std::vector<Figure> figures;
  for (const results::GrowthTestResult& test : run.tests) {
    figures.push_back(figure_of(model, run, test));
  }
  return figures;
}

} // namespace spricka::report
