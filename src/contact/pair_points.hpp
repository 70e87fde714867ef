// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/segment.hpp"
#include "contact/space/pair_point.hpp"

#include <optional>
#include <vector>

/// Where the surfaces of a pair face each other, as points to integrate over.
namespace spricka::contact {

/// In the plane: the stretches of contact edges that face the pair's target, in the order of the
/// edges.
std::vector<MortarSegment> find_mortar_segments(const PairConstraints& pair);

/// The gap from a point x to the rigid target of a pair [length], negative inside it; none beyond
/// the end of a line or at the centre of an arc.
std::optional<double> gap_to_rigid_target(const PairConstraints& pair, const Vec3& x);

/// With how many points an element is looked at.
enum class ProjectionPointDensity {
  integration, ///< all that is opposite, so that rows are integrated exactly
  sampling     ///< a few points, to tell largest ways; those that miss are left out
};

/// What the elements of a pair's contact surface meet of its target along their normals, or along
/// those of a rigid one. In the plane Gauss points of degree 9 on the stretches of segment.hpp, for
/// samples of degree 3; in space degree 5 on clipped triangles (surface_projection.hpp), or on
/// whole ones of crack faces, before rigid targets and for samples. The pair must outlive it.
ElementProjector
make_target_projector(const PairConstraints& pair,
                      ProjectionPointDensity rule = ProjectionPointDensity::integration);

} // namespace spricka::contact
