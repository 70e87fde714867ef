// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/svg.hpp"

#include <string_view>
#include <vector>

namespace spricka::report {

/// About how wide words are in a drawing [px]; rather too much than too little.
double text_width(std::string_view words, const TextStyle& style);

/// Writes words beside points of a drawing where they cover neither each other nor what is kept
/// free.
class LabelPlacer {
public:
  /// Words stand between these corners of the drawing: upper left, lower right [px].
  LabelPlacer(DrawingPoint first, DrawingPoint last) : first_(first), last_(last) {}

  /// Nothing is written over this rectangle.
  void keep_free(DrawingPoint corner, double width, double height);
  /// Writes words as near to a point as there is room, with a thin line to it where that is not
  /// beside it; where there is none anywhere, nothing. The style's anchor is chosen here.
  void write(SvgDrawing& svg, DrawingPoint at, std::string_view words, TextStyle style);

private:
  struct Taken {
    DrawingPoint low, high;
  };
  [[nodiscard]] bool is_free(const Taken& place) const;

  DrawingPoint first_, last_;
  std::vector<Taken> taken_;
};

} // namespace spricka::report
