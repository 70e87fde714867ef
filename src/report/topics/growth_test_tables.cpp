// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/growth_test_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/file.hpp"
#include "report/drawing/plot.hpp"
#include "report/topics/result_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace spricka::report {

namespace {

constexpr double k_infinite = std::numeric_limits<double>::infinity();

std::string cell(double value) {
  return std::isnan(value) ? std::string() : fmt::format("{}", value);
}

std::string number(double value) {
  return std::isnan(value) ? std::string() : fmt::format("{:.4g}", value);
}

std::string count(double cycles) {
  return std::isnan(cycles) ? std::string() : fmt::format("{:.0f}", cycles);
}

/// How a length and a K stand in the figure: as they are, or over R and sigma sqrt(pi a).
struct TestFigureScale {
  std::optional<NominalStressState> state;
  [[nodiscard]] DrawingPoint operator()(double a, double K) const {
    return state ? DrawingPoint{a / state->radius, K / state->k0(a)} : DrawingPoint{a, K};
  }
};

// Computed K at the lengths that were solved.
PlotSeries computed_series(const results::GrowthTestResult& test, const TestFigureScale& scale) {
  PlotSeries series;
  series.name = "computed";
  series.marker = MarkerShape::square;
  for (const auto& [a, K] : test.computed) {
    series.points.push_back(scale(a, K));
  }
  return series;
}

void add_measured(Plot& plot, const results::GrowthTestResult& test, const TestFigureScale& scale) {
  PlotSeries points;
  points.name = "from the test, 95 %";
  points.joined = false;
  points.marker = MarkerShape::circle;
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

// Values the deck compares K of this tip with at the step, one mark for each source.
void add_references(Plot& plot, const model::Model& model, const results::RunResult& run,
                    const results::GrowthTestResult& test, const TestFigureScale& scale) {
  constexpr std::array<MarkerShape, 3> shapes{MarkerShape::diamond, MarkerShape::plus,
                                              MarkerShape::cross};
  const std::size_t first = plot.series.size();
  for (const KReference& reference : k_references(model, run)) {
    if (reference.tip != test.tip || reference.step != leading_step(model)) {
      continue;
    }
    const std::string name = reference.source.empty() ? "reference" : reference.source;
    auto same =
        std::find_if(plot.series.begin() + static_cast<std::ptrdiff_t>(first), plot.series.end(),
                     [&](const PlotSeries& s) { return s.name == name; });
    if (same == plot.series.end()) {
      PlotSeries series;
      series.name = name;
      series.joined = false;
      series.marker = shapes[(plot.series.size() - first) % shapes.size()];
      plot.series.push_back(series);
      same = plot.series.end() - 1;
    }
    same->points.push_back(scale(reference.a, reference.wanted));
  }
}

std::string readings_plot(const model::Model& model, const results::GrowthTestResult& test) {
  Plot plot{"Readings of the test", "N", fmt::format("a  [{}]", model.units.length_name), {}};
  PlotSeries readings;
  readings.joined = false;
  readings.marker = MarkerShape::circle;
  readings.colour = palette_colour(1);
  for (const auto& [cycles, a] : test.readings) {
    readings.points.push_back({cycles, a});
  }
  plot.series.push_back(readings);
  plot.legend_below = true;
  return draw_svg(plot);
}

Figure figure_of(const model::Model& model, const results::RunResult& run,
                 const results::GrowthTestResult& test) {
  const TestFigureScale scale{find_nominal_state(model)};
  const std::string unit = typeset_unit(model.units.stress_intensity_name());
  Plot plot{"Stress intensity factor from the test over crack length",
            scale.state ? "a / R" : fmt::format("a  [{}]", model.units.length_name),
            scale.state ? "K₁ / (σ √(πa))" : fmt::format("K₁  [{}]", unit),
            {}};
  plot.legend_below = true;
  plot.series.push_back(computed_series(test, scale));
  add_measured(plot, test, scale);
  add_references(plot, model, run, test, scale);
  return {{readings_plot(model, test), draw_svg(plot)},
          "",
          fmt::format("Test {}: the readings, the K₁ of {} that follows from its measured growth "
                      "({}, {}), and K₁ computed at step {}.{}",
                      test.name, test.tip, test.method, test.reference, leading_step(model),
                      scale.state ? fmt::format(" R = {:.6g} {}, σ = {:.4g} {} (the deck's "
                                                "parameters R and SIGMA).",
                                                scale.state->radius, model.units.length_name,
                                                scale.state->sigma, model.units.stress_name())
                                  : std::string())};
}

} // namespace

void write_test_csv(const std::filesystem::path& file, const model::Model& model,
                    const results::RunResult& run) {
  if (run.tests.empty()) {
    return;
  }
  std::string text = fmt::format(
      "# units: a [{0}], rates [{0}/cycle], K [{1}], R ratio covered [1]; low and high: 95 %\n"
      "test,tip,N,a,rate,rate_low,rate_high,R,K_exp,K_low,K_high,K_computed,ratio,covered\n",
      model.units.length_name, model.units.stress_intensity_name());
  auto out = std::back_inserter(text);
  for (const results::GrowthTestResult& test : run.tests) {
    for (const results::GrowthTestPoint& p : test.points) {
      fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", test.name, test.tip,
                     p.cycles, p.a, p.rate, cell(p.rate_low), cell(p.rate_high), cell(p.R),
                     cell(p.K), cell(p.low), cell(p.high), cell(p.computed), cell(p.ratio()),
                     p.covered ? 1 : 0);
    }
  }
  write_file(file, text);
}

ReportTable growth_test_table(const model::Model& model, const results::RunResult& run) {
  ReportTable table{"Crack growth tests",
                    {{"test", "", true},
                     {"tip", "", true},
                     {"method", "", true},
                     {"reference", "", true},
                     {"readings", "", false},
                     {"scatter", model.units.length_name, false},
                     {"compared", "", false},
                     {"K_exp/K", "", false},
                     {"rms", "%", false},
                     {"K inside band", "%", false},
                     {"cycles", "", false},
                     {"computed", "", false},
                     {"+-", "", false}},
                    {}};
  for (const results::GrowthTestResult& test : run.tests) {
    const results::GrowthTestComparison c = results::compare_test_k(test, 0.0, k_infinite);
    const bool any = c.points > 0;
    table.rows.push_back({test.name, test.tip, test.method, test.reference,
                          fmt::format("{}", test.readings.size()), number(test.scatter),
                          fmt::format("{}", c.points), any ? fmt::format("{:.4f}", c.ratio) : "",
                          any ? fmt::format("{:.2f}", 100.0 * c.rms) : "",
                          any ? fmt::format("{:.0f}", 100.0 * c.inside) : "", count(test.cycles),
                          count(test.computed_cycles), count(test.cycles_error)});
  }
  return table;
}

ReportTable test_points_table(const model::Model& model, const results::GrowthTestResult& test) {
  const std::string k_unit = model.units.stress_intensity_name();
  ReportTable table{fmt::format("Test {}: K of {}", test.name, test.tip),
                    {{"N", "", false},
                     {"a", model.units.length_name, false},
                     {"da/dN", model.units.length_name, false},
                     {"R", "", false},
                     {"K_exp", k_unit, false},
                     {"from", k_unit, false},
                     {"to", k_unit, false},
                     {"computed", k_unit, false},
                     {"K_exp/K", "", false}},
                    {}};
  for (const results::GrowthTestPoint& p : test.points) {
    table.rows.push_back({fmt::format("{:.6g}", p.cycles), number(p.a), number(p.rate),
                          std::isnan(p.R) ? "" : fmt::format("{:.3f}", p.R), number(p.K),
                          number(p.low), number(p.high), number(p.computed),
                          std::isnan(p.ratio()) ? "" : fmt::format("{:.3f}", p.ratio())});
  }
  return table;
}

std::vector<Figure> growth_test_figures(const model::Model& model, const results::RunResult& run) {
  std::vector<Figure> figures;
  for (const results::GrowthTestResult& test : run.tests) {
    figures.push_back(figure_of(model, run, test));
  }
  return figures;
}

} // namespace spricka::report
