// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/load_path_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/plot.hpp"
#include "report/topics/dimension_columns.hpp"
#include "report/topics/result_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace spricka::report {

namespace {

/// A curve of K1 over t that is shown: of a tip, or of a point of a front.
struct ShownCurve {
  std::string name;
  double a = 0.0;
  const base::PiecewiseLinear* K1 = nullptr;
  std::string tip; ///< its name, where the steps' K at the ends belong to the same; or empty
};

// Of a front in space the points with the largest and the smallest K1 at the path's end.
void add_curves(const results::LoadPathFront& front, std::vector<ShownCurve>& shown) {
  if (front.is_tip()) {
    shown.push_back({front.front_without_points.name, front.front_without_points.a,
                     front.single_point().K.data(), front.front_without_points.name});
    return;
  }
  const results::LoadPathFrontPoint* low = nullptr;
  const results::LoadPathFrontPoint* high = nullptr;
  const auto end = [](const results::LoadPathFrontPoint* p) {
    return p->K[0].value_at_knot(p->K[0].segment_count());
  };
  for (const results::LoadPathFrontPoint& point : front.points) {
    if (!point.point_at_start.at_surface) {
      low = low == nullptr || end(&point) < end(low) ? &point : low;
      high = high == nullptr || end(&point) > end(high) ? &point : high;
    }
  }
  for (const auto& [point, word] : {std::pair(high, "largest"), {low, "smallest"}}) {
    if (point != nullptr) {
      shown.push_back({fmt::format("{} point {} ({})", front.front_without_points.name,
                                   point->point_at_start.number, word),
                       front.front_without_points.a, point->K.data(), ""});
    }
  }
}

std::vector<ShownCurve> shown_curves(const results::LoadPathResult& path) {
  std::vector<ShownCurve> shown;
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
  for (std::size_t s = 0; s < K.segment_count(); ++s) {
    kink.largest_slope = std::max(kink.largest_slope, std::abs(K.slope(s)));
    const double jump = s > 0 ? std::abs(K.slope(s) - K.slope(s - 1)) : 0.0;
    if (jump > kink.jump) {
      kink.jump = jump;
      kink.knot = s;
    }
  }
  return kink;
}

std::string arc(const results::LoadPathContact& contact, std::size_t k,
                const base::OutputUnit& length) {
  return contact.closed[k] == 0
             ? "open"
             : fmt::format("{:.4g} .. {:.4g}{}",
                           contact_place_as_written(contact, contact.from[k], length),
                           contact_place_as_written(contact, contact.to[k], length),
                           contact.round ? " deg" : "");
}

// The slope as steps.
std::vector<DrawingPoint> slopes(const base::PiecewiseLinear& K) {
  std::vector<DrawingPoint> points;
  for (std::size_t s = 0; s < K.segment_count(); ++s) {
    points.push_back({K.knots()[s], K.slope(s)});
    points.push_back({K.knots()[s + 1], K.slope(s)});
  }
  return points;
}

std::vector<DrawingPoint> values(const base::PiecewiseLinear& K) {
  std::vector<DrawingPoint> points;
  for (std::size_t k = 0; k < K.knots().size(); ++k) {
    points.push_back({K.knots()[k], K.value_at_knot(k)});
  }
  return points;
}

// Error bars of K1 at the ends of the path, which are ends of steps: elsewhere none is worked out.
PlotSeries end_bars(const results::CrackLengthResult& increment,
                    const results::LoadPathResult& path, const ShownCurve& curve) {
  PlotSeries series;
  series.joined = false;
  for (const DrawingPoint& point : values(*curve.K1)) {
    if (point.x == 0.0 || point.x == 1.0) {
      const std::string& step = point.x == 0.0 ? path.from : path.to;
      series.points.push_back(point);
      series.bars.push_back(k1_bar_for_plot(find_front_at_step(increment, step, curve.tip)));
    }
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
      plot.series
          .emplace_back(marker_series(
              named ? fmt::format("{} begins to open", contact.name) : std::string(), marker))
          .points = {{*contact.opening, K1(*contact.opening)}};
    }
  }
}

Figure figure_of(const model::Model& model, const results::RunResult& run, std::size_t p) {
  const base::OutputUnit unit = model.units.output_stress_intensity();
  Plot value{"Stress intensity factor over the load path", "t", axis_title("K₁", unit), {}};
  Plot slope{"Its slope", "t", axis_title("dK₁/dt", unit), {}};
  value.legend_below = slope.legend_below = true;
  const auto increments = sample_increments(run, 6);
  for (std::size_t ink = 0; ink < increments.size(); ++ink) {
    const results::LoadPathResult& path = increments[ink]->paths[p];
    std::size_t pattern = 0;
    const std::vector<ShownCurve> curves = shown_curves(path);
    for (const ShownCurve& curve : curves) {
      PlotSeries series = styled_curve(
          fmt::format("{}a = {}", curves.size() > 1 ? curve.name + ", " : std::string(),
                      model.units.output_length().text(curve.a, 4)),
          ink, pattern++);
      series.points = values(*curve.K1);
      value.series.push_back(series);
      if (!curve.tip.empty()) {
        value.series.push_back(end_bars(*increments[ink], path, curve));
        value.series.back().colour = series.colour;
      }
      series.points = slopes(*curve.K1);
      slope.series.push_back(std::move(series));
    }
  }
  for (const results::CrackLengthResult* increment : increments) {
    const results::LoadPathResult& path = increment->paths[p];
    if (const std::vector<ShownCurve> curves = shown_curves(path); !curves.empty()) {
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

ReportTable load_path_table(const model::Model& model,
                            const results::CrackLengthResult& increment) {
  struct CurveRow {
    const results::LoadPathResult& path;
    ShownCurve curve;
    Kink kink;
  };
  std::vector<CurveRow> rows;
  for (const results::LoadPathResult& path : increment.paths) {
    for (const ShownCurve& curve : shown_curves(path)) {
      rows.push_back({path, curve, sharpest(*curve.K1)});
    }
  }
  const base::OutputUnit unit = model.units.output_stress_intensity();
  const auto K1 = [](const CurveRow& row) -> const base::PiecewiseLinear& { return *row.curve.K1; };
  Columns<CurveRow> columns;
  columns.words("path", [](const CurveRow& row) { return row.path.name; })
      .words("from", [](const CurveRow& row) { return row.path.from; })
      .words("to", [](const CurveRow& row) { return row.path.to; })
      .words("tip", [](const CurveRow& row) { return row.curve.name; })
      .number("breakpoints", "", [](const CurveRow& row) { return row.path.t.size() - 2; })
      .number("t end", "", [](const CurveRow& row) { return row.path.t.back(); })
      .number("K1 begin", unit, [=](const CurveRow& row) { return K1(row).value_at_knot(0); })
      .number("K1 end", unit,
              [=](const CurveRow& row) { return K1(row).value_at_knot(K1(row).segment_count()); })
      .number("slope begin", unit, [=](const CurveRow& row) { return K1(row).slope_after(0); })
      .number("slope end", unit,
              [=](const CurveRow& row) { return K1(row).slope_before(K1(row).segment_count()); })
      .fill_only_if(
          [](const CurveRow& row) { return row.kink.jump > 0.0 && row.kink.largest_slope > 0.0; })
      .number(
          "largest jump", "%",
          [](const CurveRow& row) { return 100.0 * row.kink.jump / row.kink.largest_slope; },
          "{:.2f}")
      .number("at t", "", [=](const CurveRow& row) { return K1(row).knots()[row.kink.knot]; });
  return columns.table("Load paths: K1 over t", rows);
}

ReportTable contact_opening_onset_table(const model::Model& model,
                                        const results::CrackLengthResult& increment) {
  struct OpeningRow {
    const results::LoadPathResult& path;
    const results::LoadPathContact& contact;
  };
  std::vector<OpeningRow> rows;
  for (const results::LoadPathResult& path : increment.paths) {
    for (const results::LoadPathContact& contact : path.contacts) {
      rows.push_back({path, contact});
    }
  }
  const auto last = [](const OpeningRow& row) { return row.contact.closed.size() - 1; };
  Columns<OpeningRow> columns;
  columns.words("path", [](const OpeningRow& row) { return row.path.name; })
      .words("contact", [](const OpeningRow& row) { return row.contact.name; })
      .number("first pair opens at t", "",
              [](const OpeningRow& row) {
                return row.contact.opening ? format_six_digits(*row.contact.opening) : "none";
              })
      .number("closed at begin", "",
              [](const OpeningRow& row) { return row.contact.closed.front(); })
      .number("at end", "", [=](const OpeningRow& row) { return row.contact.closed[last(row)]; })
      .number("of", "", [](const OpeningRow& row) { return row.contact.rows; });
  if (dimension_columns.at(increment.mesh.dim).arcs) {
    const base::OutputUnit length = model.units.output_length();
    columns
        .number("arc at begin", "",
                [=](const OpeningRow& row) { return arc(row.contact, 0, length); })
        .number("arc at end", "",
                [=](const OpeningRow& row) { return arc(row.contact, last(row), length); });
  }
  return columns.table("Load paths: contact", rows);
}

std::vector<Figure> load_path_figures(const model::Model& model, const results::RunResult& run) {
  std::vector<Figure> figures;
  for (std::size_t p = 0; p < model.load_paths.size(); ++p) {
    const bool drawn =
        !run.increments.empty() &&
        std::ranges::all_of(run.increments, [&](const results::CrackLengthResult& i) {
          return p < i.paths.size() && !shown_curves(i.paths[p]).empty();
        });
    if (drawn) {
      figures.push_back(figure_of(model, run, p));
    }
  }
  return figures;
}

} // namespace spricka::report
