// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "shape/reference_element.hpp"
#include "shape/topology.hpp"

namespace spricka::shape {

/// A place r of a side of a solid in the reference coordinates of the element, in which sides are
/// flat: their corners are enough.
inline Point<3> side_to_solid_point(base::ElementType type, int side, const Point<2>& r) {
  const ReferenceElement<3>& element = reference_element<3>(type);
  const std::span<const int> local = side_nodes(type, side);
  const ReferenceElement<2>::Values N =
      reference_element<2>(solid_side_type(type, side)).linear_element().N(r);
  Point<3> place = Point<3>::Zero();
  for (Eigen::Index k = 0; k < N.size(); ++k) {
    place += N[k] * element.node_local_coordinates(local[static_cast<std::size_t>(k)]);
  }
  return place;
}

} // namespace spricka::shape
