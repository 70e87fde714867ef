// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/by_dimension.hpp"
#include "model/model.hpp"
#include "report/drawing/mesh_picture.hpp"
#include "report/drawing/picture_frame.hpp"
#include "report/drawing/plot.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/front_places.hpp"
#include "report/topics/front_section.hpp"
#include "report/topics/growth_tables.hpp"
#include "report/topics/load_path_tables.hpp"
#include "report/topics/result_rows.hpp"
#include "report/topics/result_tables.hpp"

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

/// A point whose growth is drawn, with the face that it lies on in its name.
struct ReportedGrowthPoint {
  std::size_t index = 0; ///< of point_names
  std::string name;
};

std::vector<ReportedGrowthPoint> reported_points(const results::RunResult& run) {
  const GrowthResult& growth = *run.growth;
  const std::vector<std::size_t> reported = reported_growth_points(growth);
  const bool some_are_left_out = reported.size() < growth.point_names.size();
  std::vector<ReportedGrowthPoint> points;
  for (const std::size_t i : reported) {
    std::string name = growth.point_names[i];
    const std::string face =
        some_are_left_out
            ? FaceNames(run.increments.front().mesh).at(growth.stations.front().points[i].x)
            : std::string();
    points.push_back({i, face.empty() ? name : fmt::format("{} at {}", name, face)});
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
void add_checks(Plot& plot, const model::Model& model) {
  PlotSeries marks = marker_series("reference", MarkerShape::plus);
  for (const model::ResultCheck& check : model.checks) {
    const double* const a = check.quantity == "N" && check.arguments.size() == 1
                                ? std::get_if<double>(&check.arguments[0])
                                : nullptr;
    if (a != nullptr) {
      marks.points.push_back({check.value, *a});
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
  Plot plot{fmt::format("K₁ over load path {} at a = {:.4g} {}", path.name, increment.a,
                        model.units.length_name),
            fmt::format("t, a = {:.4g} {}", increment.a, model.units.length_name),
            axis_title("K₁", model.units.stress_intensity_name()),
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
  const std::string units = growth.unit + (growth.unit == "pass" ? "es" : "s");
  Plot plot{"Crack length over " + units,
            axis_title("N", units),
            axis_title("a", model.units.length_name),
            {}};
  const std::vector<ReportedGrowthPoint> reported = reported_points(run);
  for (std::size_t t = 0; t < reported.size(); ++t) {
    add_life_curve(plot, growth, reported[t], t);
  }
  add_checks(plot, model);
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
              "Crack length over {}, {:.6g} in all{}. The growth ended: {}.{}", units,
              growth.final_cycles(),
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
            axis_title("a", model.units.length_name),
            axis_title("K", model.units.stress_intensity_name()),
            {}};
  const std::vector<ReportedGrowthPoint> reported = reported_points(run);
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

/// GrowthResult per cycle or pass over the range of K, as the law gave it at the stations: the part
/// of the law that was used.
std::optional<Figure> law_figure(const model::Model& model, const results::RunResult& run) {
  const GrowthResult& growth = *run.growth;
  const std::string unit = typeset_unit(model.units.stress_intensity_name());
  Plot plot{"Growth law over the range it was used in",
            axis_title("ΔK", model.units.stress_intensity_name()),
            axis_title("da/dN", model.units.length_name + "/" + growth.unit),
            {}};
  plot.log_x = true;
  plot.log_y = true;
  double low = std::numeric_limits<double>::max();
  double high = 0.0;
  const std::vector<ReportedGrowthPoint> reported = reported_points(run);
  for (std::size_t t = 0; t < reported.size(); ++t) {
    PlotSeries series = styled_curve(reported[t].name, t, 0);
    series.marker = palette_marker_shape(t);
    for (const GrowthStation& station : growth.stations) {
      const results::GrownPointResult& tip = station.points[reported[t].index];
      const double range = tip.K_max - tip.K_min;
      if (range > 0.0 && tip.rate > 0.0) {
        series.points.push_back({range, tip.rate});
        low = std::min(low, range);
        high = std::max(high, range);
      }
    }
    plot.series.push_back(std::move(series));
  }
  if (!(high > low)) {
    return std::nullopt;
  }
  return Figure{{draw_svg(plot)},
                "",
                fmt::format("Growth per {} from the law at the lengths that were solved, over ΔK = "
                            "K_max - K_min{}. The run used the law from {:.4g} to {:.4g} {}.",
                            growth.unit, growth.unit == "pass" ? " of the pass" : "", low, high,
                            unit)};
}

/// The least and the largest load of a cycle, and how often it comes.
struct Peak {
  double top = 0.0;
  double count = 0.0;
};

std::vector<Peak> peaks_of(const model::SpectrumDefinition& spectrum) {
  std::vector<Peak> peaks;
  for (const std::array<double, 3>& cycle : spectrum.cycles) {
    peaks.push_back({cycle[1], cycle[2]});
  }
  const std::vector<double>& t = spectrum.turning_points;
  for (std::size_t i = 0; i < t.size(); ++i) { // the pass is repeated: its ends meet
    const double before = t[(i + t.size() - 1) % t.size()];
    const double after = t[(i + 1) % t.size()];
    if (t[i] > before && t[i] >= after) {
      peaks.push_back({t[i], 1.0});
    }
  }
  std::ranges::sort(peaks, std::greater<>(), &Peak::top);
  return peaks;
}

/// Levels, falling, and how many reach them, as a curve of steps that begins at half a one.
std::vector<DrawingPoint> steps(const std::vector<std::array<double, 2>>& reached) {
  std::vector<DrawingPoint> points;
  double before = 0.5;
  for (const auto& [level, count] : reached) {
    points.push_back({std::min(before, count), level}); // a step, down and on
    points.push_back({count, level});
    before = count;
  }
  return points;
}

std::string_view counting_words(const model::SpectrumDefinition& spectrum) {
  return !spectrum.sequence ? ""
         : spectrum.counting == model::CycleCounting::pairs
             ? ", each valley with the peak behind it"
             : ", counted by rainflow on the loads";
}

/// How often one pass of the spectrum exceeds each load, and by cycles of which ranges; none of a
/// spectrum of one level, which there is nothing to show of.
std::optional<Figure> exceedance_figure(const model::Model& model, const GrowthResult& growth) {
  if (!model.growth->spectrum) {
    return std::nullopt;
  }
  const model::SpectrumDefinition& spectrum = model.spectra[*model.growth->spectrum];
  std::vector<std::array<double, 2>> reached;
  double sum = 0.0;
  for (const Peak& peak : peaks_of(spectrum)) {
    sum += peak.count;
    if (!reached.empty() && reached.back()[0] == peak.top) {
      reached.back()[1] = sum;
    } else {
      reached.push_back({peak.top, sum});
    }
  }
  if (reached.size() < 2 && growth.ranges.size() < 2) {
    return std::nullopt;
  }
  const std::string& path = model.load_paths[spectrum.path].name;
  const auto curve = [](const std::string& title, const std::string& x, const std::string& y,
                        const std::vector<std::array<double, 2>>& of) {
    PlotSeries series = styled_curve("", 0, 0);
    series.points = steps(of);
    Plot plot{title, x, y, {series}};
    plot.log_x = true;
    plot.legend_below = true; // beside each other
    return draw_svg(plot);
  };
  return Figure{{curve("Exceedances of the spectrum", "peaks in a pass that reach the load",
                       fmt::format("t of load path {}", path), reached),
                 curve("Ranges of the spectrum's cycles", "cycles in a pass of this range or more",
                       fmt::format("range of t of load path {}", path), growth.ranges)},
                "",
                fmt::format("Spectrum {}: how many of the {:.6g} peaks of a pass reach a load, and "
                            "how many of its {:.6g} cycles have a range{}.",
                            spectrum.name, sum, growth.cycles_per_pass, counting_words(spectrum))};
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
  view.length_name = model.units.length_name;
  view.width = 560.0;
  set_window(view, growth);
  const double apart = label_room * (view.high.x - view.low.x);
  for (std::size_t t = 0; t < growth.point_names.size(); ++t) {
    std::optional<base::Vec3> last;
    for (const GrowthStation& station : growth.stations) {
      const results::GrownPointResult& tip = station.points[t];
      if (!last || (tip.x - *last).norm() >= apart) {
        view.labels.push_back({{tip.x[0], tip.x[1]}, fmt::format("{:.4g}", tip.K_max)});
        last = tip.x;
      }
    }
  }
  return {{{draw_svg(view)},
           "",
           fmt::format("The mesh at the last length that was solved, with places of "
                       "the tips. Numbers: K at the largest load there [{}].",
                       typeset_unit(model.units.stress_intensity_name()))}};
}

} // namespace

std::vector<Figure> growth_figures(const model::Model& model, const results::RunResult& run) {
  if (!run.growth || run.growth->stations.empty()) {
    return {};
  }
  const GrowthResult& growth = *run.growth;
  std::vector<Figure> figures{life_figure(model, run), range_figure(model, run)};
  add_figure(figures, law_figure(model, run));
  add_figure(figures, exceedance_figure(model, growth));
  constexpr base::ByDimension grown{path_figures, beach_mark_figures};
  std::ranges::move(grown.at(model.mesh.dim)(model, run), std::back_inserter(figures));
  return figures;
}

} // namespace spricka::report
