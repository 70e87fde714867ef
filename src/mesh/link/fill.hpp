// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/link/grading.hpp"
#include "mesh/link/region.hpp"

namespace spricka::mesh {

/// Fills a region with triangles by gmsh; with `trouble` there are none.
TriangleFill fill_triangles(const PlaneRegion& region, const Grading& size);

/// Fills a region with tetrahedra by gmsh; with `trouble` there are none. Every triangle of a
/// boundary is the side of one of them, every embedded one that of two.
TetrahedronFill fill_tetrahedra(const SolidRegion& region, const SolidGrading& size);

/// What the mesher makes of a region as it is, for these two.
template <int dim>
MeshFill<dim> request_mesh_fill(const FillRegion<dim>& region, const SizeGrading<dim>& size);

} // namespace spricka::mesh
