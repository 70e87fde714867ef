// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/by_dimension.hpp"
#include "model/model.hpp"
#include "report/drawing/mesh_picture.hpp"
#include "report/drawing/picture_frame.hpp"
#include "report/drawing/plot.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/front_places.hpp"
#include "report/topics/front_section.hpp"
#include "report/topics/growth_law_figure.hpp"
#include "report/topics/growth_point_names.hpp"
#include "report/topics/growth_tables.hpp"
#include "report/topics/load_path_tables.hpp"
#include "report/topics/result_rows.hpp"
#include "report/topics/result_tables.hpp"
#include "report/topics/spectrum_tables.hpp"
#include "results/result_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace spricka::report {
namespace {

using results::GrowthResult;
using results::GrowthStation;

constexpr double label_room = 0.1; // of a picture's width

std::vector<DrawingPoint> life_points(const std::vector<results::LifeCurvePoint>& curve,
                                      std::size_t front) {
  std::vector<DrawingPoint> points;
  points.reserve(curve.size());
  for (const results::LifeCurvePoint& point : curve) {
    points.push_back({point.cycles, point.a[front]});
  }
  return points;
}

/// Lengths over cycles: the curve as a line, what was solved as marks on it.
void add_life_curve(Plot& plot, const GrowthResult& growth, const ReportedGrowthPoint& reported,
                    std::size_t ink) {
  const std::size_t front = reported.index;
  PlotSeries line = styled_curve(reported.name, ink, ink);
  line.points = life_points(growth.curve, front);
  PlotSeries marks = marker_series("", palette_marker_shape(ink));
  marks.colour = line.colour;
  for (const GrowthStation& station : growth.stations) {
    marks.points.push_back({station.cycles, station.points[front].a});
  }
  plot.series.push_back(std::move(line));
  plot.series.push_back(std::move(marks));
}

/// Cycles that a $CHECK N(a) compares with.
void add_checks(Plot& plot, const model::Model& model, const results::RunResult& run) {
  PlotSeries marks = marker_series("reference", MarkerShape::plus);
  for (const model::ResultCheck& check : model.checks) {
    const double* const a = check.quantity == "N" && check.arguments.size() == 1
                                ? std::get_if<double>(&check.arguments[0])
                                : nullptr;
    if (a != nullptr) {
      marks.points.push_back({results::wanted_value(model.units, check, run), *a});
    }
  }
  if (!marks.points.empty()) {
    plot.series.push_back(std::move(marks));
  }
}

/// The largest t of a spectrum.
double largest_place(const model::SpectrumDefinition& spectrum) {
  double top = 0.0;
  for (const double t : spectrum.turning_points) {
    top = std::max(top, t);
  }
  for (const std::array<double, 3>& cycle : spectrum.cycles) {
    top = std::max(top, cycle[1]);
  }
  return top;
}

/// K over the load at a length in the middle, and the lines that the other lives have taken it
/// from; empty: there is no map.
std::string lines_picture(const model::Model& model, const results::RunResult& run) {
  std::vector<bool> through_zero; // of the lives that took K from a line
  for (const results::ComparedLife& other : run.growth->compared) {
    if (other.name == results::life_of_scaled_K || other.name == results::life_by_line_of_K) {
      through_zero.push_back(other.name == results::life_of_scaled_K);
    }
  }
  if (through_zero.empty() || !model.growth->spectrum || run.increments.empty()) {
    return {};
  }
  const model::SpectrumDefinition& spectrum = model.spectra[*model.growth->spectrum];
  const results::CrackLengthResult& increment = run.increments[run.increments.size() / 2];
  const results::LoadPathResult& path = increment.paths.at(spectrum.path);
  const double top = largest_place(spectrum);
  if (path.fronts.size() != 1 || !path.fronts.front().is_tip() || path.t.empty() ||
      top > path.t.back()) {
    return {};
  }
  const base::PiecewiseLinear& K1 = path.fronts.front().single_point().K[0];
  const std::string a = model.units.output_length().text(increment.a, 4);
  Plot plot{fmt::format("K₁ over load path {} at a = {}", path.name, a),
            "t, a = " + a,
            axis_title("K₁", model.units.output_stress_intensity()),
            {}};
  plot.legend_below = true;
  PlotSeries exact = styled_curve("K of every load", 0, 0);
  for (std::size_t k = 0; k < path.t.size(); ++k) {
    exact.points.push_back({path.t[k], K1.value_at_knot(k)});
  }
  plot.series.push_back(std::move(exact));
  for (std::size_t k = 0; k < through_zero.size(); ++k) {
    const bool scaled = through_zero[k];
    PlotSeries line =
        styled_curve(scaled ? "scaled with the load" : "a line through t = 0 and the largest load",
                     1 + k, 1 + k);
    line.points = {{0.0, scaled ? 0.0 : K1(0.0)}, {top, K1(top)}};
    plot.series.push_back(std::move(line));
  }
  return draw_svg(plot);
}

Figure life_figure(const model::Model& model, const results::RunResult& run) {
  const GrowthResult& growth = *run.growth;
  base::OutputUnit life = results::life_unit(model.units, growth);
  life.name = results::life_unit_words(life.name);
  Plot plot{"Crack length over " + life.name,
            axis_title("N", life),
            axis_title("a", model.units.output_length()),
            {}};
  const std::vector<ReportedGrowthPoint> reported = name_reported_growth_points(run);
  for (std::size_t t = 0; t < reported.size(); ++t) {
    add_life_curve(plot, growth, reported[t], t);
  }
  add_checks(plot, model, run);
  std::string more;
  for (std::size_t k = 0; k < growth.compared.size(); ++k) {
    PlotSeries& series = plot.series.emplace_back(
        styled_curve(compared_life_legend(growth.compared[k]), reported.size() + k, 1 + k));
    series.points = life_points(growth.compared[k].curve, 0);
    plot.legend_below = true;
    plot.series.front().name =
        reported.front().name +
        (growth.interaction.empty() ? ", K of every load" : ", " + first_interaction_name(model));
    more = growth.interaction.empty()
               ? " Dashed: the life if K is taken from a straight line over the load, which the "
                 "computed K does not follow."
               : " Dashed: other rules of how cycles act on each other, or one K scaled with the "
                 "load.";
  }
  std::vector<std::string> pictures{draw_svg(plot)};
  if (std::string lines = lines_picture(model, run); !lines.empty()) {
    pictures.push_back(std::move(lines));
  }
  return {std::move(pictures), "",
          fmt::format(
              "Crack length over {}, {:.6g} in all{}. The growth ended: {}.{}", life.name,
              life.from_deck(growth.final_cycles()),
              std::isfinite(growth.error)
                  ? fmt::format("; error from the number of solved lengths (marks): about {:.2g} %",
                                100.0 * growth.error)
                  : "; too few lengths were solved (marks) to estimate the error from their number",
              growth.reason, more)};
}

/// Error bar of K1 at the largest load of a station.
double bar_at(const model::Model& model, const results::RunResult& run,
              const GrowthStation& station, const std::string& name) {
  const auto increment =
      std::ranges::find(run.increments, station.increment, &results::CrackLengthResult::number);
  return increment == run.increments.end()
             ? no_bar
             : k1_bar_for_plot(find_front_at_step(*increment, leading_step_name(model), name));
}

/// What the law was given at the stations.
Figure range_figure(const model::Model& model, const results::RunResult& run) {
  const GrowthResult& growth = *run.growth;
  Plot plot{"K of the growth law over crack length",
            axis_title("a", model.units.output_length()),
            axis_title("K", model.units.output_stress_intensity()),
            {}};
  const std::vector<ReportedGrowthPoint> reported = name_reported_growth_points(run);
  for (std::size_t t = 0; t < reported.size(); ++t) {
    for (const bool largest : {true, false}) {
      PlotSeries series =
          styled_curve(fmt::format("{}, {}", reported[t].name, largest ? "largest" : "smallest"), t,
                       largest ? 0 : 1);
      series.marker = palette_marker_shape(t);
      for (const GrowthStation& station : growth.stations) {
        const results::GrownPointResult& tip = station.points[reported[t].index];
        series.points.push_back({tip.a, largest ? tip.K_max : tip.K_min});
        if (largest) {
          series.bars.push_back(bar_at(model, run, station, tip.name));
        }
      }
      plot.series.push_back(std::move(series));
    }
  }
  return {{draw_svg(plot)},
          "",
          fmt::format("Largest and smallest K of {} that the growth law used, at the lengths that "
                      "were solved.{}",
                      growth.unit == "pass" ? "a pass of the spectrum" : "a cycle",
                      error_bar_note(plot.series))};
}

/// A square that holds all places of tips and the cracks behind them, with room round it.
void set_window(MeshView& view, const GrowthResult& growth) {
  PictureBox box;
  double longest = 0.0;
  for (const GrowthStation& station : growth.stations) {
    for (const results::GrownPointResult& end : station.points) {
      box.add({end.x[0], end.x[1]});
      longest = std::max(longest, end.a);
    }
  }
  const DrawingPoint middle{0.5 * (box.low.x + box.high.x), 0.5 * (box.low.y + box.high.y)};
  const double half = std::max(0.65 * std::max(box.width(), box.height()), 0.8 * longest);
  view.low = {middle.x - half, middle.y - half};
  view.high = {middle.x + half, middle.y + half};
}

/// The last mesh with the way that the tips took, K beside it.
std::vector<Figure> path_figures(const model::Model& model, const results::RunResult& run) {
  if (run.increments.empty() || run.increments.back().mesh.nodes.empty()) {
    return {};
  }
  const GrowthResult& growth = *run.growth;
  MeshView view;
  view.mesh = &run.increments.back().mesh;
  view.id = "growth-path";
  view.title = "Paths of the cracks";
  view.length = model.units.output_length();
  view.width = 560.0;
  set_window(view, growth);
  const base::OutputUnit K = model.units.output_stress_intensity();
  const double apart = label_room * (view.high.x - view.low.x);
  for (std::size_t t = 0; t < growth.point_names.size(); ++t) {
    std::optional<base::Vec3> last;
    for (const GrowthStation& station : growth.stations) {
      const results::GrownPointResult& tip = station.points[t];
      if (!last || (tip.x - *last).norm() >= apart) {
        view.labels.push_back(
            {{tip.x[0], tip.x[1]}, fmt::format("{:.4g}", K.from_deck(tip.K_max))});
        last = tip.x;
      }
    }
  }
  return {{{draw_svg(view)},
           "",
           fmt::format("The mesh at the last length that was solved, with places of "
                       "the tips. Numbers: K at the largest load there [{}].",
                       typeset_unit(K.name))}};
}

} // namespace

std::vector<Figure> growth_figures(const model::Model& model, const results::RunResult& run) {
  if (!run.growth || run.growth->stations.empty()) {
    return {};
  }
  const GrowthResult& growth = *run.growth;
  std::vector<Figure> figures{life_figure(model, run), range_figure(model, run)};
  add_figure(figures, growth_law_figure(model, run));
  add_figure(figures, exceedance_figure(model, growth));
  constexpr base::ByDimension grown{path_figures, beach_mark_figures};
  std::ranges::move(grown.at(model.mesh.dim)(model, run), std::back_inserter(figures));
  return figures;
}

} // namespace spricka::report
