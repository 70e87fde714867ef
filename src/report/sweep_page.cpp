// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/deck_name.hpp"
#include "report/page.hpp"
#include "report/plot.hpp"
#include "report/result_tables.hpp"
#include "report/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace spricka::report {

namespace {

using results::Sweep;
using results::SweepCell;
using results::SweepPoint;

/// What stays the same along a curve: tip, step and the parameters that do not run along the axis.
struct Curve {
  std::string name;
  std::vector<Point> points;
};

// The parameter that takes the most values runs along the axis.
std::size_t axis_of(const Sweep& sweep) {
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
std::string others(const model::Model& model, const Sweep& sweep, const SweepPoint& point,
                   std::size_t axis) {
  std::string text;
  for (std::size_t p = 0; p < sweep.parameters.size(); ++p) {
    const bool with_axis =
        std::any_of(model.sweeps.begin(), model.sweeps.end(), [&](const model::Sweep& card) {
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

std::vector<Curve> curves_of(const model::Model& model, const Sweep& sweep, int increment) {
  const std::size_t axis = axis_of(sweep);
  std::vector<Curve> curves;
  for (const SweepPoint& point : sweep.points) {
    for (const SweepCell& cell : point.cells) {
      if (cell.quantity != "K1" || cell.increment != increment) {
        continue;
      }
      const std::string name =
          fmt::format("{}: {}{}", cell.step, cell.name, others(model, sweep, point, axis));
      auto curve = std::find_if(curves.begin(), curves.end(),
                                [&](const Curve& c) { return c.name == name; });
      if (curve == curves.end()) {
        curve = curves.insert(curves.end(), {name, {}});
      }
      curve->points.push_back({point.values[axis], cell.value});
    }
  }
  for (Curve& curve : curves) {
    std::stable_sort(curve.points.begin(), curve.points.end(),
                     [](const Point& a, const Point& b) { return a.x < b.x; });
  }
  return curves;
}

// Curves within a thousandth of the largest value are one, under both names.
std::vector<Curve> merged(std::vector<Curve> curves) {
  double largest = 0.0;
  for (const Curve& curve : curves) {
    for (const Point& p : curve.points) {
      largest = std::max(largest, std::abs(p.y));
    }
  }
  std::vector<Curve> kept;
  for (Curve& curve : curves) {
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const Curve& k) {
      return k.points.size() == curve.points.size() &&
             std::equal(k.points.begin(), k.points.end(), curve.points.begin(),
                        [&](const Point& a, const Point& b) {
                          return a.x == b.x && std::abs(a.y - b.y) <= 1e-3 * largest;
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

Plot plot_of(const model::Model& model, const Sweep& sweep, int increment) {
  Plot plot;
  plot.label = "K1 over the swept parameter";
  plot.x_name = sweep.parameters[axis_of(sweep)];
  plot.y_name = fmt::format("K₁ [{}]", print_unit(model.units.stress_intensity_name()));
  std::size_t i = 0;
  for (Curve& curve : merged(curves_of(model, sweep, increment))) {
    Series series;
    series.name = std::move(curve.name);
    series.points = std::move(curve.points);
    series.colour = colour(i);
    series.dash = dash(i / 7);
    series.marker = closed_marker(i);
    plot.series.push_back(std::move(series));
    ++i;
  }
  return plot;
}

// Increments with the first crack length met, in order.
std::map<int, double> lengths_of(const Sweep& sweep) {
  std::map<int, double> lengths;
  for (const SweepPoint& point : sweep.points) {
    for (const SweepCell& cell : point.cells) {
      if (cell.quantity == "a" && cell.name.empty()) {
        lengths.emplace(cell.increment, cell.value);
      }
    }
  }
  return lengths;
}

Table points_table(const model::Model& model, const Sweep& sweep) {
  Table table{"", {}, {}};
  for (const std::string& parameter : sweep.parameters) {
    table.columns.push_back({parameter, "", false});
  }
  table.columns.push_back({"point", "", true});
  table.columns.push_back({"status", "", true});
  const std::string step = leading_step(model);
  std::vector<std::string> shown;
  for (const SweepPoint& point : sweep.points) {
    for (const SweepCell& cell : point.cells) {
      if (cell.quantity == "K1" && cell.step == step &&
          std::find(shown.begin(), shown.end(), cell.column()) == shown.end()) {
        shown.push_back(cell.column());
        table.columns.push_back({fmt::format("K1 {} {}", cell.name, cell.increment),
                                 model.units.stress_intensity_name(), false});
      }
    }
  }
  table.columns.push_back({"", "", true});
  for (const SweepPoint& point : sweep.points) {
    std::vector<std::string> row;
    for (const double value : point.values) {
      row.push_back(fmt::format("{:.6g}", value));
    }
    row.push_back(point.folder);
    row.push_back(status_word(point));
    for (const std::string& column : shown) {
      const auto cell = std::find_if(point.cells.begin(), point.cells.end(),
                                     [&](const SweepCell& c) { return c.column() == column; });
      row.push_back(cell == point.cells.end() ? "-" : fmt::format("{:.5g}", cell->value));
    }
    row.push_back(point.error);
    table.rows.push_back(std::move(row));
  }
  return table;
}

} // namespace

std::string sweep_page(const base::Sources& sources, const model::Model& model,
                       const Sweep& sweep) {
  Page page;
  const std::string title = model.title.empty() ? "spricka sweep" : model.title;
  page.add(fmt::format("<h1>{}</h1>\n", escape(title)));
  const auto failed = std::count_if(sweep.points.begin(), sweep.points.end(),
                                    [](const SweepPoint& p) { return p.exit_code != 0; });
  page.add(fmt::format("<p class=\"{}\">Sweep of {} over {}: {} of {} points, {} of them without "
                       "success. Computed by spricka {}.</p>\n",
                       failed > 0 ? "failed" : "about", escape(deck_name(sources, 0)),
                       escape(fmt::format("{}", fmt::join(sweep.parameters, ", "))),
                       sweep.points.size(), sweep.count, failed, SPRICKA_VERSION));
  const std::map<int, double> lengths = lengths_of(sweep);
  if (!lengths.empty()) {
    page.heading("Stress intensity factors");
  }
  for (const auto& [increment, a] : lengths) {
    page.figure({{draw(plot_of(model, sweep, increment))},
                 "",
                 fmt::format("K1 at the end of each step, increment {} (a = {:.6g} {}). Curves "
                             "within 0.1 % of the largest value are drawn once.",
                             increment, a, model.units.length_name)});
  }
  page.heading("Points");
  page.table(points_table(model, sweep));
  return page.finish(title);
}

} // namespace spricka::report
