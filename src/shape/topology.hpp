// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace spricka::shape {

/// Local node numbers of side `s` of an element: corners first in the order that leaves the body
/// on the left (2D) or has the outer normal by the right-hand rule (3D), then mid nodes.
/// 2D sides: edge s joins corners s and s+1.
std::span<const int> side_nodes(base::ElementType type, int s);

/// What a side is: a line, a triangle or a quadrilateral.
base::ReferenceDomain side_domain(base::ElementType type, int s);

/// The plane shape of side `s` of a solid: TRIM3, TRIMC6, QUAM4, QUAMC8 or QUAMC9. A pentahedron
/// has triangles (sides 0, 1) and quadrilaterals.
base::ElementType solid_side_type(base::ElementType type, int s);

/// How many nodes of a side are corners: 2 in the plane, 3 or 4 in space.
std::size_t side_corner_count(base::ElementType type, int s);
/// Whether a side is an edge of a plane element, not a face of a solid.
inline bool is_plane_element_side(base::ElementType type, int s) {
  return side_corner_count(type, s) == 2;
}

/// Corners that edge `m` of an element joins; its mid node, if the element has one, is corners + m.
std::array<int, 2> edge_corners(base::ElementType type, int m);

/// Number of edges: as many as mid-edge nodes in the quadratic element of the family.
int edge_count(base::ElementType type);

/// How many edges a side has: a line is one, faces have as many as corners.
std::size_t side_edge_count(base::ElementType type, int s);

} // namespace spricka::shape
