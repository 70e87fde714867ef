// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/front_section.hpp"

#include "model/model.hpp"
#include "report/drawing/beach_marks.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/crack_picture.hpp"
#include "report/drawing/joint_picture.hpp"
#include "report/drawing/plot.hpp"
#include "report/topics/front_places.hpp"
#include "report/topics/result_rows.hpp"
#include "results/result_unit.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace spricka::report {
namespace {

constexpr double nothing_beside = 5e-3; // of the largest K: not worth a curve

constexpr std::array front_modes{&results::FrontPointResult::K1, &results::FrontPointResult::K2,
                                 &results::FrontPointResult::K3};

/// Where each point stands on the axis: its length along the front, or its angle, ascending and
/// from -180 degrees on where a whole turn does not fit in.
std::vector<double> abscissas(const results::FrontResult& front) {
  std::vector<double> at;
  for (const results::FrontPointResult& place : front.points) {
    if (!front.has_angles) {
      at.push_back(place.s);
      continue;
    }
    const double phi = place.phi * degrees_per_radian;
    // Angles go on over half a turn.
    at.push_back(at.empty() ? phi : at.back() + std::remainder(phi - at.back(), 360.0));
  }
  if (front.has_angles && !at.empty()) {
    const double low = *std::ranges::min_element(at);
    const double turns =
        front.is_loop ? std::ceil(-low / 360.0 - 1e-9) : std::ceil((-180.0 - low) / 360.0 - 1e-9);
    std::ranges::for_each(at, [&](double& phi) { phi += 360.0 * turns; });
  }
  return at;
}

/// A mode over them; points on the surface are left out, as K there is a number of the mesh.
PlotSeries curve_along(const results::FrontResult& front, std::size_t mode) {
  const std::vector<double> at = abscissas(front);
  std::vector<std::pair<DrawingPoint, double>> points;
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const results::FrontPointResult& place = front.points[i];
    if (!place.at_surface) {
      points.push_back({{at[i], place.*front_modes[mode]}, place.bar[mode].size()});
    }
  }
  std::ranges::sort(points, {}, [](const auto& p) { return p.first.x; });
  if (front.is_loop && !points.empty()) { // once round
    const double round = front.has_angles ? 360.0 : front.length;
    points.push_back(points.front());
    points.back().first.x += round;
  }
  PlotSeries curve;
  for (const auto& [point, bar] : points) {
    curve.points.push_back(point);
    if (front.has_error_bar()) {
      curve.bars.push_back(bar);
    }
  }
  return curve;
}

// The fronts of a crack in a solution; those of all steps lie at the same places.
std::vector<std::vector<base::Vec3>> fronts_of(const results::CrackLengthResult& increment,
                                               const std::string& crack) {
  std::vector<std::vector<base::Vec3>> fronts;
  if (increment.steps.empty()) {
    return fronts;
  }
  for (const results::FrontResult& front : increment.steps.front().fronts) {
    if (front.name != crack && !front.name.starts_with(crack + ".")) {
      continue;
    }
    std::vector<base::Vec3>& points = fronts.emplace_back();
    for (const results::FrontPointResult& place : front.points) {
      points.push_back(place.x);
    }
    if (front.is_loop && !points.empty()) {
      points.push_back(points.front());
    }
  }
  return fronts;
}

/// The front in its body and the opened crack, at the end of the shown step.
std::optional<Figure> crack_pictures(const model::Model& model, const results::RunResult& run,
                                     const std::string& name) {
  const results::CrackLengthResult& increment = run.increments.back();
  const results::LoadStepResult& step =
      *results::shown_step_result(model, run.increments, increment);
  const auto front = std::ranges::find(step.fronts, name, &results::FrontResult::name);
  if (front == step.fronts.end() || increment.surface.size() > most_drawn_faces) {
    return std::nullopt;
  }
  CrackView view;
  view.increment = &increment;
  view.step = &step;
  view.front = &*front;
  view.length = model.units.output_length();
  JointView body;
  body.increment = &increment;
  body.step = &step;
  body.fronts = {&*front};
  body.is_close = true;
  body.marks = &model;
  for (const FrontPlace& place : front_places(*front, FaceNames(increment.mesh))) {
    body.labels.emplace_back(place.point->x, place.name);
  }
  body.id = fmt::format("front-{}", name);
  body.title = fmt::format("{} in its body", name);
  body.k_title = legend_title("K1", model.units.output_stress_intensity());
  Figure figure;
  for (const std::string& drawing : {draw_svg(body), draw_crack_opening(view)}) {
    if (!drawing.empty()) {
      figure.drawings.push_back(drawing);
    }
  }
  if (figure.drawings.empty()) {
    return std::nullopt;
  }
  figure.caption = fmt::format(
      "Crack {} at the end of step {}: its front and its face, which show through the body (other "
      "bodies are left out; arrows and triangles: loads and supports), and its upper face seen "
      "along the normal. Colours of the face: how far the two faces have moved apart or along each "
      "other. Circles: the points of the front.",
      name, step.step);
  return figure;
}

} // namespace

Figure k_along_front_figure(const model::Model& model, const results::CrackLengthResult& increment,
                            const std::string& name) {
  const double scale = largest_K(increment);
  Plot plot;
  plot.label = fmt::format("stress intensity factors along the front of {}", name);
  plot.y_name = legend_title("K", model.units.output_stress_intensity());
  plot.legend_below = true;
  double a = 0.0;
  std::size_t ink = 0;
  for (const auto& [of, step, front] : front_rows({&increment, 1})) {
    if (front.name != name || largest_K(front) <= 1e-9 * scale) {
      continue;
    }
    a = front.a;
    plot.x_name = front.has_angles
                      ? "angle φ along the front, degrees"
                      : legend_title("length along the front", model.units.output_length());
    for (std::size_t mode = 0; mode < front_modes.size(); ++mode) {
      PlotSeries series = curve_along(front, mode);
      const bool nothing = std::ranges::all_of(series.points, [&](const DrawingPoint& p) {
        return std::abs(p.y) < nothing_beside * scale;
      });
      if (mode == 0 || !nothing) { // else an axis already
        series.name = fmt::format("{}: K{}", step.step, mode + 1);
        series.colour = palette_colour(ink);
        series.dash = dash_pattern(mode);
        plot.series.push_back(std::move(series));
      }
    }
    ++ink;
  }
  return {{draw_svg(plot)},
          "",
          fmt::format("K along the front of {}, a = {}. Points where the front leaves the "
                      "body are left out: K there depends on the mesh.",
                      name, model.units.output_length().text(a, 4))};
}

std::vector<Figure> k_along_front_figures(const model::Model& model,
                                          const results::RunResult& run) {
  std::vector<Figure> figures;
  if (run.increments.empty()) {
    return figures;
  }
  for (const results::FrontResult* front : find_fronts_in_space(run.increments.back())) {
    figures.push_back(k_along_front_figure(model, run.increments.back(), front->name));
    add_figure(figures, crack_pictures(model, run, front->name));
  }
  return figures;
}

std::vector<Figure> beach_mark_figures(const model::Model& model, const results::RunResult& run) {
  std::vector<Figure> figures;
  if (!run.growth) {
    return figures;
  }
  const base::OutputUnit life = results::life_unit(model.units, *run.growth);
  const std::vector<results::GrowthStation>& stations = run.growth->stations;
  for (const model::CrackDefinition& crack : model.cracks) {
    BeachMarkView view;
    view.title = fmt::format("Fronts of {}", crack.name);
    view.right = crack.plane.along;
    view.up = crack.plane.transverse_axis();
    view.length = model.units.output_length();
    for (std::size_t i = 0; i < std::min(stations.size(), run.increments.size()); ++i) {
      BeachMark mark{.fronts = fronts_of(run.increments[i], crack.name),
                     .cycles = life.from_deck(stations[i].cycles)};
      if (!mark.fronts.empty()) {
        view.marks.push_back(std::move(mark));
      }
    }
    if (view.marks.size() < 2) {
      continue;
    }
    figures.push_back({{draw_svg(view)},
                       "",
                       fmt::format("Where the front of {} was solved, seen along the crack's "
                                   "normal; N in {}.",
                                   crack.name, results::life_unit_words(life.name))});
  }
  return figures;
}

} // namespace spricka::report
