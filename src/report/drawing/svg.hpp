// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A small writer of SVG: what a report needs and no more. Lengths are CSS pixels, y runs down.
namespace spricka::report {

struct DrawingPoint {
  double x = 0.0;
  double y = 0.0;
};

/// How a line or an area is drawn; colours as SVG writes them.
struct ShapeStyle {
  std::string stroke = "#000";
  double width = 1.0;
  std::string fill = "none";
  std::string dash{}; ///< "6 3"; empty: solid
};

enum class TextAnchor { start, middle, end };

struct TextStyle {
  TextAnchor anchor = TextAnchor::start;
  double size = 12.0;
  std::string fill = "#000";
  double angle = 0.0; ///< [deg], about the point, against the clock
  bool halo = false;  ///< white edge, where text stands on lines
  bool bold = false;
};

enum class MarkerShape { circle, square, triangle, diamond, plus, cross };

/// Path data with coordinates rounded to a hundredth of a pixel.
class SvgPathData {
public:
  /// Begins a piece of the path at a point.
  SvgPathData& move(DrawingPoint p);
  /// A straight line from the last point on.
  SvgPathData& line(DrawingPoint p);
  /// A parabola from the last point on, by its control point.
  SvgPathData& quadratic(DrawingPoint control, DrawingPoint p);
  /// A circular arc from the last point on: the large or small one, in either direction on the
  /// screen.
  SvgPathData& arc(double radius, bool large, bool clockwise, DrawingPoint p);
  SvgPathData& close();
  [[nodiscard]] bool empty() const { return text_.empty(); }
  [[nodiscard]] const std::string& text() const { return text_; }

private:
  void point(DrawingPoint p);
  std::string text_;
};

/// One drawing. `label` says in words what it shows (for readers that do not see it).
class SvgDrawing {
public:
  SvgDrawing(double width, double height, std::string_view label);

  /// Draws a straight line between two points.
  void line(DrawingPoint a, DrawingPoint b, const ShapeStyle& style);
  /// Draws a path; nothing where it is empty.
  void path(const SvgPathData& data, const ShapeStyle& style);
  /// Draws straight lines from point to point, left open at the end.
  void polyline(std::span<const DrawingPoint> points, const ShapeStyle& style);
  /// Draws the closed line through the points, filled as the style says.
  void polygon(std::span<const DrawingPoint> corners, const ShapeStyle& style);
  /// Draws a circle by its centre and radius [px].
  void circle(DrawingPoint centre, double radius, const ShapeStyle& style);
  /// Draws a rectangle by its upper left corner, width and height [px].
  void rectangle(DrawingPoint corner, double width, double height, const ShapeStyle& style);
  /// Draws a marker of some seven pixels about a point.
  void marker(MarkerShape kind, DrawingPoint at, const ShapeStyle& style);
  /// Writes words at a point, anchored and turned as the style says.
  void text(DrawingPoint at, std::string_view words, const TextStyle& style);
  /// Writes the drawing's title, bold, with the middle of its foot at a point.
  void title(DrawingPoint at, std::string_view words);
  /// Until unclip() nothing shows outside the rectangle. `id` is unique on the page.
  void clip(std::string_view id, DrawingPoint corner, double width, double height);
  void unclip();
  /// Until end_group() all stands in a group with these attributes, which are HTML already.
  void begin_group(std::string_view attributes);
  void end_group();
  /// The whole element, readable alone and inside HTML.
  [[nodiscard]] std::string svg_text() const;

private:
  std::string body_;
};

/// The i-th colour of a palette that colour-blind readers can tell apart (Okabe and Ito, 2008);
/// starts again after seven.
std::string_view palette_colour(std::size_t i);

/// The i-th marker; starts again after four closed shapes.
MarkerShape palette_marker_shape(std::size_t i);

/// The i-th dash pattern; the first is solid.
std::string_view dash_pattern(std::size_t i);

/// Where an axis has a number, and the number.
struct AxisTick {
  double value = 0.0;
  std::string text;
};

/// Steps of 1, 2 or 5 times a power of ten: about `wanted` round numbers inside [low, high], with
/// the digits that the distance between them calls for.
std::vector<AxisTick> round_axis_ticks(double low, double high, int wanted);

/// 1, 2 or 5 times a power of ten: the largest such number not above a positive value.
double round_number_below(double value);

/// A tick's number with the digits that the distance between ticks calls for.
std::string tick_text(double value, double distance);

} // namespace spricka::report
