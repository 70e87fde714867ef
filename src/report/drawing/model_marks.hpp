// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/picture_frame.hpp"
#include "report/drawing/svg.hpp"

#include <functional>
#include <string>

namespace spricka::report {

/// Where marks of a model are drawn.
struct MarkWindow {
  PictureViewpoint eye; ///< of a plane model the default
  /// Where what the eye sees stands in the drawing.
  std::function<DrawingPoint(const DrawingPoint&)> project;
  /// Whether there is a mark at a place, on a face with this outer normal or zero at a node; empty:
  /// at all.
  std::function<bool(const base::Vec3& x, const base::Vec3& normal)> is_marked = {};
};

/// Draws onto a model what acts on it: in the plane contact surfaces as coloured lines, held nodes
/// as triangles that point along the axes, loads as arrows of one length for the largest value of
/// each load, temperatures as dots.
void draw_model_marks(SvgDrawing& svg, const model::Model& model, const MarkWindow& window);

/// What these marks mean, as a drawing of its own; empty where there is none of them.
std::string model_marks_legend(const model::Model& model, double width);

} // namespace spricka::report
