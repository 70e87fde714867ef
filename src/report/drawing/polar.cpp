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
  const std::vector<double> ticks = round_ticks(std::min(plot.low, 0.0), plot.high, 3);
  for (const double t : ticks) {
    if (t != 0.0 && scale(t) > innermost) {
      svg.circle(at(0.0, 0.0), scale(t), grid);
    }
  }
}

/// Numbers stand on top of the curves, on a ray between the angles that are named.
void draw_numbers(SvgDrawing& svg, const PolarPlot& plot, const PolarScale& scale) {
  const std::vector<double> ticks = round_ticks(std::min(plot.low, 0.0), plot.high, 3);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  for (const double t : ticks) {
    if (scale(t) > innermost + 6.0) {
      const DrawingPoint p = at(scale(t), -0.75 * pi);
      svg.text({p.x, p.y + 3.5}, tick_text(t, step), {TextAnchor::middle, 10.0, "#333", 0.0, true});
    }
  }
}

DrawingPoint on_curve(const PolarPlot& plot, const PolarScale& scale, const DrawingPoint& p) {
  return at(scale(std::clamp(p.y, plot.low, plot.high)), p.x);
}

/// The area between a piece of the curve and the bore.
SvgPathData area(const PolarPlot& plot, const PolarScale& scale,
                 const std::vector<DrawingPoint>& piece) {
  SvgPathData data;
  for (const DrawingPoint& p : piece) {
    const DrawingPoint q = on_curve(plot, scale, p);
    data.empty() ? data.move(q) : data.line(q);
  }
  for (auto p = piece.rbegin(); p != piece.rend(); ++p) {
    data.line(at(scale.bore, p->x));
  }
  return data.close();
}

void draw_curve(SvgDrawing& svg, const PolarPlot& plot, const PolarScale& scale,
                const PolarCurve& curve) {
  for (const std::vector<DrawingPoint>& piece : curve.pieces) {
    if (curve.tinted && piece.size() > 1) {
      svg.path(area(plot, scale, piece), {"none", 0.0, curve.colour + "1c", ""});
    }
  }
  for (const std::vector<DrawingPoint>& piece : curve.pieces) {
    std::vector<DrawingPoint> points(piece.size());
    std::transform(piece.begin(), piece.end(), points.begin(),
                   [&](const DrawingPoint& p) { return on_curve(plot, scale, p); });
    svg.polyline(points, {curve.colour, 1.5, "none", curve.dash});
  }
}

} // namespace

std::string draw_svg(const PolarPlot& plot) {
  const PolarScale scale = scale_of(plot);
  SvgDrawing svg(size, size + 8.0, plot.title);
  svg.text({0.5 * size, 14.0}, plot.title, {TextAnchor::middle, 13.0, "#000", 0.0, false, true});
  draw_circles(svg, plot, scale);
  for (const double theta : plot.mouths) {
    svg.line(at(scale.bore, theta), at(outer + 5.0, theta), {"#000", 1.6, "none", ""});
  }
  for (const PolarCurve& curve : plot.curves) {
    draw_curve(svg, plot, scale, curve);
  }
  svg.circle(at(0.0, 0.0), scale.bore, {"#000", 1.0, "none", ""});
  draw_numbers(svg, plot, scale);
  svg.text(at(0.0, 0.0), plot.unit, {TextAnchor::middle, 10.0, "#333", 0.0, true});
  return svg.svg_text();
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
