// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/space/opposite.hpp"
#include "contact/surface.hpp"

#include <optional>
#include <vector>

/// Mortar segments in the plane: the stretches of contact edges that face one target edge each.
namespace spricka::contact {

/// A circle about an edge, to leave out at once what is too far off.
struct EdgeBoundingCircle {
  Vec2 centre;
  double radius = 0.0;
};
EdgeBoundingCircle bounding_circle(const Edge& edge);

/// Stretches shorter than this in xi carry nothing.
inline constexpr double shortest_interval = 1e-10;

struct MortarSegment {
  std::size_t contact_edge = 0; ///< among all edges of the contact surface, chain by chain
  std::size_t target_edge = 0;
  double from = -1.0, to = 1.0; ///< xi on the contact edge; never crosses a node of the half edges
};

/// xi on `edge` (extended a little beyond its ends) at which `point` lies on the surface normal.
std::optional<double> normal_projection(const ContactSurface& surface, const Edge& edge,
                                        const Vec2& point);

/// eta on the target edge that the ray from `x` along `normal` meets; may lie outside [-1, 1].
std::optional<double> ray_intersection(const Edge& target, const Vec2& x, const Vec2& normal);

/// All segments, in the order of the contact edges. Target edges that look the same way, or lie
/// further off than a fifth of the contact surface's extent, do not count.
std::vector<MortarSegment> find_mortar_segments(const ContactSurface& contact,
                                                const ContactSurface& target);

} // namespace spricka::contact
