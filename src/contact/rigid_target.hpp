// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/segment.hpp"
#include "contact/surface.hpp"
#include "model/forward.hpp"

#include <optional>
#include <vector>

/// Rigid targets in the plane: lines between two points and whole circles, met exactly.
namespace spricka::contact {

/// Where a point of a body stands to a rigid target.
struct RigidProjection {
  double gap = 0.0;           ///< distance, negative inside the target [length]
  Vec2 normal = Vec2::Zero(); ///< unit, towards the target: a motion u closes the gap by normal . u
  Vec2 point = Vec2::Zero();  ///< the target's nearest point
  bool beyond = false;        ///< of an end of a line: nothing is there
};

/// The target's nearest point; none at the centre of an arc.
std::optional<RigidProjection> normal_projection(const model::RigidTarget& rigid, const Vec2& x);

/// The stretches of contact edges that face the target, in the order of the edges, cut exactly at
/// the ends of a line and in the middle of quadratic edges; target_edge is 0. What looks away from
/// the target or lies farther off than a fifth of the surface's extent does not count.
std::vector<MortarSegment> find_mortar_segments(const ContactSurface& contact,
                                                const model::RigidTarget& rigid);

} // namespace spricka::contact
