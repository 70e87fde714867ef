// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/new_surface.hpp"

/// The part of a body's surface that a cavity takes away, meshed anew where a crack comes out.
namespace spricka::mesh {

/// Meshes the region: rim edges stay, outlines and mouths are edges, feature edges inside are lines
/// of new edges. Each smooth piece is filled by gmsh in parameters: two coordinates of a plane, a
/// cylinder unrolled, other pieces by a least-squares conformal map (Levy et al. 2002). All points
/// and middles lie on the host's true faces.
RemeshedSurface remesh_surface(const SurfaceGeometry& surface, const SurfaceRegion& region);

} // namespace spricka::mesh
