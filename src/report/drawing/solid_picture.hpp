// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <cstddef>
#include <string>

namespace spricka::report {

/// So many faces are drawn at most: more make a page that is slow to show and no clearer.
inline constexpr std::size_t most_drawn_faces = 20000;

/// The outer surface of a solid mesh, seen from x, -y and z, deformed, coloured by von Mises.
struct SolidView {
  const results::CrackLengthResult* increment = nullptr;
  const results::LoadStepResult* step = nullptr;
  std::string stress_name;
  double width = 560.0; ///< [px]
};

/// The picture as SVG, faces painted from the back to the front, with colour legend and axes.
std::string draw_svg(const SolidView& view);

} // namespace spricka::report
