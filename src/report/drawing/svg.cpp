// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/svg.hpp"

#include "report/drawing/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace spricka::report {
namespace {

/// At most two decimals, no trailing zeros: pictures of meshes have many coordinates, and whole
/// numbers are written faster.
std::string pixels(double value) {
  constexpr double most = 1e12; // its hundredths are still exact
  if (!(std::abs(value) < most)) {
    return fmt::format("{:.2f}", value);
  }
  const long long hundredths = std::llround(100.0 * value);
  const auto size = static_cast<unsigned long long>(std::abs(hundredths));
  std::string text = hundredths < 0 ? "-" : "";
  text += fmt::format_int(size / 100).str();
  if (const auto rest = static_cast<char>(size % 100); rest != 0) {
    text += {'.', static_cast<char>('0' + rest / 10)};
    if (rest % 10 != 0) {
      text += static_cast<char>('0' + rest % 10);
    }
  }
  return text;
}

std::string attributes(const ShapeStyle& style) {
  std::string out = fmt::format(R"( fill="{}" stroke="{}")", style.fill, style.stroke);
  if (style.stroke != "none") {
    out += fmt::format(R"( stroke-width="{}")", pixels(style.width));
  }
  if (!style.dash.empty()) {
    out += fmt::format(R"( stroke-dasharray="{}")", style.dash);
  }
  return out;
}

SvgPathData open_path(std::span<const DrawingPoint> points) {
  SvgPathData data;
  for (const DrawingPoint& p : points) {
    data.empty() ? data.move(p) : data.line(p);
  }
  return data;
}

SvgPathData marker_outline(DrawingPoint at, std::vector<DrawingPoint> corners) {
  for (DrawingPoint& p : corners) {
    p = {at.x + p.x, at.y + p.y};
  }
  return open_path(corners).close();
}

SvgPathData strokes(DrawingPoint at, double x, double y) {
  SvgPathData data;
  data.move({at.x - x, at.y - y}).line({at.x + x, at.y + y});
  return data.move({at.x - y, at.y + x}).line({at.x + y, at.y - x});
}

} // namespace

void SvgPathData::point(DrawingPoint p) {
  (text_ += pixels(p.x)) += ' ' + pixels(p.y);
}

SvgPathData& SvgPathData::move(DrawingPoint p) {
  text_ += 'M';
  point(p);
  return *this;
}

SvgPathData& SvgPathData::line(DrawingPoint p) {
  text_ += 'L';
  point(p);
  return *this;
}

SvgPathData& SvgPathData::quadratic(DrawingPoint control, DrawingPoint p) {
  text_ += 'Q';
  point(control);
  text_ += ' ';
  point(p);
  return *this;
}

SvgPathData& SvgPathData::arc(double radius, bool large, bool clockwise, DrawingPoint p) {
  text_ += fmt::format("A{0} {0} 0 {1:d} {2:d} ", pixels(radius), large, clockwise);
  point(p);
  return *this;
}

SvgPathData& SvgPathData::close() {
  text_ += 'Z';
  return *this;
}

SvgDrawing::SvgDrawing(double width, double height, std::string_view label)
    : body_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{2}\" "
                        "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
                        "font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" "
                        "stroke-linejoin=\"round\">\n",
                        pixels(width), pixels(height), escape_xml(label))) {}

void SvgDrawing::line(DrawingPoint a, DrawingPoint b, const ShapeStyle& style) {
  path(SvgPathData().move(a).line(b), style);
}

void SvgDrawing::path(const SvgPathData& data, const ShapeStyle& style) {
  if (!data.empty()) {
    body_ += fmt::format("<path d=\"{}\"{}/>\n", data.text(), attributes(style));
  }
}

void SvgDrawing::polyline(std::span<const DrawingPoint> points, const ShapeStyle& style) {
  path(open_path(points), style);
}

void SvgDrawing::polygon(std::span<const DrawingPoint> corners, const ShapeStyle& style) {
  SvgPathData data = open_path(corners);
  path(data.empty() ? data : data.close(), style);
}

void SvgDrawing::title(DrawingPoint at, std::string_view words) {
  text(at, words, {.anchor = TextAnchor::middle, .size = 13.0, .bold = true});
}

void SvgDrawing::circle(DrawingPoint centre, double radius, const ShapeStyle& style) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", pixels(centre.x),
                       pixels(centre.y), pixels(radius), attributes(style));
}

void SvgDrawing::rectangle(DrawingPoint corner, double width, double height,
                           const ShapeStyle& style) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>\n", pixels(corner.x),
                       pixels(corner.y), pixels(width), pixels(height), attributes(style));
}

void SvgDrawing::marker(MarkerShape kind, DrawingPoint at, const ShapeStyle& style) {
  switch (kind) {
  case MarkerShape::circle:
    circle(at, 3.5, style);
    break;
  case MarkerShape::square:
    rectangle({at.x - 3.2, at.y - 3.2}, 6.4, 6.4, style);
    break;
  case MarkerShape::triangle:
    path(marker_outline(at, {{0.0, -4.4}, {4.0, 2.8}, {-4.0, 2.8}}), style);
    break;
  case MarkerShape::diamond:
    path(marker_outline(at, {{0.0, -4.6}, {4.6, 0.0}, {0.0, 4.6}, {-4.6, 0.0}}), style);
    break;
  case MarkerShape::plus:
    path(strokes(at, 5.0, 0.0), style);
    break;
  case MarkerShape::cross:
    path(strokes(at, 4.0, 4.0), style);
    break;
  }
}

void SvgDrawing::text(DrawingPoint at, std::string_view words, const TextStyle& style) {
  constexpr std::array<const char*, 3> anchor{"start", "middle", "end"};
  body_ += fmt::format(R"(<text x="{}" y="{}" font-size="{}" fill="{}" text-anchor="{}")",
                       pixels(at.x), pixels(at.y), pixels(style.size), style.fill,
                       anchor[static_cast<std::size_t>(style.anchor)]);
  if (style.angle != 0.0) {
    body_ += fmt::format(" transform=\"rotate({} {} {})\"", pixels(-style.angle), pixels(at.x),
                         pixels(at.y));
  }
  if (style.halo) {
    body_ += R"( stroke="#fff" stroke-width="3" paint-order="stroke")";
  }
  if (style.bold) {
    body_ += R"( font-weight="bold")";
  }
  ((body_ += '>') += escape_xml(words)) += "</text>\n";
}

void SvgDrawing::clip(std::string_view id, DrawingPoint corner, double width, double height) {
  body_ += fmt::format("<clipPath id=\"{0}\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" "
                       "height=\"{4}\"/></clipPath>\n<g clip-path=\"url(#{0})\">\n",
                       id, pixels(corner.x), pixels(corner.y), pixels(width), pixels(height));
}

void SvgDrawing::unclip() {
  end_group();
}

void SvgDrawing::begin_group(std::string_view attributes) {
  ((body_ += "<g ") += attributes) += ">\n";
}

void SvgDrawing::end_group() {
  body_ += "</g>\n";
}

std::string SvgDrawing::svg_text() const {
  return body_ + "</svg>\n";
}

std::string_view palette_colour(std::size_t i) {
  // Blue, vermilion, green, purple, orange, sky blue, black: outlines are black too.
  constexpr std::array<std::string_view, 7> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                    "#e69f00", "#56b4e9", "#000000"};
  return palette[i % palette.size()];
}

MarkerShape palette_marker_shape(std::size_t i) {
  constexpr std::array<MarkerShape, 4> shapes{MarkerShape::circle, MarkerShape::square,
                                              MarkerShape::triangle, MarkerShape::diamond};
  return shapes[i % shapes.size()];
}

std::string_view dash_pattern(std::size_t i) {
  constexpr std::array<std::string_view, 4> patterns{"", "7 3", "2 2.5", "7 3 2 3"};
  return patterns[i % patterns.size()];
}

std::string tick_text(double value, double distance) {
  const double size = std::max(std::abs(value), distance);
  if (size >= 1e6 || size < 1e-4) {
    return fmt::format("{:.3g}", value);
  }
  const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(distance) + 1e-9)));
  return fmt::format("{:.{}f}", value, digits);
}

std::vector<AxisTick> round_axis_ticks(double low, double high, int wanted) {
  if (!(high > low) || !std::isfinite(high - low)) {
    return {{low, tick_text(low, 1.0)}};
  }
  const double raw = (high - low) / wanted;
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  const double lead = raw / decade;
  double step = 10.0 * decade;
  for (const auto& [limit, factor] : {std::pair(7.0, 5.0), {3.5, 2.0}, {1.5, 1.0}}) {
    step = lead < limit ? factor * decade : step;
  }
  std::vector<AxisTick> ticks;
  const auto first = static_cast<long>(std::ceil(low / step - 1e-9));
  const auto last = static_cast<long>(std::floor(high / step + 1e-9));
  for (long i = first; i <= last; ++i) {
    const double value = static_cast<double>(i) * step;
    ticks.push_back({value, tick_text(value, last > first ? step : 1.0)});
  }
  return ticks;
}

double round_number_below(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  const double lead = value / decade;
  if (lead >= 5.0) {
    return 5.0 * decade;
  }
  return lead >= 2.0 ? 2.0 * decade : decade;
}

} // namespace spricka::report
