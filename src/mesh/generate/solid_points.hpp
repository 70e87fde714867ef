// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "shape/topology.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <span>

namespace spricka::mesh {

/// The points of a solid element with these corners, in the order of its nodes: corners, then as
/// far as the type has them the middles of edges, of sides and of the element. `middle` gives the
/// point halfway between two corners; the first `nodes` of the type are filled.
template <class Point, class Middle>
std::array<Point, 27> solid_element_points(base::ElementType type, std::span<const Point> corner,
                                           const Middle& middle) {
  const base::ElementInfo& info = base::element_info(type);
  const auto between = [&](int a, int b) {
    return middle(corner[static_cast<std::size_t>(a)], corner[static_cast<std::size_t>(b)]);
  };
  std::array<Point, 27> points;
  std::copy(corner.begin(), corner.end(), points.begin());
  std::size_t n = corner.size();
  if (info.quadratic) {
    for (int m = 0; m < shape::edge_count(type); ++m) {
      const auto [a, b] = shape::edge_corners(type, m);
      points[n++] = between(a, b);
    }
  }
  if (type == base::ElementType::hexec27) {
    for (int s = 0; s < info.sides; ++s) {
      const auto local = shape::side_nodes(type, s);
      points[n++] = between(local[0], local[2]);
    }
    points[n++] = between(0, 6);
  }
  assert(n == static_cast<std::size_t>(info.nodes));
  return points;
}

} // namespace spricka::mesh
