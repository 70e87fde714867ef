// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/element_outline.hpp"

#include "shape/topology.hpp"

#include <cmath>

namespace spricka::fe {

std::vector<base::Vec2> element_outline(const model::Mesh& mesh, base::ElementId e) {
  using base::Vec2;
  constexpr int pieces_of_curve = 16;
  constexpr double straight = 1e-12; // bulge of a side over its length
  std::vector<Vec2> result;
  const auto nodes = mesh.element_nodes(e);
  for (int s = 0; s < base::element_info(mesh.type[e.index()]).sides; ++s) {
    const auto side = shape::side_nodes(mesh.type[e.index()], s); // ends, then the middle
    const auto x = [&](std::size_t k) -> Vec2 {
      return mesh.x[nodes[static_cast<std::size_t>(side[k])].index()].head<2>();
    };
    const Vec2 a = x(0);
    const Vec2 chord = x(1) - a;
    const Vec2 bow = side.size() > 2 ? Vec2(x(2) - a) : Vec2(0.5 * chord);
    const bool curved = std::abs(base::cross(chord, bow)) > straight * chord.squaredNorm();
    for (int k = 0; k < (curved ? pieces_of_curve : 1); ++k) {
      const double t = k / double(pieces_of_curve);
      // The parabola through both ends and the middle.
      result.emplace_back(a + t * (2.0 * t - 1.0) * chord + 4.0 * t * (1.0 - t) * bow);
    }
  }
  return result;
}

} // namespace spricka::fe
