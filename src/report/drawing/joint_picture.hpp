// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/body_surface.hpp"
#include "report/drawing/measure_title.hpp"
#include "results/results.hpp"

#include <string>
#include <utility>
#include <vector>

namespace spricka::report {

/// Solids with their cracks, shaded, as they stand before they are loaded.
struct JointView {
  const results::CrackLengthResult* increment = nullptr;
  const results::LoadStepResult* step = nullptr;   ///< whose K colours the fronts
  std::vector<const results::FrontResult*> fronts; ///< to be drawn
  /// Of the net of the first front what lies near it; false: all there is.
  bool is_close = false;
  const model::Model* marks = nullptr; ///< its supports and loads are shown; null: none
  std::vector<std::pair<base::Vec3, std::string>> labels;
  std::string id; ///< unique on the page
  std::string title;
  MeasureTitle k_title; ///< of its colours
  double width = 420.0; ///< [px]
};

/// The picture: facets shaded by their normals, kinks as lines, faces of cracks and their fronts,
/// which show through the body, coloured by K1, the axes of coordinates. The eye stands where the
/// mouth of the first crack is seen. Empty where the surface is not known or too large.
std::string draw_svg(const JointView& view);

} // namespace spricka::report
