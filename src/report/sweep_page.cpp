// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/deck_name.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/plot.hpp"
#include "report/page.hpp"
#include "report/sweep_files.hpp"
#include "report/topics/k_bars.hpp"
#include "report/topics/parameter_unit.hpp"
#include "results/result_unit.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace spricka::report {

namespace {

using results::SweepPoint;
using results::SweepResult;
using results::SweepResultValue;
using Units = std::vector<std::string>; // [parameter]

const SweepResultValue* find_cell(const SweepPoint& point, const std::string& column) {
  const auto found = std::ranges::find(point.cells, column, &SweepResultValue::column_name);
  return found == point.cells.end() ? nullptr : &*found;
}

/// The error bar of a point's K1.
double bar_of(const SweepPoint& point, SweepResultValue cell) {
  cell.quantity += "_bar";
  const SweepResultValue* const bar = find_cell(point, cell.column_name());
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

/// The curves of what `name_of` names over the swept parameter; a cell without a name is left out.
/// What stays the same along a curve is its name: front, step and the parameters that do not run
/// along the axis.
template <class NameOf>
std::vector<PlotSeries> curves_of(const model::Model& model, const SweepResult& sweep,
                                  const NameOf& name_of) {
  const std::size_t axis = axis_of(sweep);
  std::vector<PlotSeries> curves;
  for (const SweepPoint& point : sweep.points) {
    for (const SweepResultValue& cell : point.cells) {
      std::string name = name_of(cell);
      if (name.empty()) {
        continue;
      }
      name += others(model, sweep, point, axis);
      auto curve = std::ranges::find(curves, name, &PlotSeries::name);
      if (curve == curves.end()) {
        curve = curves.insert(curve, styled_curve(name, 0, 0));
      }
      const auto at =
          std::ranges::upper_bound(curve->points, point.values[axis], {}, &DrawingPoint::x);
      curve->bars.insert(curve->bars.begin() + (at - curve->points.begin()), bar_of(point, cell));
      curve->points.insert(at, {point.values[axis], cell.value});
    }
  }
  return curves;
}

/// Lives, each divided by `unit`, ordered by name.
std::vector<PlotSeries> lives_of(const model::Model& model, const SweepResult& sweep, double unit) {
  std::vector<PlotSeries> curves = curves_of(
      model, sweep, [](const SweepResultValue& cell) { return cell.quantity == "N" ? "N" : ""; });
  std::ranges::sort(curves, {}, &PlotSeries::name);
  for (PlotSeries& curve : curves) {
    std::ranges::for_each(curve.points, [&](DrawingPoint& p) { p.y /= unit; });
  }
  return curves;
}

// Curves of K1; those within a thousandth of the largest value are one, under both names.
std::vector<PlotSeries> merged_k_curves(const model::Model& model, const SweepResult& sweep,
                                        int increment) {
  std::vector<PlotSeries> curves = curves_of(model, sweep, [&](const SweepResultValue& cell) {
    return cell.quantity == "K1" && cell.increment == increment
               ? fmt::format("{}: {}", cell.step, cell.name)
               : std::string();
  });
  double largest = 0.0;
  for (const PlotSeries& curve : curves) {
    for (const DrawingPoint& p : curve.points) {
      largest = std::max(largest, std::abs(p.y));
    }
  }
  const auto alike = [&](const DrawingPoint& a, const DrawingPoint& b) {
    return a.x == b.x && std::abs(a.y - b.y) <= 1e-3 * largest;
  };
  std::vector<PlotSeries> kept;
  for (PlotSeries& curve : curves) {
    const auto same = std::ranges::find_if(kept, [&](const PlotSeries& k) {
      return std::ranges::equal(k.points, curve.points, alike);
    });
    if (same != kept.end()) {
      same->name += "; " + curve.name;
    } else {
      kept.push_back(std::move(curve));
    }
  }
  return kept;
}

Plot plot_of(const SweepResult& sweep, const Units& units, const std::string& y_name,
             std::vector<PlotSeries> curves) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    curves[i].colour = palette_colour(i);
    curves[i].dash = dash_pattern(i / 7);
    curves[i].marker = palette_marker_shape(i);
  }
  const std::size_t axis = axis_of(sweep);
  return {y_name + " over the swept parameter",
          axis_title(sweep.parameters[axis], base::OutputUnit{units[axis]}), y_name,
          std::move(curves)};
}

bool has_lives(const SweepResult& sweep) {
  return std::ranges::any_of(
      sweep.points, [](const SweepPoint& point) { return find_cell(point, "N") != nullptr; });
}

std::string life_words(const model::Model& model) {
  return results::life_unit_words(results::life_unit_name(model));
}

/// Of an axis of lives: numbers on it stay short.
double life_scale(const SweepResult& sweep) {
  double largest = 0.0;
  for (const SweepPoint& point : sweep.points) {
    const SweepResultValue* const life = find_cell(point, "N");
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
    for (const SweepResultValue& cell : point.cells) {
      if (cell.quantity == "a" && cell.name.empty() && cell.increment <= last) {
        lengths.emplace(cell.increment, cell.value);
      }
    }
  }
  return lengths;
}

/// The cells that the table shows: the life; K1 of each tip and the largest pressure of each
/// contact at the end of that step.
std::vector<SweepResultValue> shown_cells(const SweepResult& sweep, const std::string& step) {
  std::vector<SweepResultValue> shown;
  const std::string nowhere;
  const int last = has_lives(sweep) ? 1 : std::numeric_limits<int>::max();
  for (const char* const quantity : {"N", "K1", "PMAX"}) {
    const std::string& at = std::string_view(quantity) == "N" ? nowhere : step;
    for (const SweepPoint& point : sweep.points) {
      for (const SweepResultValue& cell : point.cells) {
        const bool known = std::ranges::find(shown, cell.column_name(),
                                             &SweepResultValue::column_name) != shown.end();
        if (cell.quantity == quantity && cell.step == at && cell.increment <= last && !known) {
          shown.push_back(cell);
        }
      }
    }
  }
  return shown;
}

bool any_bar(const SweepResult& sweep, const SweepResultValue& cell) {
  return cell.quantity == "K1" && std::ranges::any_of(sweep.points, [&](const SweepPoint& point) {
           return std::isfinite(bar_of(point, cell));
         });
}

std::string checks_at_all_points(const SweepPoint& point) {
  return point.checks == 0 ? "" : fmt::format("{} of {} passed", point.passed, point.checks);
}

void add_cell_columns(Columns<SweepPoint>& columns, const model::Model& model,
                      const SweepResult& sweep, const SweepResultValue& cell, bool several) {
  const bool crack = cell.quantity == "K1";
  const std::string unit =
      (crack ? model.units.output_stress_intensity() : model.units.output_stress()).name;
  const auto text = [cell](const SweepPoint& point) {
    const SweepResultValue* const found = find_cell(point, cell.column_name());
    return found == nullptr ? "-" : fmt::format("{:.5g}", found->value);
  };
  if (cell.quantity == "N") {
    columns.number("N", life_words(model), text);
    return;
  }
  columns.number(fmt::format("{} {}{}", crack ? "K1" : "p max", cell.name,
                             several ? fmt::format(", increment {}", cell.increment) : ""),
                 unit, text);
  if (any_bar(sweep, cell)) {
    columns.number("+-", unit, [cell](const SweepPoint& point) {
      const double bar = bar_of(point, cell);
      return std::isfinite(bar) ? format_error_bar(bar) : "-";
    });
  }
}

ReportTable points_table(const model::Model& model, const SweepResult& sweep, const Units& units) {
  const std::string step = results::shown_step_name(model, {});
  const std::vector<SweepResultValue> shown = shown_cells(sweep, step);
  Columns<SweepPoint> columns;
  for (std::size_t p = 0; p < sweep.parameters.size(); ++p) {
    columns.number(sweep.parameters[p], units[p],
                   [p](const SweepPoint& point) { return point.values[p]; });
  }
  columns.words("point", &SweepPoint::folder)
      .words("status", sweep_point_status)
      .words("checks", checks_at_all_points)
      .words("warnings", [](const SweepPoint& point) {
        return point.warnings > 0 ? std::to_string(point.warnings) : "";
      });
  const bool several =
      std::ranges::any_of(shown, [](const SweepResultValue& c) { return c.increment > 1; });
  for (const SweepResultValue& cell : shown) {
    add_cell_columns(columns, model, sweep, cell, several);
  }
  columns.words("", &SweepPoint::error);
  return columns.table(shown.empty() ? "" : fmt::format("At the end of step {}", step),
                       sweep.points);
}

} // namespace

std::string sweep_page(const base::SourceTexts& sources, const model::Model& model,
                       const SweepResult& sweep) {
  HtmlPage page;
  const std::string title = model.title.empty() ? "spricka sweep" : model.title;
  page.add_html(fmt::format("<h1>{}</h1>\n", escape_xml(title)));
  const auto failed =
      std::count_if(sweep.points.begin(), sweep.points.end(),
                    [](const SweepPoint& p) { return p.outcome != base::ProgramOutcome::done; });
  page.add_html(
      fmt::format("<p class=\"{}\">Sweep of {} over {}: {} of {} points were run, {} of them "
                  "failed. Computed by spricka {}.</p>\n",
                  failed > 0 ? "failed" : "about", escape_xml(relative_deck_file_name(sources, 0)),
                  escape_xml(fmt::format("{}", fmt::join(sweep.parameters, ", "))),
                  sweep.points.size(), sweep.count, failed, SPRICKA_VERSION));
  const std::map<int, double> lengths = lengths_of(sweep);
  if (!lengths.empty()) {
    page.add_heading("Stress intensity factors");
  }
  Units units;
  for (const std::string& parameter : sweep.parameters) {
    units.push_back(find_parameter_unit(sources, model.units, parameter));
  }
  const std::string K_name =
      fmt::format("K₁ [{}]", typeset_unit(model.units.output_stress_intensity().name));
  for (const auto& [increment, a] : lengths) {
    const Plot plot = plot_of(sweep, units, K_name, merged_k_curves(model, sweep, increment));
    page.add_figure(
        {{draw_svg(plot)},
         "",
         fmt::format("K₁ at the end of each step, increment {} (a = {:.6g} {}). Curves "
                     "that differ by less than 0.1 % of the largest value are drawn once.",
                     increment, a, model.units.output_length().name) +
             error_bar_note(plot.series)});
  }
  if (has_lives(sweep)) {
    page.add_heading("Life");
    const double unit = life_scale(sweep);
    const std::string name = fmt::format(
        "N [{}{}]", unit > 1.0 ? fmt::format("{:.0f} ", unit) : std::string(), life_words(model));
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
    page.add_html(fmt::format("<p class=\"failed\">{} of the points have warnings: their folders' "
                              "report.html says which.</p>\n",
                              warned));
  }
  page.add_table(points_table(model, sweep, units));
  return page.finish_page(title);
}

} // namespace spricka::report
