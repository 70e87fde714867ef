// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/body_surface.hpp"
#include "report/drawing/measure_title.hpp"
#include "results/results.hpp"

#include <functional>
#include <string>

namespace spricka::report {

/// The outer surface of a solid mesh, seen from x, -y and z, deformed, coloured by stresses.
struct SolidView {
  const results::CrackLengthResult* increment = nullptr;
  const results::LoadStepResult* step = nullptr;
  std::function<double(const results::Stress&)> value; ///< what is shown of them [stress]
  std::string title;                                   ///< "Surface, von Mises stress"
  MeasureTitle field_title;                            ///< "von Mises, MPa"
  double width = 560.0;                                ///< [px]
};

/// The picture as SVG, faces painted from the back to the front, with colour legend and axes. Its
/// colours leave out the highest hundredth of what is seen, and the lowest where stresses may be
/// negative: the tip of a crack would have them all for itself.
std::string draw_svg(const SolidView& view);

} // namespace spricka::report
