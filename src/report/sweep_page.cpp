// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/deck_name.hpp"
#include "report/drawing/plot.hpp"
#include "report/page.hpp"
#include "report/sweep_files.hpp"
#include "report/topics/k_bars.hpp"
#include "report/topics/parameter_unit.hpp"
#include "report/topics/result_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace spricka::report {

namespace {

using results::SweepCell;
using results::SweepPoint;
using results::SweepResult;
using Units = std::vector<std::string>; // [parameter]

/// What stays the same along a curve: tip, step and the parameters that do not run along the axis.
struct SweepCurve {
  struct SweepCurvePoint {
    DrawingPoint place;
    double bar = no_bar;
  };
  std::string name;
  std::vector<SweepCurvePoint> points;
};

const SweepCell* find_cell(const SweepPoint& point, const std::string& column) {
  const auto found = std::ranges::find(point.cells, column, &SweepCell::column_name);
  return found == point.cells.end() ? nullptr : &*found;
}

/// The error bar of a point's K1.
double bar_of(const SweepPoint& point, SweepCell cell) {
  cell.quantity += "_bar";
  const SweepCell* const bar = find_cell(point, cell.column_name());
  return bar == nullptr ? no_bar : bar->value;
}

// The parameter that takes the most values runs along the axis.
std::size_t axis_of(const SweepResult& sweep) {
  std::size_t best = 0;
  std::size_t most = 0;
  for (std::size_t p = 0; p < sweep.parameters.size(); ++p) {
    std::vector<double> values;
    for (const SweepPoint& point : sweep.points) {
      values.push_back(point.values[p]);
    }
    std::sort(values.begin(), values.end());
    const auto count = static_cast<std::size_t>(
        std::distance(values.begin(), std::unique(values.begin(), values.end())));
    if (count > most) {
      most = count;
      best = p;
    }
  }
  return best;
}

// "mu = 0.15"; parameters of one card vary together and are not told apart from the axis.
std::string others(const model::Model& model, const SweepResult& sweep, const SweepPoint& point,
                   std::size_t axis) {
  std::string text;
  for (std::size_t p = 0; p < sweep.parameters.size(); ++p) {
    const bool with_axis = std::any_of(
        model.sweeps.begin(), model.sweeps.end(), [&](const model::ParameterSweep& card) {
          const auto& names = card.parameters;
          const auto has = [&](std::size_t i) {
            return std::find(names.begin(), names.end(), sweep.parameters[i]) != names.end();
          };
          return has(p) && has(axis);
        });
    if (!with_axis) {
      text += fmt::format(", {} = {}", sweep.parameters[p], point.values[p]);
    }
  }
  return text;
}

// A quantity of an increment over the swept parameter, each value divided by `unit`.
std::vector<SweepCurve> curves_of(const model::Model& model, const SweepResult& sweep,
                                  const std::string& quantity, int increment, double unit = 1.0) {
  const std::size_t axis = axis_of(sweep);
  std::vector<SweepCurve> curves;
  for (const SweepPoint& point : sweep.points) {
    for (const SweepCell& cell : point.cells) {
      if (cell.quantity != quantity || cell.increment != increment) {
        continue;
      }
      const std::string name =
          (cell.step.empty() ? quantity : fmt::format("{}: {}", cell.step, cell.name)) +
          others(model, sweep, point, axis);
      auto curve = std::ranges::find(curves, name, &SweepCurve::name);
      if (curve == curves.end()) {
        curve = curves.insert(curves.end(), {name, {}});
      }
      curve->points.push_back({{point.values[axis], cell.value / unit}, bar_of(point, cell)});
    }
  }
  for (SweepCurve& curve : curves) {
    std::ranges::stable_sort(curve.points, {},
                             [](const SweepCurve::SweepCurvePoint& at) { return at.place.x; });
  }
  return curves;
}

// Lives of all points, by the name of the curve.
std::vector<SweepCurve> lives_of(const model::Model& model, const SweepResult& sweep, double unit) {
  std::vector<SweepCurve> curves = curves_of(model, sweep, "N", 0, unit);
  std::ranges::sort(curves, {}, &SweepCurve::name);
  return curves;
}

// Curves within a thousandth of the largest value are one, under both names.
std::vector<SweepCurve> merged(std::vector<SweepCurve> curves) {
  double largest = 0.0;
  for (const SweepCurve& curve : curves) {
    for (const SweepCurve::SweepCurvePoint& p : curve.points) {
      largest = std::max(largest, std::abs(p.place.y));
    }
  }
  std::vector<SweepCurve> kept;
  for (SweepCurve& curve : curves) {
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const SweepCurve& k) {
      return k.points.size() == curve.points.size() &&
             std::equal(
                 k.points.begin(), k.points.end(), curve.points.begin(),
                 [&](const SweepCurve::SweepCurvePoint& a, const SweepCurve::SweepCurvePoint& b) {
                   return a.place.x == b.place.x &&
                          std::abs(a.place.y - b.place.y) <= 1e-3 * largest;
                 });
    });
    if (same != kept.end()) {
      same->name += "; " + curve.name;
    } else {
      kept.push_back(std::move(curve));
    }
  }
  return kept;
}

/// "delta  [mm]"
std::string axis_name(const std::string& parameter, const std::string& unit) {
  return unit.empty() ? parameter : fmt::format("{}  [{}]", parameter, typeset_unit(unit));
}

Plot plot_of(const SweepResult& sweep, const Units& units, const std::string& y_name,
             std::vector<SweepCurve> curves) {
  Plot plot;
  plot.label = y_name + " over the swept parameter";
  const std::size_t axis = axis_of(sweep);
  plot.x_name = axis_name(sweep.parameters[axis], units[axis]);
  plot.y_name = y_name;
  std::size_t i = 0;
  for (SweepCurve& curve : curves) {
    PlotSeries series;
    series.name = std::move(curve.name);
    for (const SweepCurve::SweepCurvePoint& at : curve.points) {
      series.points.push_back(at.place);
      series.bars.push_back(at.bar);
    }
    series.colour = palette_colour(i);
    series.dash = dash_pattern(i / 7);
    series.marker = closed_marker(i);
    plot.series.push_back(std::move(series));
    ++i;
  }
  return plot;
}

bool has_lives(const SweepResult& sweep) {
  return std::ranges::any_of(
      sweep.points, [](const SweepPoint& point) { return find_cell(point, "N") != nullptr; });
}

std::string life_unit(const model::Model& model) {
  return model.growth && model.growth->spectrum ? "passes" : "cycles";
}

/// Of an axis of lives: numbers on it stay short.
double life_scale(const SweepResult& sweep) {
  double largest = 0.0;
  for (const SweepPoint& point : sweep.points) {
    const SweepCell* const life = find_cell(point, "N");
    largest = std::max(largest, life == nullptr ? 0.0 : life->value);
  }
  return largest < 1e4 ? 1.0 : std::pow(1000.0, std::floor(std::log10(largest / 10.0) / 3.0));
}

// Increments with the first crack length met, in order; of lives the first one, as the others are
// those of other lengths at each point.
std::map<int, double> lengths_of(const SweepResult& sweep) {
  std::map<int, double> lengths;
  const int last = has_lives(sweep) ? 1 : std::numeric_limits<int>::max();
  for (const SweepPoint& point : sweep.points) {
    for (const SweepCell& cell : point.cells) {
      if (cell.quantity == "a" && cell.name.empty() && cell.increment <= last) {
        lengths.emplace(cell.increment, cell.value);
      }
    }
  }
  return lengths;
}

/// The cells that the table shows: the life; K1 of each tip and the largest pressure of each
/// contact at the end of that step.
std::vector<SweepCell> shown_cells(const SweepResult& sweep, const std::string& step) {
  std::vector<SweepCell> shown;
  const std::string nowhere;
  const int last = has_lives(sweep) ? 1 : std::numeric_limits<int>::max();
  for (const char* const quantity : {"N", "K1", "PMAX"}) {
    const std::string& at = std::string_view(quantity) == "N" ? nowhere : step;
    for (const SweepPoint& point : sweep.points) {
      for (const SweepCell& cell : point.cells) {
        const bool known =
            std::ranges::find(shown, cell.column_name(), &SweepCell::column_name) != shown.end();
        if (cell.quantity == quantity && cell.step == at && cell.increment <= last && !known) {
          shown.push_back(cell);
        }
      }
    }
  }
  return shown;
}

bool any_bar(const SweepResult& sweep, const SweepCell& cell) {
  return cell.quantity == "K1" && std::ranges::any_of(sweep.points, [&](const SweepPoint& point) {
           return std::isfinite(bar_of(point, cell));
         });
}

std::string checks_of(const SweepPoint& point) {
  return point.checks == 0 ? "" : fmt::format("{} of {} passed", point.passed, point.checks);
}

ReportTable points_table(const model::Model& model, const SweepResult& sweep, const Units& units) {
  const std::string step = leading_step(model);
  const std::vector<SweepCell> shown = shown_cells(sweep, step);
  ReportTable table{shown.empty() ? "" : fmt::format("At the end of step {}", step), {}, {}};
  for (std::size_t p = 0; p < sweep.parameters.size(); ++p) {
    table.columns.push_back({sweep.parameters[p], units[p], false});
  }
  for (const char* const name : {"point", "status", "checks", "warnings"}) {
    table.columns.push_back({name, "", true});
  }
  const bool several =
      std::ranges::any_of(shown, [](const SweepCell& c) { return c.increment > 1; });
  for (const SweepCell& cell : shown) {
    if (cell.quantity == "N") {
      table.columns.push_back({"N", life_unit(model), false});
      continue;
    }
    const bool crack = cell.quantity == "K1";
    const std::string unit =
        crack ? model.units.stress_intensity_name() : model.units.stress_name();
    table.columns.push_back(
        {fmt::format("{} {}{}", crack ? "K1" : "p max", cell.name,
                     several ? fmt::format(", increment {}", cell.increment) : std::string()),
         unit, false});
    if (any_bar(sweep, cell)) {
      table.columns.push_back({"+-", unit, false});
    }
  }
  table.columns.push_back({"", "", true});
  for (const SweepPoint& point : sweep.points) {
    std::vector<std::string> row;
    for (const double value : point.values) {
      row.push_back(fmt::format("{:.6g}", value));
    }
    row.insert(row.end(), {point.folder, status_word(point), checks_of(point),
                           point.warnings > 0 ? std::to_string(point.warnings) : ""});
    for (const SweepCell& cell : shown) {
      const SweepCell* const found = find_cell(point, cell.column_name());
      row.push_back(found == nullptr ? "-" : fmt::format("{:.5g}", found->value));
      if (any_bar(sweep, cell)) {
        const double bar = bar_of(point, cell);
        row.push_back(std::isfinite(bar) ? format_error_bar(bar) : "-");
      }
    }
    row.push_back(point.error);
    table.rows.push_back(std::move(row));
  }
  return table;
}

} // namespace

std::string sweep_page(const base::SourceTexts& sources, const model::Model& model,
                       const SweepResult& sweep) {
  HtmlPage page;
  const std::string title = model.title.empty() ? "spricka sweep" : model.title;
  page.add_html(fmt::format("<h1>{}</h1>\n", escape_xml(title)));
  const auto failed =
      std::count_if(sweep.points.begin(), sweep.points.end(),
                    [](const SweepPoint& p) { return p.outcome != base::Outcome::done; });
  page.add_paragraph(
      fmt::format("Sweep of {} over {}: {} of {} points were run, {} of them failed. Computed by "
                  "spricka {}.",
                  deck_name(sources, 0), fmt::join(sweep.parameters, ", "), sweep.points.size(),
                  sweep.count, failed, SPRICKA_VERSION),
      failed > 0 ? "failed" : "about");
  const std::map<int, double> lengths = lengths_of(sweep);
  if (!lengths.empty()) {
    page.add_heading("Stress intensity factors");
  }
  Units units;
  for (const std::string& parameter : sweep.parameters) {
    units.push_back(parameter_unit(sources, model.units, parameter));
  }
  const std::string K_name =
      fmt::format("K₁ [{}]", typeset_unit(model.units.stress_intensity_name()));
  for (const auto& [increment, a] : lengths) {
    const Plot plot =
        plot_of(sweep, units, K_name, merged(curves_of(model, sweep, "K1", increment)));
    page.add_figure(
        {{draw_svg(plot)},
         "",
         fmt::format("K₁ at the end of each step, increment {} (a = {:.6g} {}). Curves "
                     "that differ by less than 0.1 % of the largest value are drawn once.",
                     increment, a, model.units.length_name) +
             error_bar_note(plot.series)});
  }
  if (has_lives(sweep)) {
    page.add_heading("Life");
    const double unit = life_scale(sweep);
    const std::string name = fmt::format(
        "N [{}{}]", unit > 1.0 ? fmt::format("{:.0f} ", unit) : std::string(), life_unit(model));
    page.add_figure(
        {{draw_svg(plot_of(sweep, units, name, lives_of(model, sweep, unit)))},
         "",
         "The life of each point. The program chooses the lengths at which it solves for "
         "K, and they differ from point to point: K is shown at the first one."});
  }
  page.add_heading("Points");
  if (const auto warned = std::ranges::count_if(
          sweep.points, [](const SweepPoint& point) { return point.warnings > 0; });
      warned > 0) {
    page.add_paragraph(
        fmt::format("{} of the points have warnings: their folders' report.html says which.",
                    warned),
        "failed");
  }
  page.add_table(points_table(model, sweep, units));
  return page.finish_page(title);
}

} // namespace spricka::report
