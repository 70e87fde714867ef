// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spricka::report {
namespace {

constexpr double size = 310.0;
constexpr double outer = 118.0; ///< radius of the largest pressure shown
constexpr double innermost = 10.0;
constexpr double pi = std::numbers::pi;

/// Pixels from the centre: a pressure's radius.
struct PolarScale {
  double bore = 0.0;
  double per_pressure = 0.0;
  double operator()(double pressure) const { return bore + per_pressure * pressure; }
};

/// The bore takes two fifths of the radius, more only where tension needs room inside it.
PolarScale scale_of(const PolarPlot& plot) {
  const double high = std::max(plot.high, 1e-300);
  const double low = std::min(plot.low, 0.0);
  const double room = innermost + (outer - innermost) * -low / (high - low);
  PolarScale scale;
  scale.bore = std::max(0.4 * outer, room);
  scale.per_pressure = (outer - scale.bore) / high;
  return scale;
}

DrawingPoint at(double radius, double theta) {
  return {0.5 * size + radius * std::cos(theta), 0.5 * size + 8.0 - radius * std::sin(theta)};
}

void draw_circles(SvgDrawing& svg, const PolarPlot& plot, const PolarScale& scale) {
  const ShapeStyle grid{"#ccc", 0.7, "none", ""};
  for (int i = 0; i < 12; ++i) {
    const double theta = i * pi / 6.0;
    svg.line(at(innermost, theta), at(outer, theta), grid);
    if (i % 3 == 0) {
      const DrawingPoint p = at(outer + 14.0, theta);
      svg.text({p.x, p.y + 4.0}, i == 9 ? "−90°" : fmt::format("{}°", 30 * i),
               {TextAnchor::middle, 11.0});
    }
  }
  for (const AxisTick& tick : round_axis_ticks(std::min(plot.low, 0.0), plot.high, 3)) {
    if (tick.value != 0.0 && scale(tick.value) > innermost) {
      svg.circle(at(0.0, 0.0), scale(tick.value), grid);
    }
  }
}

/// Numbers stand on top of the curves, on a ray between the angles that are named.
void draw_numbers(SvgDrawing& svg, const PolarPlot& plot, const PolarScale& scale) {
  for (const AxisTick& tick : round_axis_ticks(std::min(plot.low, 0.0), plot.high, 3)) {
    if (scale(tick.value) > innermost + 6.0) {
      const DrawingPoint p = at(scale(tick.value), -0.75 * pi);
      svg.text({p.x, p.y + 3.5}, tick.text, {TextAnchor::middle, 10.0, "#333", 0.0, true});
    }
  }
}

/// A piece of the curve; of a tinted one the area between it and the bore too.
void draw_pieces(SvgDrawing& svg, const PolarPlot& plot, const PolarScale& scale,
                 const PolarCurve& curve, bool areas) {
  for (const std::vector<DrawingPoint>& piece : curve.pieces) {
    std::vector<DrawingPoint> points(piece.size());
    std::ranges::transform(piece, points.begin(), [&](const DrawingPoint& p) {
      return at(scale(std::clamp(p.y, plot.low, plot.high)), p.x);
    });
    if (!areas) {
      svg.polyline(points, {curve.colour, 1.5, "none", curve.dash});
    } else if (curve.tinted && piece.size() > 1) {
      for (auto p = piece.rbegin(); p != piece.rend(); ++p) {
        points.push_back(at(scale.bore, p->x));
      }
      svg.polygon(points, {"none", 0.0, curve.colour + "1c", ""});
    }
  }
}

PolarPlot polar_in_output_units(PolarPlot plot) {
  plot.low = plot.unit.from_deck(plot.low);
  plot.high = plot.unit.from_deck(plot.high);
  for (PolarCurve& curve : plot.curves) {
    for (std::vector<DrawingPoint>& piece : curve.pieces) {
      for (DrawingPoint& point : piece) {
        point.y = plot.unit.from_deck(point.y);
      }
    }
  }
  return plot;
}

} // namespace

namespace {

// With numbers in the units that are written.
std::string draw_written_polar_plot(const PolarPlot& plot) {
  const PolarScale scale = scale_of(plot);
  SvgDrawing svg(size, size + 8.0, plot.title);
  svg.title({0.5 * size, 14.0}, plot.title);
  draw_circles(svg, plot, scale);
  for (const double theta : plot.mouths) {
    svg.line(at(scale.bore, theta), at(outer + 5.0, theta), {"#000", 1.6, "none", ""});
  }
  for (const PolarCurve& curve : plot.curves) {
    draw_pieces(svg, plot, scale, curve, true);
    draw_pieces(svg, plot, scale, curve, false);
  }
  svg.circle(at(0.0, 0.0), scale.bore, {"#000", 1.0, "none", ""});
  draw_numbers(svg, plot, scale);
  svg.text(at(0.0, 0.0), plot.unit.name, {TextAnchor::middle, 10.0, "#333", 0.0, true});
  return svg.svg_text();
}

} // namespace

std::string draw_svg(const PolarPlot& plot) {
  return draw_written_polar_plot(polar_in_output_units(plot));
}

std::string draw_legend(const std::vector<PolarCurve>& curves) {
  constexpr double entry = 150.0;
  SvgDrawing svg(std::max(1.0, entry * static_cast<double>(curves.size())), 20.0, "legend");
  double x = 4.0;
  for (const PolarCurve& curve : curves) {
    svg.line({x, 10.0}, {x + 30.0, 10.0}, {curve.colour, 1.8, "none", curve.dash});
    svg.text({x + 37.0, 14.0}, curve.name, {});
    x += entry;
  }
  return svg.svg_text();
}

} // namespace spricka::report
