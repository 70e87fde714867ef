// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/rigid_picture.hpp"
#include "report/drawing/svg.hpp"

#include <string>

namespace spricka::report {

/// Draws onto a plane mesh what acts on it: contact surfaces as coloured lines, held nodes as
/// triangles and dots, loads as arrows of one length for the largest value of each load.
void draw_model_marks(SvgDrawing& svg, const model::Model& model, const DrawingWindow& window);

/// What these marks mean, as a drawing of its own; empty where there is none of them.
std::string model_marks_legend(const model::Model& model, double width);

} // namespace spricka::report
