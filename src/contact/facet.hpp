// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "geometry/element_side.hpp"

#include <array>

/// Functions of the pressure on a facet, which is a side of an element.
namespace spricka::contact {

using base::Vec2;

/// One number for each node of an edge; those behind its last node are zero.
using FacetValues = std::array<double, 3>;

/// Hats on half edges: piecewise linear, non-negative, sum 1; edges of two and three nodes.
/// Pressures of SEGMENT pairs are sums of these.
FacetValues facet_hats(const geometry::ElementSide& facet, const Vec2& r);

/// The same by the number of nodes on a line.
FacetValues line_hats(int count, double xi);

} // namespace spricka::contact
