// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/load_path_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace spricka::report {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

double in_print(const results::LoadPathContact& contact, double place) {
  return contact.round ? place * degrees : place;
}

/// A curve of K1 over t that is shown: of a tip, or of a point of a front.
struct Shown {
  std::string name;
  double a = 0.0;
  const base::PiecewiseLinear* K1 = nullptr;
  const results::LoadPathFront* tip = nullptr; ///< null: of a front
};

// Of a front in space the points with the largest and the smallest K1 at the path's end.
void add_curves(const results::LoadPathFront& front, std::vector<Shown>& shown) {
  if (front.is_tip()) {
    shown.push_back({front.is.name, front.is.a, front.tip().K.data(), &front});
    return;
  }
  const results::LoadPathFrontPoint* low = nullptr;
  const results::LoadPathFrontPoint* high = nullptr;
  const auto end = [](const results::LoadPathFrontPoint* p) {
    return p->K[0].at_knot(p->K[0].segments());
  };
  for (const results::LoadPathFrontPoint& point : front.points) {
    if (point.is.at_surface) {
      continue;
    }
    low = low == nullptr || end(&point) < end(low) ? &point : low;
    high = high == nullptr || end(&point) > end(high) ? &point : high;
  }
  if (high != nullptr) {
    shown.push_back({fmt::format("{} point {} (largest)", front.is.name, high->is.number),
                     front.is.a, high->K.data(), nullptr});
    shown.push_back({fmt::format("{} point {} (smallest)", front.is.name, low->is.number),
                     front.is.a, low->K.data(), nullptr});
  }
}

std::vector<Shown> shown_curves(const results::LoadPathResult& path) {
  std::vector<Shown> shown;
  for (const results::LoadPathFront& front : path.fronts) {
    add_curves(front, shown);
  }
  return shown;
}

/// The knot where the slope jumps most, and by how much.
struct Kink {
  std::size_t knot = 0;
  double jump = 0.0;
  double largest_slope = 0.0;
};
Kink sharpest(const base::PiecewiseLinear& K) {
  Kink kink;
  for (std::size_t s = 0; s < K.segments(); ++s) {
    kink.largest_slope = std::max(kink.largest_slope, std::abs(K.slope(s)));
    const double jump = s > 0 ? std::abs(K.slope(s) - K.slope(s - 1)) : 0.0;
    if (jump > kink.jump) {
      kink.jump = jump;
      kink.knot = s;
    }
  }
  return kink;
}

std::string arc(const results::LoadPathContact& contact, std::size_t k) {
  if (contact.closed[k] == 0) {
    return "open";
  }
  return fmt::format("{:.4g} .. {:.4g}{}", in_print(contact, contact.from[k]),
                     in_print(contact, contact.to[k]), contact.round ? " deg" : "");
}

// The slope as steps.
std::vector<DrawingPoint> slopes(const base::PiecewiseLinear& K) {
  std::vector<DrawingPoint> points;
  for (std::size_t s = 0; s < K.segments(); ++s) {
    points.push_back({K.knots()[s], K.slope(s)});
    points.push_back({K.knots()[s + 1], K.slope(s)});
  }
  return points;
}

std::vector<DrawingPoint> values(const base::PiecewiseLinear& K) {
  std::vector<DrawingPoint> points;
  for (std::size_t k = 0; k < K.knots().size(); ++k) {
    points.push_back({K.knots()[k], K.at_knot(k)});
  }
  return points;
}

// Error bars of K1 at the ends of the path, which are ends of steps: elsewhere none is worked out.
PlotSeries end_bars(const results::Increment& increment, const results::LoadPathResult& path,
                    const results::LoadPathFront& tip, const std::string& colour) {
  PlotSeries series;
  series.joined = false;
  series.colour = colour;
  for (const DrawingPoint& point : values(tip.tip().K[0])) {
    if (point.x != 0.0 && point.x != 1.0) {
      continue;
    }
    const results::StepResult* const at =
        results::find_step(increment, point.x == 0.0 ? path.from : path.to);
    const results::FrontResult* const found =
        at == nullptr ? nullptr : results::find_front(*at, tip.is.name);
    series.points.push_back(point);
    series.bars.push_back(found != nullptr ? drawn_k1_bar(*found) : no_bar);
  }
  return series;
}

// Where contacts begin to open, as marks on the curve of a tip.
void add_openings(Plot& plot, const results::LoadPathResult& path, const base::PiecewiseLinear& K1,
                  bool named) {
  constexpr std::array<MarkerShape, 4> shapes{MarkerShape::diamond, MarkerShape::triangle,
                                              MarkerShape::plus, MarkerShape::cross};
  std::size_t shape = 0;
  for (const results::LoadPathContact& contact : path.contacts) {
    const MarkerShape marker = shapes[shape++ % shapes.size()];
    if (contact.opening) {
      PlotSeries series;
      series.name = named ? fmt::format("{} begins to open", contact.name) : std::string();
      series.points = {{*contact.opening, K1(*contact.opening)}};
      series.joined = false;
      series.marker = marker;
      plot.series.push_back(series);
    }
  }
}

Figure figure_of(const model::Model& model, const results::RunResult& run, std::size_t p) {
  const std::string unit = typeset_unit(model.units.stress_intensity_name());
  const std::string x_name = "t";
  Plot value{
      "Stress intensity factor over the load path", x_name, fmt::format("K₁  [{}]", unit), {}};
  Plot slope{"Its slope", x_name, fmt::format("dK₁/dt  [{}]", unit), {}};
  value.legend_below = slope.legend_below = true;
  std::size_t ink = 0;
  const auto increments = chosen_increments(run, 6);
  for (const results::Increment* increment : increments) {
    const results::LoadPathResult& path = increment->paths[p];
    std::size_t pattern = 0;
    const std::vector<Shown> curves = shown_curves(path);
    for (const Shown& tip : curves) {
      PlotSeries series;
      series.name =
          fmt::format("{}a = {:.4g} {}", curves.size() > 1 ? tip.name + ", " : std::string(), tip.a,
                      model.units.length_name);
      series.colour = palette_colour(ink);
      series.dash = dash_pattern(pattern++);
      series.points = values(*tip.K1);
      value.series.push_back(series);
      if (tip.tip != nullptr) {
        value.series.push_back(end_bars(*increment, path, *tip.tip, series.colour));
      }
      series.points = slopes(*tip.K1);
      slope.series.push_back(series);
    }
    ++ink;
  }
  for (const results::Increment* increment : increments) {
    const results::LoadPathResult& path = increment->paths[p];
    if (const std::vector<Shown> curves = shown_curves(path); !curves.empty()) {
      add_openings(value, path, *curves.front().K1, increment == increments.front());
    }
  }
  const results::LoadPathResult& path = increments.front()->paths[p];
  return {{draw_svg(value), draw_svg(slope)},
          "",
          fmt::format("Load path {}: K₁ under the loads and fits (1 − t) {} + t {}, and its slope. "
                      "K₁ is a straight line between the breakpoints, where a pair of contact "
                      "nodes opens or closes. Marks: the first pair of a contact opens.{}",
                      path.name, path.from, path.to, error_bar_note(value.series))};
}

} // namespace

ReportTable load_path_table(const model::Model& model, const results::Increment& increment) {
  const std::string unit = model.units.stress_intensity_name();
  ReportTable table{"Load paths: K1 over t",
                    {{"path", "", true},
                     {"from", "", true},
                     {"to", "", true},
                     {"tip", "", true},
                     {"breakpoints", "", false},
                     {"t end", "", false},
                     {"K1 begin", unit, false},
                     {"K1 end", unit, false},
                     {"slope begin", unit, false},
                     {"slope end", unit, false},
                     {"largest jump", "%", false},
                     {"at t", "", false}},
                    {}};
  for (const results::LoadPathResult& path : increment.paths) {
    for (const Shown& tip : shown_curves(path)) {
      const base::PiecewiseLinear& K1 = *tip.K1;
      const Kink kink = sharpest(K1);
      const bool kinked = kink.jump > 0.0 && kink.largest_slope > 0.0;
      table.rows.push_back(
          {path.name, path.from, path.to, tip.name, fmt::format("{}", path.t.size() - 2),
           six_digits(path.t.back()), six_digits(K1.at_knot(0)),
           six_digits(K1.at_knot(K1.segments())), six_digits(K1.slope_after(0)),
           six_digits(K1.slope_before(K1.segments())),
           kinked ? fmt::format("{:.2f}", 100.0 * kink.jump / kink.largest_slope) : "",
           kinked ? six_digits(K1.knots()[kink.knot]) : ""});
    }
  }
  return table;
}

ReportTable opening_table(const results::Increment& increment) {
  const bool arcs = increment.mesh.dim == 2;
  ReportTable table{"Load paths: contact",
                    {{"path", "", true},
                     {"contact", "", true},
                     {"first pair opens at t", "", false},
                     {"closed at begin", "", false},
                     {"at end", "", false},
                     {"of", "", false}},
                    {}};
  if (arcs) {
    table.columns.push_back({"arc at begin", "", false});
    table.columns.push_back({"arc at end", "", false});
  }
  for (const results::LoadPathResult& path : increment.paths) {
    for (const results::LoadPathContact& contact : path.contacts) {
      const std::size_t last = contact.closed.size() - 1;
      std::vector<std::string> row{path.name,
                                   contact.name,
                                   contact.opening ? six_digits(*contact.opening) : "none",
                                   fmt::format("{}", contact.closed.front()),
                                   fmt::format("{}", contact.closed[last]),
                                   fmt::format("{}", contact.rows)};
      if (arcs) {
        row.push_back(arc(contact, 0));
        row.push_back(arc(contact, last));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::vector<Figure> load_path_figures(const model::Model& model, const results::RunResult& run) {
  std::vector<Figure> figures;
  for (std::size_t p = 0; p < model.load_paths.size(); ++p) {
    const bool drawn = !run.increments.empty() &&
                       std::ranges::all_of(run.increments, [&](const results::Increment& i) {
                         return p < i.paths.size() && !shown_curves(i.paths[p]).empty();
                       });
    if (drawn) {
      figures.push_back(figure_of(model, run, p));
    }
  }
  return figures;
}

} // namespace spricka::report
