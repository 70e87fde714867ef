// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/plot.hpp"
#include "report/drawing/round_off.hpp"
#include "report/topics/dimension_columns.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/result_rows.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace spricka::report {
namespace {

using results::ContactPoint;

double turn(const ContactPoint& from, const ContactPoint& to) {
  return std::abs(std::remainder(to.theta - from.theta, 2.0 * std::numbers::pi));
}

/// A circle, or so much of one that a polar plot shows more than a needle.
bool on_bore(const results::ContactResult& contact) {
  double round = 0.0;
  for (std::size_t i = 1; i < contact.points.size(); ++i) {
    round += turn(contact.points[i - 1], contact.points[i]);
  }
  return contact.round && round > 0.5 * std::numbers::pi;
}

double typical_turn(const std::vector<ContactPoint>& points) {
  std::vector<double> turns;
  for (std::size_t i = 1; i < points.size(); ++i) {
    turns.push_back(turn(points[i - 1], points[i]));
  }
  if (turns.empty()) {
    return 0.0;
  }
  std::nth_element(turns.begin(), turns.begin() + static_cast<std::ptrdiff_t>(turns.size() / 2),
                   turns.end());
  return turns[turns.size() / 2];
}

/// Cuts the curve between the crack faces of a mouth and between chains; joins the ends of a full
/// circle.
std::vector<std::vector<DrawingPoint>> pieces(const model::Contact& contact,
                                              const std::vector<ContactPoint>& points) {
  std::vector<std::vector<DrawingPoint>> out;
  const double far = 6.0 * typical_turn(points);
  const auto joined = [&](const ContactPoint& a, const ContactPoint& b) {
    return !(a.crack_face != 0 && b.crack_face != 0) && turn(a, b) <= far;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == 0 || !joined(points[i - 1], points[i])) {
      out.emplace_back();
    }
    out.back().push_back({points[i].theta, recovered_pressure(contact, points[i])});
  }
  if (points.size() > 2 && joined(points.back(), points.front())) {
    out.back().push_back({points.front().theta, recovered_pressure(contact, points.front())});
  }
  return out;
}

bool has_pressure(const results::ContactResult& contact) {
  return contact.mounted && !contact.points.empty();
}

const results::ContactResult* mounted(const results::LoadStepResult& step,
                                      const std::string& name) {
  const results::ContactResult* const found = results::find_contact(step, name);
  return found != nullptr && has_pressure(*found) ? found : nullptr;
}

/// What the steps of a run have of a contact that is mounted.
std::vector<ContactRow> mounted_rows(const results::RunResult& run, const std::string& name) {
  std::vector<ContactRow> rows;
  std::ranges::copy_if(
      contact_rows(run.increments), std::back_inserter(rows),
      [&](const ContactRow& row) { return row.contact.name == name && has_pressure(row.contact); });
  return rows;
}

constexpr double near_mouth = std::numbers::pi / 18.0; ///< ten degrees

std::vector<ContactPoint> mouths_of(const results::ContactResult& result) {
  std::vector<ContactPoint> mouths;
  std::ranges::copy_if(result.points, std::back_inserter(mouths),
                       [](const ContactPoint& point) { return point.crack_face != 0; });
  return mouths;
}

bool is_near_mouth(const std::vector<ContactPoint>& mouths, const ContactPoint& point) {
  return std::ranges::any_of(mouths,
                             [&](const ContactPoint& m) { return turn(m, point) < near_mouth; });
}

/// The pressures a plot must show. Those next to a mouth are left out: they have no bound.
void widen(PolarPlot& plot, const model::Contact& contact, const results::ContactResult& result) {
  const std::vector<ContactPoint> mouths = mouths_of(result);
  for (const ContactPoint& point : result.points) {
    if (!is_near_mouth(mouths, point)) {
      plot.low = std::min(plot.low, recovered_pressure(contact, point));
      plot.high = std::max(plot.high, recovered_pressure(contact, point));
    }
  }
}

/// Whether the contact carries more than round-off at the end of the step.
bool is_pressed(const results::ContactResult& contact, double least_pressure) {
  return std::max(std::abs(contact.max_pressure), std::abs(contact.min_pressure)) > least_pressure;
}

PolarPlot polar_plot(const model::Model& model, const results::RunResult& run,
                     const model::Contact& contact, const results::CrackLengthResult& increment) {
  const double least_pressure = least_contact_pressure(model, run);
  PolarPlot plot;
  plot.title = model.cracks.empty() ? contact.name
                                    : fmt::format("{}, a = {}", contact.name,
                                                  model.units.output_length().text(increment.a, 4));
  plot.unit = model.units.output_stress();
  const std::string first = results::shown_step_name(model, run.increments);
  std::size_t others = 0; // their dashes show where curves lie on each other
  for (std::size_t s = 0; s < model.steps.size(); ++s) {
    const std::string& name = model.steps[s].name;
    const results::LoadStepResult* const step = results::find_step(increment, name);
    const results::ContactResult* const result =
        step == nullptr ? nullptr : mounted(*step, contact.name);
    if (result == nullptr || !is_pressed(*result, least_pressure)) {
      continue;
    }
    plot.curves.push_back({name, std::string(palette_colour(s)),
                           std::string(dash_pattern(name == first ? 0 : others++)),
                           pieces(contact, result->points), name == first});
    plot.mouths.clear();
    for (const ContactPoint& point : result->points) {
      if (point.crack_face > 0) {
        plot.mouths.push_back(point.theta);
      }
    }
  }
  return plot;
}

Figure polar_figure(const model::Model& model, const results::RunResult& run,
                    const model::Contact& contact) {
  // One scale for all, so that lengths can be compared.
  PolarPlot range;
  range.high = 0.0;
  for (const ContactRow& row : mounted_rows(run, contact.name)) {
    widen(range, contact, row.contact);
  }
  Figure figure;
  bool mouths = false;
  for (const results::CrackLengthResult* const increment : sample_increments(run, 9)) {
    PolarPlot plot = polar_plot(model, run, contact, *increment);
    if (plot.curves.empty()) {
      continue;
    }
    mouths = mouths || !plot.mouths.empty();
    plot.low = range.low;
    plot.high = range.high > 0.0 ? 1.05 * range.high : 1.0;
    figure.drawings.push_back(draw_svg(plot));
    figure.legend = draw_legend(plot.curves);
  }
  figure.caption = fmt::format(
      "Pressure of contact {} at the ends of the steps, drawn outward from the circle of the bore "
      "({} recovery; θ from +x){}.{}",
      contact.name, pressure_recovery_word(contact),
      range.low < -0.02 * range.high ? "; inside the circle: tension" : "",
      mouths ? " Radial bars: crack mouths; there the pressure has no bound, and the curves are "
               "cut a little above the largest value more than 10° away."
             : "");
  return figure;
}

/// Next to an edge the pressure has no bound: a twentieth of the part in contact is left out.
bool at_edge(const results::ContactResult& contact, const ContactPoint& point) {
  if (contact.unbounded.empty()) {
    return false;
  }
  double length = 0.0; // of the surface's closed part
  for (std::size_t i = 1; i < contact.points.size(); ++i) {
    const ContactPoint& a = contact.points[i - 1];
    const ContactPoint& b = contact.points[i];
    length += a.closed && b.closed && b.arc > a.arc ? b.arc - a.arc : 0.0;
  }
  return std::any_of(contact.unbounded.begin(), contact.unbounded.end(),
                     [&](const base::Vec3& x) { return (x - point.x).norm() < 0.05 * length; });
}

Figure straight_figure(const model::Model& model, const results::RunResult& run,
                       const model::Contact& contact) {
  Figure figure;
  bool edges = false;
  for (const results::CrackLengthResult* const increment : sample_increments(run, 9)) {
    Plot plot{contact.name,
              axis_title("distance along the surface", model.units.output_length()),
              axis_title("p", model.units.output_stress()),
              {}};
    for (std::size_t s = 0; s < increment->steps.size(); ++s) {
      const results::LoadStepResult& step = increment->steps[s];
      const results::ContactResult* const result = mounted(step, contact.name);
      if (result == nullptr || !is_pressed(*result, least_contact_pressure(model, run))) {
        continue;
      }
      PlotSeries series = styled_curve(step.step, s, s);
      for (const ContactPoint& point : result->points) {
        if (!at_edge(*result, point)) {
          series.points.push_back({point.arc, recovered_pressure(contact, point)});
        }
      }
      edges = edges || !result->unbounded.empty();
      plot.series.push_back(series);
    }
    if (!plot.series.empty()) {
      figure.drawings.push_back(draw_svg(plot));
    }
  }
  figure.caption =
      fmt::format("Pressure of contact {} at the ends of the steps ({} recovery).{}", contact.name,
                  pressure_recovery_word(contact),
                  edges ? " Where contact reaches an edge of the surface, the values next to that "
                          "edge are left out: the pressure has no bound there."
                        : "");
  return figure;
}

Figure figure_of_contact(const model::Model& model, const results::RunResult& run,
                         const model::Contact& contact) {
  if (!dimension_columns.at(model.mesh.dim).arcs) {
    return unrolled_pressure_figure(model, run, contact).value_or(Figure());
  }
  const bool bore = std::ranges::any_of(mounted_rows(run, contact.name),
                                        [](const ContactRow& row) { return on_bore(row.contact); });
  return bore ? polar_figure(model, run, contact) : straight_figure(model, run, contact);
}

} // namespace

std::vector<model::Contact> shown_contacts(const model::Model& model,
                                           const results::RunResult& run) {
  std::vector<model::Contact> shown = model.contacts;
  for (const ContactRow& row : contact_rows(run.increments)) {
    if (std::ranges::find(shown, row.contact.name, &model::Contact::name) == shown.end()) {
      shown.emplace_back().name = row.contact.name;
    }
  }
  return shown;
}

const results::ContactPoint* find_peak_pressure(const model::Contact& contact,
                                                const results::ContactResult& result) {
  const std::vector<ContactPoint> mouths = mouths_of(result);
  const ContactPoint* peak = nullptr;
  for (const ContactPoint& point : result.points) {
    const bool unbounded =
        is_near_mouth(mouths, point) || (!result.space && at_edge(result, point));
    if (!unbounded && (peak == nullptr ||
                       recovered_pressure(contact, point) > recovered_pressure(contact, *peak))) {
      peak = &point;
    }
  }
  return peak;
}

double recovered_pressure(const model::Contact& contact, const results::ContactPoint& point) {
  return contact.recovery == model::PressureRecovery::consistent ? point.p_consistent
                                                                 : point.p_lumped;
}

const char* pressure_recovery_word(const model::Contact& contact) {
  return contact.recovery == model::PressureRecovery::consistent ? "consistent" : "lumped";
}

std::vector<Figure> pressure_figures(const model::Model& model, const results::RunResult& run) {
  std::vector<Figure> figures;
  for (const model::Contact& contact : shown_contacts(model, run)) {
    if (Figure figure = figure_of_contact(model, run, contact); !figure.drawings.empty()) {
      figures.push_back(std::move(figure));
    }
  }
  return figures;
}

} // namespace spricka::report
