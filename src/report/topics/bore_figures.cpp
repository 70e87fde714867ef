// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/colour_scale.hpp"
#include "report/drawing/plot.hpp"
#include "report/drawing/round_off.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/unrolled.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spricka::report {
namespace {

using std::numbers::pi;

constexpr double width = 560.0; // of the map [px]
constexpr double height = 130.0;
constexpr double left = 62.0;
constexpr double top = 26.0;
constexpr double bottom = 92.0;
constexpr double edge_level = 0.01; // of the largest pressure: where contact is drawn to end
constexpr int stations = 41;        // along the axis
constexpr std::size_t most_sizes = 5;

struct Seen {
  const results::ContactResult* contact = nullptr;
  std::string label; ///< its step, and of several crack sizes which
  UnrolledSurface surface;
};

bool is_consistent(const model::Contact& contact) {
  return contact.recovery == model::PressureRecovery::consistent;
}

// Adds what a step of an increment has of a contact, where it carries more than round-off.
void add_closed(std::vector<Seen>& all, const results::LoadStepResult* step,
                const model::Contact& contact, const std::string& label, double least_pressure) {
  const results::ContactResult* const result =
      step == nullptr ? nullptr : results::find_contact(*step, contact.name);
  if (result != nullptr && result->mounted && result->radius > 0.0 && result->closed > 0 &&
      result->max_pressure > least_pressure) {
    all.push_back({result, label, UnrolledSurface(*result, is_consistent(contact))});
  }
}

/// The steps of the last length.
std::vector<Seen> of_steps(const model::Model& model, const results::RunResult& run,
                           const model::Contact& contact) {
  const double least = least_contact_pressure(model, run);
  std::vector<Seen> all;
  for (const results::LoadStepResult& step : run.increments.back().steps) {
    add_closed(all, &step, contact, step.step, least);
  }
  return all;
}

/// The leading step as the crack grows.
std::vector<Seen> of_sizes(const model::Model& model, const results::RunResult& run,
                           const model::Contact& contact) {
  const std::string step = results::shown_step_name(model, run.increments);
  const double least = least_contact_pressure(model, run);
  std::vector<Seen> all;
  for (const results::CrackLengthResult* increment : sample_increments(run, most_sizes)) {
    add_closed(all, results::find_step(*increment, step), contact,
               fmt::format("{}, a = {}", step, model.units.output_length().text(increment->a, 4)),
               least);
  }
  return all;
}

/// The part of a triangle where pressure is at least (sign 1) or at most (sign -1) a level.
std::vector<UnrolledSurface::UnrolledCorner>
cut(const std::vector<UnrolledSurface::UnrolledCorner>& polygon, double level, double sign) {
  std::vector<UnrolledSurface::UnrolledCorner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const UnrolledSurface::UnrolledCorner& a = polygon[i];
    const UnrolledSurface::UnrolledCorner& b = polygon[(i + 1) % polygon.size()];
    const double at_a = sign * (a.p - level);
    const double at_b = sign * (b.p - level);
    if (at_a >= 0.0) {
      kept.push_back(a);
    }
    if ((at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0)) {
      const double t = at_a / (at_a - at_b);
      kept.push_back({{a.at.x + t * (b.at.x - a.at.x), a.at.y + t * (b.at.y - a.at.y)}, level});
    }
  }
  return kept;
}

class Map {
public:
  Map(const model::Model& model, const Seen& seen, std::string id)
      : model_(model), seen_(seen), surface_(seen.surface), id_(std::move(id)),
        svg_(left + width + 18.0, top + height + bottom,
             fmt::format("pressure of contact {} on the unrolled surface, step {}",
                         seen.contact->name, seen.label)) {}

  std::string draw(const ColourScale& scale) {
    svg_.text({left, 15.0}, fmt::format("{}, {}", seen_.contact->name, seen_.label),
              {.bold = true});
    svg_.clip(id_, {left, top}, width, height);
    for (const UnrolledSurface::Triangle& t : surface_.triangles()) {
      fill(t, scale);
    }
    for (const UnrolledSurface::Triangle& t : surface_.triangles()) {
      edge(t, edge_level * surface_.largest_pressure());
    }
    svg_.unclip();
    axes();
    draw_colour_legend(svg_, scale, {left + 0.25 * width, top + height + 46.0}, 0.5 * width,
                       legend_title("p", model_.units.output_stress()));
    return svg_.svg_text();
  }

private:
  [[nodiscard]] DrawingPoint place(DrawingPoint at) const {
    const double depth =
        std::max(surface_.highest_axial_position() - surface_.lowest_axial_position(), 1e-300);
    return {left + width * (at.x + pi) / (2.0 * pi),
            top + height * (surface_.highest_axial_position() - at.y) / depth};
  }

  void fill(const UnrolledSurface::Triangle& t, const ColourScale& scale) {
    const auto [low, high] = std::minmax({t[0].p, t[1].p, t[2].p});
    const double step = (scale.high - scale.low) / static_cast<double>(colour_bands);
    for (std::size_t band = scale.band_index(low); band <= scale.band_index(high); ++band) {
      std::vector<UnrolledSurface::UnrolledCorner> polygon(t.begin(), t.end());
      if (band > 0) {
        polygon = cut(polygon, scale.low + step * static_cast<double>(band), 1.0);
      }
      if (band + 1 < colour_bands) {
        polygon = cut(polygon, scale.low + step * static_cast<double>(band + 1), -1.0);
      }
      if (polygon.size() < 3) {
        continue;
      }
      std::vector<DrawingPoint> corners;
      corners.reserve(polygon.size());
      for (const UnrolledSurface::UnrolledCorner& corner : polygon) {
        corners.push_back(place(corner.at));
      }
      // a hair's line hides the gaps that rounding leaves between neighbours
      const std::string colour = band_colour(band);
      svg_.polygon(corners, {.stroke = colour, .width = 0.4, .fill = colour, .dash = {}});
    }
  }

  void edge(const UnrolledSurface::Triangle& t, double level) {
    std::vector<DrawingPoint> ends;
    for (std::size_t i = 0; i < 3; ++i) {
      const UnrolledSurface::UnrolledCorner& a = t[i];
      const UnrolledSurface::UnrolledCorner& b = t[(i + 1) % 3];
      if ((a.p > level) != (b.p > level)) {
        const double s = (level - a.p) / (b.p - a.p);
        ends.push_back(place({a.at.x + s * (b.at.x - a.at.x), a.at.y + s * (b.at.y - a.at.y)}));
      }
    }
    if (ends.size() == 2) {
      svg_.line(ends[0], ends[1], {.stroke = "#d00", .width = 1.4, .fill = "none", .dash = {}});
    }
  }

  void axes() {
    svg_.rectangle({left, top}, width, height, {});
    constexpr int turn = 45;
    for (int degrees = -180; degrees <= 180; degrees += turn) {
      const double x = place({degrees * pi / 180.0, surface_.lowest_axial_position()}).x;
      svg_.line({x, top + height}, {x, top + height + 4.0}, {});
      svg_.text({x, top + height + 17.0}, fmt::format("{}", degrees),
                {.anchor = TextAnchor::middle});
    }
    svg_.text({left + 0.5 * width, top + height + 33.0}, "θ  [deg]",
              {.anchor = TextAnchor::middle});
    const base::OutputUnit length = model_.units.output_length();
    for (const AxisTick& tick :
         round_axis_ticks(length.from_deck(surface_.lowest_axial_position()),
                          length.from_deck(surface_.highest_axial_position()), 4)) {
      const double y = place({0.0, length.to_deck(tick.value)}).y;
      svg_.line({left - 4.0, y}, {left, y}, {});
      svg_.text({left - 7.0, y + 4.0}, tick.text, {.anchor = TextAnchor::end});
    }
    svg_.text({16.0, top + 0.5 * height}, axis_title("along the axis", length).text,
              {.anchor = TextAnchor::middle, .angle = 90.0});
  }

  const model::Model& model_;
  const Seen& seen_;
  const UnrolledSurface& surface_;
  std::string id_;
  SvgDrawing svg_;
};

// Where colours begin: at 0, but surfaces that are pressed all over and much alike would have one.
ColourScale common_scale(const std::vector<Seen>& all) {
  double largest = 0.0;
  for (const Seen& seen : all) {
    largest = std::max(largest, seen.surface.largest_pressure());
  }
  double least = largest;
  for (const Seen& seen : all) {
    for (const UnrolledSurface::Triangle& t : seen.surface.triangles()) {
      least = std::min({least, t[0].p, t[1].p, t[2].p});
    }
  }
  return make_colour_scale(least > 0.5 * largest ? least : 0.0, largest);
}

/// Places along the axis: both ends and between them, or the middles of as many parts (inset 0.5).
std::vector<double> places_along(const UnrolledSurface& surface, double inset) {
  std::vector<double> places;
  for (int i = 0; i < stations; ++i) {
    const double t = (i + inset) / (stations - 1 + 2.0 * inset);
    places.push_back(surface.lowest_axial_position() +
                     t * (surface.highest_axial_position() - surface.lowest_axial_position()));
  }
  return places;
}

DrawingPoint total_push(const UnrolledSurface& surface) {
  DrawingPoint sum;
  for (const double along : places_along(surface, 0.5)) {
    const DrawingPoint push = surface.line_force_at_axial_position(along);
    sum.x += push.x / stations;
    sum.y += push.y / stations;
  }
  return sum;
}

/// Pressure along the axis at the angle the surface is pushed to and beside it.
std::string depth_plot(const model::Model& model, const Seen& seen) {
  const UnrolledSurface& surface = seen.surface;
  const DrawingPoint push = total_push(surface);
  const double even =
      1e-3 * seen.contact->radius * surface.largest_pressure(); // pressed alike all round
  const double middle = std::hypot(push.x, push.y) > even ? std::atan2(push.y, push.x) : 0.0;
  Plot plot{fmt::format("{}, {}: pressure along the axis", seen.contact->name, seen.label),
            axis_title("along the axis", model.units.output_length()),
            axis_title("p", model.units.output_stress()),
            {}};
  constexpr std::array<int, 5> beside{0, 45, 90, 135, 180};
  for (std::size_t k = 0; k < beside.size(); ++k) {
    const double angle = std::remainder(middle + beside[k] * pi / 180.0, 2.0 * pi);
    PlotSeries series = styled_curve(fmt::format("θ = {:.0f}°", angle * 180.0 / pi), k, k);
    double most = 0.0;
    for (const double along : places_along(surface, 0.0)) {
      if (const std::optional<double> p = surface.pressure_at({angle, along})) {
        series.points.push_back({along, *p});
        most = std::max(most, *p);
      }
    }
    if (most > 0.0) {
      plot.series.push_back(std::move(series));
    }
  }
  return plot.series.empty() ? std::string() : draw_svg(plot);
}

/// What pushes the surface for a unit of length along the axis, in the direction of the whole.
std::string force_plot(const model::Model& model, const std::vector<Seen>& all,
                       const model::Contact& contact) {
  Plot plot{fmt::format("{}: force along the axis", contact.name),
            axis_title("along the axis", model.units.output_length()),
            axis_title("force per length",
                       base::output_unit(model.units, base::QuantityKind::energy_release)),
            {}};
  for (std::size_t s = 0; s < all.size(); ++s) {
    const UnrolledSurface& surface = all[s].surface;
    const DrawingPoint push = total_push(surface);
    const double size = std::hypot(push.x, push.y);
    if (!(size > 1e-3 * all[s].contact->radius * surface.largest_pressure())) {
      continue; // pressed alike all round
    }
    PlotSeries series = styled_curve(all[s].label, s, s);
    for (const double along : places_along(surface, 0.0)) {
      const DrawingPoint here = surface.line_force_at_axial_position(along);
      series.points.push_back({along, (here.x * push.x + here.y * push.y) / size});
    }
    plot.series.push_back(std::move(series));
  }
  return plot.series.empty() ? std::string() : draw_svg(plot);
}

} // namespace

std::optional<Figure> unrolled_pressure_figure(const model::Model& model,
                                               const results::RunResult& run,
                                               const model::Contact& contact) {
  if (run.increments.empty()) {
    return std::nullopt;
  }
  Figure figure;
  int drawn = 0;
  const auto draw_maps = [&](const std::vector<Seen>& views, const ColourScale& scale) {
    for (const Seen& seen : views) {
      figure.drawings.push_back(
          Map(model, seen, fmt::format("bore-{}-{}", contact.name, drawn++)).draw(scale));
    }
  };
  const std::vector<Seen> steps = of_steps(model, run, contact);
  if (steps.empty()) {
    return std::nullopt;
  }
  // The leading step of several sizes in the same colours, other steps at the last size.
  const std::vector<Seen> sizes =
      run.increments.size() > 1 ? of_sizes(model, run, contact) : std::vector<Seen>();
  const std::vector<Seen>& shown = sizes.empty() ? steps : sizes;
  if (!sizes.empty()) {
    draw_maps(sizes, common_scale(sizes));
  }
  for (const Seen& seen : steps) {
    if (sizes.empty() || seen.label != results::shown_step_name(model, run.increments)) {
      draw_maps({seen}, common_scale({seen}));
    }
  }
  for (std::string plot : {depth_plot(model, shown.back()), force_plot(model, shown, contact)}) {
    if (!plot.empty()) {
      figure.drawings.push_back(std::move(plot));
    }
  }
  figure.caption = fmt::format(
      "Pressure of contact {} on its surface ({} recovery), unrolled round the axis{}. Across: the "
      "angle; up: "
      "the place along the axis. Red: where contact ends; white: there is no surface opposite. "
      "Below: the pressure of {} along the axis at some angles, and for each {} the contact force "
      "per unit length in the direction of the total force.",
      contact.name, pressure_recovery_word(contact), sizes.empty() ? "" : ", as the crack grows",
      shown.back().label, sizes.empty() ? "step" : "size");
  return figure;
}

} // namespace spricka::report
