// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/front_section.hpp"

#include "model/model.hpp"
#include "report/drawing/crack_picture.hpp"
#include "report/drawing/plot.hpp"
#include "report/topics/k_bars.hpp"
#include "report/topics/result_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace spricka::report {
namespace {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

constexpr double nothing_beside = 5e-3; // of the largest K: not worth a curve

double largest_K(const results::FrontResult& front) {
  double largest = 0.0;
  for (const results::FrontPointResult& place : front.points) {
    largest = std::max({largest, std::abs(place.K1), std::abs(place.K2), std::abs(place.K3)});
  }
  return largest;
}

/// Of all fronts and steps of an increment.
double largest_K(const results::Increment& increment) {
  double largest = 0.0;
  for (const results::StepResult& step : increment.steps) {
    for (const results::FrontResult& front : step.fronts) {
      largest = std::max(largest, largest_K(front));
    }
  }
  return largest;
}

bool shows(const results::FrontQuantity& q, const results::FrontResult& front) {
  return q.listed && (q.given == nullptr || q.given(front));
}

constexpr std::array front_modes{&results::FrontPointResult::K1, &results::FrontPointResult::K2,
                                 &results::FrontPointResult::K3};

std::string front_cell(const results::FrontQuantity& q, const results::FrontPointResult& place,
                       double scale) {
  const double value = q.extract_value(place);
  switch (q.kind) {
  case base::Quantity::angle:
    return fmt::format("{:.2f}", std::round(value * degrees_per_radian * 100.0) / 100.0 + 0.0);
  case base::Quantity::number:
    return fmt::format("{:.2g}", value);
  case base::Quantity::stress_intensity:
    return std::abs(value) < 1e-9 * scale ? "0" : six_digits(value);
  default:
    return six_digits(value);
  }
}

/// Which K a column is.
std::optional<std::size_t> mode_of(const results::FrontQuantity& q) {
  const auto found = std::ranges::find(front_modes, q.member);
  return found == front_modes.end()
             ? std::nullopt
             : std::optional<std::size_t>(std::distance(front_modes.begin(), found));
}

ReportTable front_table(const model::Model& model, const results::Increment& increment,
                        const results::FrontResult& first) {
  ReportTable table{fmt::format("Stress intensity factors along the front of {}", first.name),
                    {{"step", "", true}, {"point", "", false}},
                    {}};
  for (const results::FrontQuantity& q : results::front_quantities) {
    if (shows(q, first)) {
      const bool angle = q.kind == base::Quantity::angle;
      const std::string unit = angle ? "deg" : base::unit_name(model.units, q.kind);
      table.columns.push_back({q.name, unit, false});
      if (mode_of(q) && first.no_bar.empty()) {
        table.columns.push_back({fmt::format("+- {}", q.name), unit, false});
      }
    }
  }
  table.columns.push_back({"", "", true});
  const double scale = largest_K(increment);
  for (const results::StepResult& step : increment.steps) {
    for (const results::FrontResult& front : step.fronts) {
      if (front.name != first.name || largest_K(front) <= 1e-9 * scale) {
        continue;
      }
      for (const results::FrontPointResult& place : front.points) {
        std::vector<std::string> row{step.step, std::to_string(place.number)};
        for (const results::FrontQuantity& q : results::front_quantities) {
          if (shows(q, front)) {
            row.push_back(front_cell(q, place, scale));
            if (mode_of(q) && first.no_bar.empty()) {
              const bool given = front.no_bar.empty() && !place.at_surface;
              row.push_back(given ? format_error_bar(place.bar[*mode_of(q)].size()) : "");
            }
          }
        }
        row.emplace_back(place.at_surface ? "surface" : place.closed ? "closed" : "");
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

/// Where each point stands on the axis: its length along the front, or its angle, ascending and
/// from -180 degrees on where a whole turn does not fit in.
std::vector<double> abscissas(const results::FrontResult& front) {
  std::vector<double> at;
  for (const results::FrontPointResult& place : front.points) {
    if (!front.angles) {
      at.push_back(place.s);
      continue;
    }
    const double phi = place.phi * degrees_per_radian;
    // Angles go on over half a turn.
    at.push_back(at.empty() ? phi : at.back() + std::remainder(phi - at.back(), 360.0));
  }
  if (front.angles && !at.empty()) {
    const double low = *std::ranges::min_element(at);
    const double turns =
        front.closed ? std::ceil(-low / 360.0 - 1e-9) : std::ceil((-180.0 - low) / 360.0 - 1e-9);
    std::ranges::for_each(at, [&](double& phi) { phi += 360.0 * turns; });
  }
  return at;
}

/// A mode over them; points on the surface are left out, as K there is a number of the mesh.
struct FrontKCurve {
  std::vector<DrawingPoint> points;
  std::vector<double> bars; ///< empty: there are none
};
FrontKCurve curve_along(const results::FrontResult& front, std::size_t mode) {
  const std::vector<double> at = abscissas(front);
  std::vector<std::pair<DrawingPoint, double>> points;
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const results::FrontPointResult& place = front.points[i];
    if (!place.at_surface) {
      points.push_back({{at[i], place.*front_modes[mode]}, place.bar[mode].size()});
    }
  }
  std::ranges::sort(points, {}, [](const auto& p) { return p.first.x; });
  if (front.closed && !points.empty()) { // once round
    const double round = front.angles ? 360.0 : front.length;
    points.push_back(points.front());
    points.back().first.x += round;
  }
  FrontKCurve curve;
  for (const auto& [point, bar] : points) {
    curve.points.push_back(point);
    if (front.no_bar.empty()) {
      curve.bars.push_back(bar);
    }
  }
  return curve;
}

/// The front in its body and the opened crack, at the end of the leading step.
std::optional<Figure> crack_pictures(const model::Model& model, const results::Increment& increment,
                                     const std::string& name) {
  const results::StepResult* const leading = results::find_step(increment, leading_step(model));
  const results::StepResult& step = leading != nullptr ? *leading : increment.steps.back();
  const auto front = std::ranges::find(step.fronts, name, &results::FrontResult::name);
  if (front == step.fronts.end() || increment.surface.size() > most_drawn_faces) {
    return std::nullopt;
  }
  CrackView view;
  view.increment = &increment;
  view.step = &step;
  view.front = &*front;
  view.k_name = typeset_unit(model.units.stress_intensity_name());
  view.length_name = model.units.length_name;
  Figure figure;
  for (const std::string& drawing : {draw_front(view), draw_opening(view)}) {
    if (!drawing.empty()) {
      figure.drawings.push_back(drawing);
    }
  }
  if (figure.drawings.empty()) {
    return std::nullopt;
  }
  figure.caption = fmt::format(
      "Crack {} at the end of step {}: its front in the body (other bodies are left out), and its "
      "upper face seen along the normal. Colours of the face: how far the two faces have moved "
      "apart or along each other. Circles: the points of the front.",
      name, step.step);
  return figure;
}

std::vector<const results::FrontResult*> first_of_each(const results::Increment& increment) {
  std::vector<const results::FrontResult*> fronts;
  for (const results::StepResult& step : increment.steps) {
    for (const results::FrontResult& front : step.fronts) {
      if (std::ranges::none_of(fronts, [&](const auto* f) { return f->name == front.name; })) {
        fronts.push_back(&front);
      }
    }
  }
  return fronts;
}

} // namespace

std::vector<ReportTable> front_tables(const model::Model& model,
                                      const results::Increment& increment) {
  std::vector<ReportTable> tables;
  for (const results::FrontResult* front : first_of_each(increment)) {
    tables.push_back(front_table(model, increment, *front));
  }
  return tables;
}

Figure front_figure(const model::Model& model, const results::Increment& increment,
                    const std::string& name) {
  const double scale = largest_K(increment);
  Plot plot;
  plot.label = fmt::format("stress intensity factors along the front of {}", name);
  plot.y_name = fmt::format("K, {}", typeset_unit(model.units.stress_intensity_name()));
  plot.legend_below = true;
  double a = 0.0;
  std::size_t ink = 0;
  for (const results::StepResult& step : increment.steps) {
    for (const results::FrontResult& front : step.fronts) {
      if (front.name != name || largest_K(front) <= 1e-9 * scale) {
        continue;
      }
      a = front.a;
      plot.x_name = front.angles
                        ? "angle φ along the front, degrees"
                        : fmt::format("length along the front, {}", model.units.length_name);
      for (std::size_t mode = 0; mode < front_modes.size(); ++mode) {
        PlotSeries series;
        FrontKCurve curve = curve_along(front, mode);
        series.points = std::move(curve.points);
        series.bars = std::move(curve.bars);
        const bool nothing = std::ranges::all_of(series.points, [&](const DrawingPoint& p) {
          return std::abs(p.y) < nothing_beside * scale;
        });
        if (mode > 0 && nothing) {
          continue; // an axis already
        }
        series.name = fmt::format("{}: K{}", step.step, mode + 1);
        series.colour = palette_colour(ink);
        series.dash = dash_pattern(mode);
        plot.series.push_back(std::move(series));
      }
      ++ink;
    }
  }
  return {{draw_svg(plot)},
          "",
          fmt::format("K along the front of {}, a = {:.4g} {}. Points where the front leaves the "
                      "body are left out: K there depends on the mesh.",
                      name, a, model.units.length_name)};
}

std::vector<Figure> front_figures(const model::Model& model, const results::RunResult& run) {
  std::vector<Figure> figures;
  if (run.increments.empty()) {
    return figures;
  }
  for (const results::FrontResult* front : first_of_each(run.increments.back())) {
    figures.push_back(front_figure(model, run.increments.back(), front->name));
    if (std::optional<Figure> figure = crack_pictures(model, run.increments.back(), front->name)) {
      figures.push_back(std::move(*figure));
    }
  }
  return figures;
}

} // namespace spricka::report
