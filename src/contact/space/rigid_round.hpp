// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/space/facet_surface.hpp"
#include "contact/space/round.hpp"
#include "contact/space/surface_projection.hpp"
#include "model/contacts.hpp"

/// Rigid targets in space: planes, cylinders, cones and spheres without end, met exactly.
namespace spricka::contact {

/// The shape of a rigid target; `sense` is +1 where it is solid within (a shaft, a ball), -1 where
/// it is a bore or a socket; a plane is solid behind its normal, which looks at the body.
/// None of lines and arcs.
std::optional<AnalyticShape> rigid_target_shape(const model::RigidTarget& rigid);

/// What a triangle of the contact surface sees of a rigid target: all of it that looks at the
/// target from no farther than a fifth of the surface's extent, point by point. Normals are the
/// target's.
OppositePointsOfElement project_triangle_onto_rigid(const FacetSurface& contact,
                                                    const AnalyticShape& target,
                                                    const HatElement& triangle);

} // namespace spricka::contact
