// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/beach_marks.hpp"

#include "report/drawing/picture_frame.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::report {

namespace {

constexpr double marks_margin = 18.0;
constexpr double marks_label_width = 90.0; // right of the marks
constexpr double marks_title_height = 24.0;
constexpr double marks_scale_height = 30.0;
constexpr double marks_tallest = 1.2; // of the width
constexpr double marks_text_line = 14.0;

} // namespace

std::string draw_svg(const BeachMarkView& view) {
  const PictureViewpoint flat{.right = view.right, .up = view.up};
  PictureBox box;
  for (const BeachMark& mark : view.marks) {
    for (const std::vector<base::Vec3>& front : mark.fronts) {
      std::ranges::for_each(front, [&](const base::Vec3& x) { box.add(flat(x)); });
    }
  }
  const double across = box.width();
  const double high = box.height();
  if (!(across > 0.0 || high > 0.0)) {
    return {};
  }
  const double room = view.width - 2.0 * marks_margin - marks_label_width;
  const double scale = std::min(room / std::max(across, 1e-9 * high),
                                marks_tallest * room / std::max(high, 1e-9 * across));
  const double top = marks_title_height + marks_margin;
  SvgDrawing svg(view.width, top + scale * high + marks_margin + marks_scale_height, view.title);
  const auto pixel = [&](const base::Vec3& x) {
    const DrawingPoint p = flat(x);
    return DrawingPoint{marks_margin + scale * (p.x - box.low.x), top + scale * (box.high.y - p.y)};
  };
  svg.text({marks_margin, 16.0}, view.title, TextStyle{.bold = true});
  std::vector<DrawingPoint> rightmost; // [mark]
  for (std::size_t k = 0; k < view.marks.size(); ++k) {
    const bool border = k == 0 || k + 1 == view.marks.size();
    DrawingPoint last{-1.0, 0.0};
    for (const std::vector<base::Vec3>& front : view.marks[k].fronts) {
      std::vector<DrawingPoint> points;
      std::ranges::transform(front, std::back_inserter(points), pixel);
      svg.polyline(points, {std::string(palette_colour(border ? 1 : 0)), border ? 2.0 : 1.0});
      for (const DrawingPoint& p : points) {
        last = p.x > last.x ? p : last;
      }
    }
    rightmost.push_back(last);
  }
  // Beside the place of a mark that is farthest to the right, the last mark's before all others.
  std::vector<double> reported;
  for (std::size_t k = view.marks.size(); k-- > 0;) {
    const DrawingPoint& at = rightmost[k];
    const bool free = std::ranges::all_of(
        reported, [&](double y) { return std::abs(y - at.y) > marks_text_line; });
    if (free && at.x >= 0.0) {
      svg.text({at.x + 5.0, at.y + 4.0}, fmt::format("N = {:.5g}", view.marks[k].cycles),
               TextStyle{.size = 11.0, .halo = true});
      reported.push_back(at.y);
    }
  }
  const double shown = round_number_below(view.length.from_deck(0.4 * std::max(across, high)));
  const double bar = view.length.to_deck(shown);
  const double y = top + scale * high + marks_margin + 8.0;
  svg.line({marks_margin, y}, {marks_margin + scale * bar, y}, ShapeStyle{.width = 2.0});
  svg.text({marks_margin + scale * bar + 6.0, y + 4.0},
           fmt::format("{:.6g} {}", shown, view.length.name), TextStyle{});
  return svg.svg_text();
}

} // namespace spricka::report
