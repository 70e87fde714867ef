// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/new_surface.hpp"

namespace spricka::mesh {

/// What is wrong with a new surface: triangles that fold or look into the body, edges of a kind
/// that do not have as many triangles as they should. Empty if nothing is.
SurfaceFailure find_remeshed_surface_fault(const SurfaceGeometry& surface,
                                           const RemeshedSurface& made);

/// Normal of a curved triangle at the reference place r (not unit: twice the area of the plane
/// one).
base::Vec3 triangle_normal(const RemeshedSurface& made, const RemeshedTriangle& triangle,
                           const base::Vec2& r);

} // namespace spricka::mesh
