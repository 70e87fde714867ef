// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "shape/shape.hpp"
#include "shape/solid.hpp"
#include "shape/topology.hpp"

namespace spricka::shape {

/// A place r of a side of a solid in the reference coordinates of the element, in which sides are
/// flat: their corners are enough.
template <ElementShape S> Point<3> place_on_solid(int side, const Point<2>& r) {
  const std::span<const int> local = side_nodes(S::type, side);
  Point<3> place = Point<3>::Zero();
  const auto add = [&](const auto& N) {
    for (Eigen::Index k = 0; k < N.size(); ++k) {
      const auto node = static_cast<std::size_t>(local[static_cast<std::size_t>(k)]);
      place += N[k] * Eigen::Map<const Point<3>>(S::coordinates[node].data());
    }
  };
  if (side_corners(S::type, side) == 3) {
    add(Trim3::N(r));
  } else {
    add(Quam4::N(r));
  }
  return place;
}

} // namespace spricka::shape
