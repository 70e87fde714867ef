// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/svg.hpp"

#include <functional>

namespace spricka::report {

/// What a drawing shows of the plane: its corners [length], the pixels of a length, and where a
/// point stands on the drawing.
struct DrawingWindow {
  DrawingPoint low;
  DrawingPoint high;
  double scale = 1.0; ///< [px/length]
  std::function<DrawingPoint(const DrawingPoint&)> project;
};

/// Draws a rigid target as a heavy line with hatches on the side of the rigid body, as far as the
/// window shows it.
void draw_rigid_target(SvgDrawing& svg, const model::RigidTarget& rigid,
                       const DrawingWindow& window);

} // namespace spricka::report
